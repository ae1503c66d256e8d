# SPDX-License-Identifier: MIT
import unittest

from package.engine_output import complaints

_PRINTED = """Godot Engine v4.6.3
ERROR: Cannot open file 'res://a'.
   at: load (core/a.cpp:1)
WARNING: Blocking in swap chain
SCRIPT ERROR: Parse Error
          at: GDScript::reload (res://a.gd:1)
USER WARNING: careful
no ERROR: here
"""


class Complaints(unittest.TestCase):
    def test_all_but_the_machines(self) -> None:
        self.assertEqual(
            complaints(_PRINTED),
            ["ERROR: Cannot open file 'res://a'.", "SCRIPT ERROR: Parse Error", "USER WARNING: careful"],
        )


if __name__ == "__main__":
    unittest.main()
