# SPDX-License-Identifier: MIT
import unittest

from testing.scripts import cases

_PRINTED = """Godot Engine v4.6.3
WARNING: Integer division.
     at: GDScript::reload (res://b.gd:3)
     GDScript backtrace (most recent call first):
loaded res://a.gd well
debug> SCRIPT ERROR: Parse Error: Expected parameter name.
          at: GDScript::reload (res://c.gd:2)
ERROR: Failed to load script "res://c.gd" with error "Parse error".
   at: load (modules/gdscript/gdscript.cpp:2907)
loaded res://c.gd well
loaded res://b.gd well
"""


class Cases(unittest.TestCase):
    def test_a_complaint_belongs_to_the_file_it_names(self) -> None:
        found = {case.name: case.failure for case in cases(["res://a.gd", "res://b.gd", "res://c.gd"], _PRINTED)}
        self.assertIsNone(found["res://a.gd"])
        self.assertIn("Integer division", found["res://b.gd"] or "")
        self.assertIn("Expected parameter name", found["res://c.gd"] or "")
        self.assertIn("Failed to load", found["res://c.gd"] or "")

    def test_a_file_that_was_not_reached_fails(self) -> None:
        self.assertEqual(cases(["res://z.gd"], "crash")[0].failure, "was not loaded")
