# SPDX-License-Identifier: MIT
import unittest

from package import exports

_PRINTED = """Godot Engine v4.6.3

ERROR: Cannot export project with preset "Windows" due to configuration errors:
No export template found at the expected path:
/data/windows_debug_x86_64.exe

   at: _fs_changed (editor/editor_node.cpp:1)
savepack: step 1
SCRIPT ERROR: Parse Error
   at: GDScript::reload (res://a.gd:1)
ERROR: Project export for preset "Windows" failed.
"""


class Reasons(unittest.TestCase):
    def test_all_lines_of_each_error(self) -> None:
        first, second, third = exports.reasons(_PRINTED)
        self.assertRegex(first, "configuration errors:\\nNo export template(.|\\n)*debug_x86_64.exe$")
        self.assertEqual(second, "Parse Error")
        self.assertEqual(third, 'Project export for preset "Windows" failed.')


if __name__ == "__main__":
    unittest.main()
