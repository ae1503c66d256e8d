# SPDX-License-Identifier: MIT
import contextlib
import io
import unittest

from setup.console import Pace, Progress


class Counter(unittest.TestCase):
    def test_a_line_per_tenth_where_there_is_no_terminal(self) -> None:
        with contextlib.redirect_stderr(io.StringIO()) as printed:
            progress = Progress("frame")
            for done in range(1, 41):
                progress.update(done, 40, f"remark {done}")
            progress.close()
        lines = printed.getvalue().splitlines()
        self.assertEqual(len(lines), 11)
        self.assertEqual(lines[0], "    frame 1/40, remark 1")
        self.assertEqual(lines[-1], "    frame 40/40, remark 40")

    def test_without_a_remark(self) -> None:
        with contextlib.redirect_stderr(io.StringIO()) as printed:
            Progress("piece", 3).update(1)
        self.assertEqual(printed.getvalue(), "    piece 1/3\n")


class Speed(unittest.TestCase):
    def test_pieces_per_second_and_time_left(self) -> None:
        times = iter([100.0, 102.0, 110.0, 500.0, 501.0])
        pace = Pace("frames", lambda: next(times))
        self.assertEqual(pace.words(1, 251), "")
        self.assertEqual(pace.words(6, 251), "2.5 frames/s, 1:38 min left")
        self.assertEqual(pace.words(251, 251), "25.0 frames/s, 0:00 min left")
        # The next sequence starts anew.
        self.assertEqual(pace.words(1, 9), "")
        self.assertEqual(pace.words(2, 9), "1.0 frames/s, 0:07 min left")
