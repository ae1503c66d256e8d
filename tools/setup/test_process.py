# SPDX-License-Identifier: MIT
import tempfile
import time
import unittest
from pathlib import Path

from setup import locks, process, stamps
from setup.console import Failure


class Process(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)
        self.log = self.folder / "log"

    def test_status_and_log(self) -> None:
        self.assertEqual(process.run_logged(["sh", "-c", "echo out; echo err >&2; exit 7"], self.log), 7)
        self.assertEqual(self.log.read_text(encoding="utf-8"), "out\nerr\n")

    def test_a_death_by_signal_counts_as_in_the_shell(self) -> None:
        self.assertEqual(process.run_logged(["sh", "-c", "kill -ABRT $$"], self.log), 134)

    def test_a_command_that_does_not_exist(self) -> None:
        self.assertEqual(process.run_logged(["/nowhere/tool"], self.log), 127)
        self.assertIsNone(process.capture(["/nowhere/tool"]))

    def test_lines_are_seen_and_kept(self) -> None:
        seen: list[str] = []
        process.run_logged(["printf", "a\\nb\\n"], self.log, on_line=seen.append)
        self.assertEqual(seen, ["a", "b"])
        self.assertEqual(self.log.read_text(encoding="utf-8"), "a\nb\n")

    def test_the_time_limit_ends_the_children_too(self) -> None:
        mark = self.folder / "late"
        command = ["sh", "-c", f"(sleep 1; touch {mark}) & sleep 30"]
        self.assertEqual(process.run_logged(command, self.log, timeout_s=0.2), 124)
        time.sleep(1.2)
        self.assertFalse(mark.exists())

    def test_a_failure_shows_the_end_of_the_log(self) -> None:
        with self.assertRaisesRegex(Failure, r"Baking failed \(exit status 3\)(.|\n)*no flour"):
            process.require(["sh", "-c", "echo no flour; exit 3"], self.log, "Baking")


class Stamps(unittest.TestCase):
    def test_fresh_only_with_the_same_inputs(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            stamp = Path(folder) / "a" / "stamp"
            self.assertFalse(stamps.is_fresh(stamp, "x"))
            stamps.write(stamp, "x")
            self.assertTrue(stamps.is_fresh(stamp, "x"))
            self.assertFalse(stamps.is_fresh(stamp, "y"))

    def test_digest_keeps_parts_apart(self) -> None:
        self.assertNotEqual(stamps.digest("ab", "c"), stamps.digest("a", "bc"))


class Locks(unittest.TestCase):
    def test_the_second_waits_for_the_first(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            lock = Path(folder) / "lock"
            with locks.locked(lock, "a test"):
                self.assertEqual(process.run_logged(["flock", "-n", lock, "true"], Path(folder) / "log"), 1)
            self.assertEqual(process.run_logged(["flock", "-n", lock, "true"], Path(folder) / "log"), 0)
