# SPDX-License-Identifier: MIT
import unittest
from pathlib import Path

from setup import paths
from testing import context


class Sources(unittest.TestCase):
    def test_all_files_when_no_ending_is_named(self) -> None:
        found = context.sources()
        for name in ("LICENSE", "test", "project.godot", "tools/testing/test_context.py"):
            self.assertIn(paths.ROOT / name, found)

    def test_endings_and_folders(self) -> None:
        found = context.sources(".py", under="tools/testing")
        self.assertIn(Path(__file__).resolve(), found)
        self.assertEqual({path.suffix for path in found}, {".py"})
        self.assertEqual({path.parent for path in found}, {Path(__file__).resolve().parent})
