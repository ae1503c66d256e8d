# SPDX-License-Identifier: MIT
import os
import stat
import tempfile
import unittest
import zipfile
from pathlib import Path

from package import addon_zip
from package.libraries import Library
from setup.console import Failure

_DESCRIPTION = """[configuration]

entry_symbol = "a"

[libraries]

linux.x86_64 = "bin/liba.so"

[icons]
"""
_RELEASE = Library("release", "liba.so", "linux.x86_64")
_DEBUG = Library("debug", "liba.debug.so", "linux.debug.x86_64")


class Content(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.addon = Path(holder.name) / "addon"
        for name in (*addon_zip.REQUIRED, "bin/liba.so", "bin/liba.debug.so", "bin/old.so", "bin/.gitkeep", ".hidden/x"):
            (self.addon / name).parent.mkdir(parents=True, exist_ok=True)
            (self.addon / name).write_text(name, encoding="utf-8")
        (self.addon / addon_zip.DESCRIPTION).write_text(_DESCRIPTION, encoding="utf-8")

    def test_all_files_but_of_the_libraries_only_those_asked_for(self) -> None:
        files = addon_zip.content(self.addon, [_RELEASE])
        self.assertEqual(set(files), {*addon_zip.REQUIRED, "bin/liba.so"})
        self.assertEqual(files[addon_zip.DESCRIPTION].decode(), _DESCRIPTION)

    def test_a_missing_licence(self) -> None:
        (self.addon / "LICENSE").unlink()
        with self.assertRaisesRegex(Failure, "LICENSE"):
            addon_zip.content(self.addon, [_RELEASE])

    def test_the_description_names_what_only_the_package_has(self) -> None:
        lines = addon_zip.content(self.addon, [_RELEASE, _DEBUG])[addon_zip.DESCRIPTION].decode().splitlines()
        section = lines[lines.index("[libraries]") + 1 : lines.index("[icons]")]
        self.assertEqual(
            sorted(line for line in section if line),
            ['linux.debug.x86_64 = "bin/liba.debug.so"', 'linux.x86_64 = "bin/liba.so"'],
        )

    def test_another_file_under_the_same_features(self) -> None:
        with self.assertRaisesRegex(Failure, "linux.x86_64"):
            addon_zip.with_libraries(_DESCRIPTION, [Library("release", "libb.so", "linux.x86_64")])

    def test_two_runs_give_the_same_bytes(self) -> None:
        zips = [self.addon.parent / f"{name}.zip" for name in "ab"]
        for number, zip_file in enumerate(zips):
            for path in self.addon.rglob("*"):
                os.utime(path, (1e9 + number, 1e9 + number))
            (self.addon / "LICENSE").chmod(0o600 + 0o44 * number)
            addon_zip.write(zip_file, "root-1", addon_zip.content(self.addon, [_RELEASE]))
        self.assertEqual(zips[0].read_bytes(), zips[1].read_bytes())

    def test_one_root_folder_with_readable_files(self) -> None:
        zip_file = self.addon.parent / "a.zip"
        addon_zip.write(zip_file, "root-1", {"b": b"2", "a": b"1"})
        with zipfile.ZipFile(zip_file) as archive:
            self.assertEqual(archive.namelist(), [f"root-1/addons/blackhole_sky/{name}" for name in "ab"])
            self.assertEqual(archive.read("root-1/addons/blackhole_sky/a"), b"1")
            self.assertEqual(stat.S_IMODE(archive.infolist()[0].external_attr >> 16), 0o644)


if __name__ == "__main__":
    unittest.main()
