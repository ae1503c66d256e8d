# SPDX-License-Identifier: MIT
"""Tests of install.py."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

INSTALLER = Path(__file__).resolve().parent / "install.py"


def run_installer(project: Path) -> str:
    """Runs it and returns what it prints; raises when it fails."""
    command = [sys.executable, str(INSTALLER), "--project", str(project)]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


class Installer(unittest.TestCase):
    """What install.py writes, and what it leaves alone."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        (self.root / "project.godot").write_text("config_version=5\n")
        self.target = self.root / "addons" / "gut"

    def test_installs_once(self) -> None:
        self.assertIn("installed", run_installer(self.root))
        first = (self.target / "test.gd").stat().st_mtime_ns
        self.assertIn("up to date", run_installer(self.root))
        self.assertEqual((self.target / "test.gd").stat().st_mtime_ns, first)

    def test_repairs(self) -> None:
        run_installer(self.root)
        (self.target / "test.gd").write_text("# changed\n")
        self.assertIn("installed", run_installer(self.root))
        self.assertIn("class_name GutTest", (self.target / "test.gd").read_text())
        (self.target / "gut.gd").unlink()
        self.assertIn("installed", run_installer(self.root))
        self.assertTrue((self.target / "gut.gd").exists())

    def test_goes_on_after_an_interruption(self) -> None:
        self.target.mkdir(parents=True)
        (self.target / ".blackhole_sky_runner").write_text("{")
        (self.target / "test.gd").write_text("")
        self.assertIn("installed", run_installer(self.root))
        self.assertIn("up to date", run_installer(self.root))

    def test_takes_away_what_is_no_longer_part(self) -> None:
        run_installer(self.root)
        marker = self.target / ".blackhole_sky_runner"
        content = json.loads(marker.read_text())
        content["files"].append("parts/old.gd")
        content["hash"] = "of an earlier version"
        marker.write_text(json.dumps(content))
        (self.target / "parts" / "old.gd").write_text("")
        run_installer(self.root)
        self.assertFalse((self.target / "parts" / "old.gd").exists())

    def test_leaves_gut_alone(self) -> None:
        self.target.mkdir(parents=True)
        (self.target / "test.gd").write_text("somebody else's")
        self.assertIn("left as it is", run_installer(self.root))
        self.assertEqual((self.target / "test.gd").read_text(), "somebody else's")
        self.assertFalse((self.target / "parts").exists())

    def test_leaves_gut_unpacked_over_the_runner_alone(self) -> None:
        run_installer(self.root)
        (self.target / "plugin.cfg").write_text("[plugin]\n")
        (self.target / "test.gd").write_text("somebody else's")
        self.assertIn("left as it is", run_installer(self.root))
        self.assertEqual((self.target / "test.gd").read_text(), "somebody else's")

    def test_wants_a_project(self) -> None:
        (self.root / "project.godot").unlink()
        with self.assertRaises(subprocess.CalledProcessError):
            run_installer(self.root)


if __name__ == "__main__":
    unittest.main()
