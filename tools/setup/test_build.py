# SPDX-License-Identifier: MIT
import unittest

from setup.build import first_error


class FirstError(unittest.TestCase):
    def test_begins_with_the_command_that_failed(self) -> None:
        printed = "\n".join(["[1/3] fine", "FAILED: a.o", "a.cpp:1: error: no", *["more"] * 50, "FAILED: b.o"])
        lines = first_error(printed).splitlines()
        self.assertEqual(lines[0], "    | FAILED: a.o")
        self.assertEqual(len(lines), 30)

    def test_without_a_failed_command_the_end(self) -> None:
        self.assertEqual(first_error("ninja: error: loading 'build.ninja'"), "    | ninja: error: loading 'build.ninja'")
