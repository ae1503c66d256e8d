# SPDX-License-Identifier: MIT
"""Tests of ./run fuzz: its command line, and what it makes of the fuzzers' output."""

from __future__ import annotations

import contextlib
import io
import tempfile
import unittest
from pathlib import Path

from setup import fuzz, fuzz_capture_list, fuzz_targets, paths
from setup.console import Failure
from setup.fuzz_targets import TARGETS, Target

CPP = fuzz_targets.find("star_csv")
SCRIPT = fuzz_targets.find("shot")
LIBFUZZER = """INFO: Seed: 7
#2 INITED cov: 812 ft: 2000 corp: 6/400b exec/s: 0 rss: 80Mb
#18829 DONE   cov: 839 ft: 3108 corp: 440/20Kb lim: 4096 exec/s: 855 rss: 129Mb
stat::number_of_executed_units: 18829
"""
SCRIPT_SAID = "fuzz shot: seed 7\nfuzz shot: 282 executions, 66 kinds of answer, 65 accepted, 0 findings\n"


class CommandLine(unittest.TestCase):
    """What is asked for."""

    def test_all_for_ten_minutes(self) -> None:
        wish = fuzz.parse([])
        self.assertEqual(wish.targets, list(TARGETS))
        self.assertEqual(wish.minutes, 10.0)
        self.assertGreater(wish.seed, 0)

    def test_some_for_longer(self) -> None:
        wish = fuzz.parse(["shot", "--minutes", "0.5", "star_csv", "--seed", "42"])
        self.assertEqual([target.name for target in wish.targets], ["shot", "star_csv"])
        self.assertEqual((wish.minutes, wish.seed), (0.5, 42))

    def test_wrong_ones_are_told_what_there_is(self) -> None:
        for wrong in (["nothing"], ["--minutes"], ["--minutes", "x"], ["--minutes", "0"], ["--seed", "-1"],
                      ["--minutes", "nan"]):
            with self.subTest(wrong), self.assertRaises(Failure) as raised:
                fuzz.parse(wrong)
            self.assertIn("star_csv", str(raised.exception))
            self.assertEqual(raised.exception.code, 2)


class Reports(unittest.TestCase):
    """What the output says."""

    def report(self, target: Target | None, status: int, printed: str) -> fuzz_targets.Report:
        """The report on a target that is there."""
        assert target is not None
        return fuzz_targets.report(target, status, printed)

    def test_nothing_found(self) -> None:
        report = self.report(CPP, 0, LIBFUZZER)
        self.assertEqual((report.executions, report.reached, report.findings), (18829, "839 edges", ()))
        report = self.report(SCRIPT, 0, SCRIPT_SAID)
        self.assertEqual((report.executions, report.reached, report.findings), (282, "66 kinds of answer", ()))

    def test_findings(self) -> None:
        broken = "broken: same name\nTest unit written to out/crash-1\n"
        self.assertEqual(self.report(CPP, 77, LIBFUZZER + broken).findings, ("broken: same name", "out/crash-1"))
        found = "fuzz: finding (seed 7, try 3): no error: oh\nkept as /tmp/x\n"
        self.assertEqual(len(self.report(SCRIPT, 1, found + SCRIPT_SAID).findings), 1)
        self.assertTrue(self.report(SCRIPT, 0, "SCRIPT ERROR: Invalid call\n" + SCRIPT_SAID).findings)

    def test_a_bad_end_is_a_finding(self) -> None:
        for target, said in ((CPP, LIBFUZZER), (SCRIPT, SCRIPT_SAID)):
            self.assertEqual(self.report(target, 134, said).findings, ("exit status 134",))
            self.assertIn("did not tell", self.report(target, 0, "").findings[0])


class Targets(unittest.TestCase):
    """That each is there."""

    def test_sources(self) -> None:
        listed = (paths.SOURCES / "fuzz" / "CMakeLists.txt").read_text(encoding="utf-8")
        for target in TARGETS:
            if target.kind == "cpp":
                self.assertTrue((paths.SOURCES / "fuzz" / f"{target.name}_fuzz.cpp").exists(), target.name)
                self.assertIn(target.name, listed)
                self.assertTrue(list((paths.SOURCES / "fuzz" / "seeds" / target.name).iterdir()))
            elif target.kind == "script":
                script = paths.ROOT / "tests" / "fuzz" / "targets" / f"{target.name}_target.gd"
                self.assertTrue(script.exists(), target.name)

    def test_none_is_left_out(self) -> None:
        names = {target.name for target in TARGETS}
        for path in (paths.SOURCES / "fuzz").glob("*_fuzz.cpp"):
            self.assertIn(path.name.removesuffix("_fuzz.cpp"), names)
        for path in (paths.ROOT / "tests" / "fuzz" / "targets").glob("*_target.gd"):
            self.assertIn(path.name.removesuffix("_target.gd"), names)


class CaptureLists(unittest.TestCase):
    """The fuzzer in Python."""

    def run_in(self, folder: str) -> fuzz_capture_list.Run:
        """A run that is silent."""
        return fuzz_capture_list.Run(Path(folder), 1)

    def test_seeds_are_taken_or_refused(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            run = self.run_in(folder)
            for seed in fuzz_capture_list.seeds():
                run.attempt(seed)
            self.assertEqual(run.findings, 0)
            self.assertGreaterEqual(run.kinds.get("accepted", 0), 1)

    def test_what_is_no_refusal_is_found_and_kept(self) -> None:
        def breaks(_path: Path) -> str:
            raise KeyError("shot")

        good = fuzz_capture_list.attempt
        fuzz_capture_list.attempt = breaks
        try:
            with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as said:
                run = self.run_in(folder)
                run.attempt(b"[1]")
                self.assertEqual(run.findings, 1)
                self.assertIn("KeyError", said.getvalue())
                self.assertEqual((Path(folder) / "finding_1_1").read_bytes(), b"[1]")
        finally:
            fuzz_capture_list.attempt = good

    def test_lists_too_large_or_too_deep_are_refused(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "list.json"
            path.write_bytes(b"[" * 100000)
            self.assertIn("in each other", fuzz_capture_list.attempt(path))
            with path.open("r+b") as file:
                file.truncate(4 << 30)
            self.assertIn("has # bytes", fuzz_capture_list.attempt(path))


if __name__ == "__main__":
    unittest.main()
