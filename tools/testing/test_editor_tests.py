# SPDX-License-Identifier: MIT
"""Tests of what the editor's stage reads from logs and from the class reference."""

from __future__ import annotations

import sys
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from testing.editor_tests import complaints, empty_descriptions


class Complaints(unittest.TestCase):
    """Errors and warnings in the editor's log."""

    def test_errors_and_warnings_count(self) -> None:
        printed = "hello\nERROR: one\n   at: here\nWARNING: two\nSCRIPT ERROR: three\nno ERROR: four\n"
        self.assertEqual(list(complaints(printed)), ["ERROR: one", "WARNING: two", "SCRIPT ERROR: three"])

    def test_what_was_provoked_does_not(self) -> None:
        self.assertEqual(list(complaints("ERROR: res://bad.csv, line 3: no\n")), [])


class EmptyDescriptions(unittest.TestCase):
    """What the class reference leaves unsaid."""

    WHOLE = """<class name="A"><brief_description>b</brief_description><description>d</description>
    <methods><method name="m"><description>text</description></method></methods>
    <signals><signal name="s"><description>text</description></signal></signals>
    <members><member name="p">text</member></members>
    <constants><constant name="C">text</constant></constants></class>"""

    def test_nothing_is_missing(self) -> None:
        self.assertEqual(list(empty_descriptions(ElementTree.fromstring(self.WHOLE))), [])

    def test_each_kind_is_missed(self) -> None:
        for said, missing in (
            (">b<", "brief_description"), (">d<", "description"), ('"m"><description>text<', "method m"),
            ('"s"><description>text<', "signal s"), ('"p">text<', "member p"), ('"C">text<', "constant C"),
        ):
            silent = self.WHOLE.replace(said, said[: said.rindex(">") + 1] + " <", 1)
            self.assertEqual(list(empty_descriptions(ElementTree.fromstring(silent))), [missing])


if __name__ == "__main__":
    unittest.main()
