# SPDX-License-Identifier: MIT
import tempfile
import unittest
from pathlib import Path

from kiosk import soak_report
from kiosk.soak_report import Visit

_HEAD = "number,start,duration_s,language,mode,content,reached,stations,least_fps,late_frames,resets,end"


def _line(text: str) -> str:
    return f"2026-01-02 10:00:00 {text}"


def _visits(*ends: str) -> list[Visit]:
    return [Visit(i + 1, "visit", end) for i, end in enumerate(ends)]


class Visits(unittest.TestCase):
    def test_of_rotated_logs(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            log = Path(folder) / "visits.csv"
            for name, numbers in (("visits.csv.10", (1,)), ("visits.csv.2", (2,)), ("visits.csv.1", (3, 4)), ("visits.csv", (5,))):
                rows = [f"{number},2026-01-02T10:00:00,30,de,screen,tour,visit,3,30,0,0,idle" for number in numbers]
                (Path(folder) / name).write_text("\n".join([_HEAD, *rows]) + "\n", encoding="utf-8")
            visits = soak_report.read_visits(log)
        self.assertEqual([visit.number for visit in visits], [1, 2, 3, 4, 5])
        self.assertEqual(visits[0], Visit(1, "visit", "idle"))
        self.assertEqual(soak_report.wrong_visits(visits, 5, 0), [])

    def test_gaps_doubles_few_and_cut(self) -> None:
        fine = _visits("idle", "cut", "time")
        self.assertEqual(soak_report.wrong_visits(fine, 3, 1), [])
        self.assertIn("cut", soak_report.wrong_visits(fine, 3, 0)[0])
        self.assertIn("only 3", soak_report.wrong_visits(fine, 4, 1)[0])
        for broken in ([fine[0], fine[2]], [fine[0], fine[0], fine[1]]):
            self.assertIn("numbered", soak_report.wrong_visits(broken, 0, 9)[0])


class Order(unittest.TestCase):
    def _wrong(self, *texts: str) -> list[str]:
        return soak_report.wrong_order([_line(text) for text in texts])

    def test_as_it_should_be(self) -> None:
        visit = ["visit 1 begins: button", "state language", "visit ends: 1,2026", "state ending", "state attract", "ready"]
        self.assertEqual(self._wrong("start, version 1", *visit, "visit 2 begins: button", "start, version 1",
                                     "visit 3 begins: gaze", "visit ends: 3,2026", "state attract"), [])

    def test_what_is_wrong(self) -> None:
        for texts in (
            ("visit 1 begins: button", "state attract"),
            ("visit 1 begins: button", "visit 2 begins: button"),
            ("visit 1 begins: button", "visit ends: 1,2026", "visit 2 begins: button"),
            ("visit ends: 1,2026",),
        ):
            with self.subTest(texts):
                self.assertEqual(len(self._wrong(*texts)), 1)


class Memory(unittest.TestCase):
    def test_slope(self) -> None:
        self.assertEqual(soak_report.slope([]), 0.0)
        self.assertEqual(soak_report.slope([(1.0, 5.0), (1.0, 7.0)]), 0.0)
        self.assertAlmostEqual(soak_report.slope([(t, 300.0 + t / 30.0) for t in range(100)]), 2.0)

    def test_usual_growth(self) -> None:
        self.assertEqual(soak_report.usual_growth([(0.0, 5.0), (59.0, 50.0)]), 0.0)
        self.assertAlmostEqual(soak_report.usual_growth([(t, 300.0 + t / 30.0) for t in range(601)]), 2.0)
        one_step = [(t, 324.0 if t > 400 else 300.0) for t in range(601)]
        self.assertEqual(soak_report.usual_growth(one_step), 0.0)


if __name__ == "__main__":
    unittest.main()
