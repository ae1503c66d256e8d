# SPDX-License-Identifier: MIT
import os
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from setup.console import Failure
from setup.godot import Godot
from testing import context, junit, tidy
from testing.context import Context, run_for_junit
from testing.junit import Case

_TESTS = """
import unittest
class Sample(unittest.TestCase):
    def test_good(self): pass
    def test_bad(self): self.assertEqual(1, 2)
    def test_error(self): raise KeyError("lost")
    def test_parts(self):
        for number in (1, 2):
            with self.subTest(number): self.assertEqual(number, 1)
    @unittest.skip("not today")
    def test_skipped(self): pass
"""


class InFolder(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)
        target = mock.patch("setup.paths.LOGS", self.folder)
        target.start()
        self.addCleanup(target.stop)
        self.out = self.folder / "out.xml"


class RunForJunit(InFolder):
    def _program(self, script: str) -> list[Case]:
        return run_for_junit(["sh", "-c", script], "sample", 10, os.environ, self.out)

    def test_no_file_is_a_failure_whatever_the_status(self) -> None:
        junit.write(self.out, "old", [Case("from the last run")])
        with self.assertRaisesRegex(Failure, "wrote no results"):
            self._program("exit 0")

    def test_an_empty_file_is_a_failure(self) -> None:
        with self.assertRaisesRegex(Failure, "ran no test"):
            self._program(f"echo '<testsuites/>' > {self.out}")

    def test_a_bad_end_after_good_tests_is_a_failure(self) -> None:
        good = '<testsuite><testcase name="a"/></testsuite>'
        cases = self._program(f"echo '{good}' > {self.out}; echo boom; exit 134")
        self.assertIn("boom", cases[-1].failure or "")

    def test_engine_and_long_variants_are_announced(self) -> None:
        script = f"echo \"<testsuite><testcase name='$BLACKHOLE_TEST_ALL $GODOT'/></testsuite>\" > {self.out}"
        with mock.patch.object(Context, "engine", Godot(Path("/engine/godot"), "4.6.3", private=True)):
            environment = Context(all_variants=True).environment()
        cases = run_for_junit(["sh", "-c", script], "sample", 10, environment, self.out)
        self.assertEqual(cases[0].name, "1 /engine/godot")


class UnittestJunit(InFolder):
    def test_each_outcome(self) -> None:
        (self.folder / "test_sample.py").write_text(_TESTS, encoding="utf-8")
        runner = Path(context.__file__).parent / "unittest_junit.py"
        command = [sys.executable, runner, self.folder / "test_sample.py", self.out]
        found = {case.name: case for case in run_for_junit(command, "sample", 60, os.environ, self.out)}
        self.assertEqual(len(found), 5)
        self.assertIsNone(found["test_good"].failure)
        self.assertIn("1 != 2", found["test_bad"].failure or "")
        self.assertIn("lost", found["test_error"].failure or "")
        self.assertIn("2 != 1", found["test_parts"].failure or "")
        self.assertEqual(found["test_skipped"].skipped, "not today")


class Tidy(InFolder):
    def test_the_fingerprint_follows_the_contents_and_not_the_place(self) -> None:
        first, second = self.folder / "a" / "x.cpp", self.folder / "b" / "x.cpp"
        for path in (first, second):
            path.parent.mkdir()
            path.write_text("int x;", encoding="utf-8")
        prints = [
            tidy.fingerprint("14", "rules", f"g++ -c {path.parent}/x.o", [path], path.parent) for path in (first, second)
        ]
        self.assertEqual(prints[0], prints[1])
        second.write_text("int y;", encoding="utf-8")
        changed = tidy.fingerprint("14", "rules", f"g++ -c {second.parent}/x.o", [second], second.parent)
        self.assertNotEqual(changed, prints[0])
