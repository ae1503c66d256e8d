# SPDX-License-Identifier: MIT
import os
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from package import debian_templates, official_templates
from package.debian_templates import Templates
from setup import private_packages, stamps
from setup.console import Failure


class Official(unittest.TestCase):
    def test_where_godot_looks(self) -> None:
        with mock.patch.dict(os.environ, {"XDG_DATA_HOME": "/data"}):
            for platform, engine, expected in (
                ("Linux", "4.6.3", "4.6.3.stable/linux_release.x86_64"),
                ("Windows Desktop", "4.7.0", "4.7.stable/windows_release_x86_64.exe"),
            ):
                found = official_templates.file(platform, "release", engine)
                self.assertEqual(found, Path("/data/godot/export_templates") / expected)


class Debian(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.cache = Path(holder.name)

    def _complete(self, version: str) -> Path:
        folder = self.cache / f"templates-{version}"
        stamps.write(folder / "stamp", debian_templates._stamp(folder))
        return folder

    def test_of_the_engines_minor_version(self) -> None:
        self._complete("4.7.0")
        (self.cache / "templates-4.6.9").mkdir()  # begun and never ended
        self.assertIsNone(debian_templates.of_cache(self.cache, "4.6.3"))
        older, newer = self._complete("4.6.2"), self._complete("4.6.10")
        self.assertEqual(debian_templates.of_cache(self.cache, "4.6.3"), Templates(newer))
        self.assertEqual(debian_templates.of_cache(self.cache, "4.6.2"), Templates(older))

    def test_where_none_can_be_had(self) -> None:
        with mock.patch.object(debian_templates.paths, "cache_dir", return_value=self.cache), \
                mock.patch.object(private_packages.archive, "candidates", return_value=[]), \
                mock.patch.object(debian_templates, "say"), mock.patch.object(debian_templates, "note"), \
                self.assertRaisesRegex(Failure, "Export templates for Godot 4.6.3 were not found(.|\n)*Manage Export"):
            debian_templates.bring("4.6.3")


if __name__ == "__main__":
    unittest.main()
