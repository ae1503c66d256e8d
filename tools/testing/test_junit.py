# SPDX-License-Identifier: MIT
import tempfile
import unittest
from pathlib import Path

from testing import junit
from testing.junit import Case

_FROM_OTHERS = """<?xml version="1.0"?>
<testsuites><testsuite name="res://tests/unit/test_a.gd" tests="3">
<testcase name="good" time="0.25"/>
<testcase name="bad" classname="A"><failure message="expected 1">at line 3</failure></testcase>
<testcase name="broken" classname="A"><error>no such file</error></testcase>
<testcase name="later" status="pending"><skipped message="needs a headset"/></testcase>
</testsuite></testsuites>"""


class Junit(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.path = Path(holder.name) / "new" / "out.xml"

    def test_reads_what_it_wrote(self) -> None:
        cases = [
            Case("a", "group", 1.5),
            Case("b <&>", "group", 0.0, failure="first line\nsecond"),
            Case("c", "group", 0.0, skipped="no display"),
        ]
        junit.write(self.path, "suite", cases)
        self.assertEqual(junit.read(self.path), cases)

    def test_reads_the_forms_of_others(self) -> None:
        self.path.parent.mkdir()
        self.path.write_text(_FROM_OTHERS, encoding="utf-8")
        good, bad, broken, later = junit.read(self.path)
        self.assertEqual(good, Case("good", "res://tests/unit/test_a.gd", 0.25))
        self.assertEqual(bad.failure, "expected 1\nat line 3")
        self.assertEqual(broken.failure, "no such file")
        self.assertEqual(later.skipped, "needs a headset")

    def test_colours_do_not_break_the_file(self) -> None:
        junit.write(self.path, "suite", [Case("a", failure="\x1b[31mred\x1b[0m")])
        self.assertEqual(junit.read(self.path)[0].failure, "[31mred[0m")
