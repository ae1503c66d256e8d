# SPDX-License-Identifier: MIT
import json
import os
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from setup import monado, private_packages, stamps
from setup.console import Failure
from setup.godot import Godot
from setup.monado import Monado


class Versions(unittest.TestCase):
    def test_upstream(self) -> None:
        for text, expected in {
            "25.1.0+dfsg1-2": "25.1.0",
            "1:25.1.0-1": "25.1.0",
            "21.0.0+git2905.e26a272c1~dfsg1-2": "21.0.0",
            "git-1": "",
        }.items():
            with self.subTest(text):
                self.assertEqual(monado.upstream(text), expected)


class Find(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)
        self.private = Monado(Path("/private/monado-service"), self._manifest("private", "libc.so.6"))
        for target in (
            mock.patch.dict(os.environ, {"PATH": str(self.folder)}),
            mock.patch.object(monado, "_SYSTEM_MANIFESTS", (self.folder / "none", self.folder / "system")),
            mock.patch.object(monado, "bring", return_value=self.private),
        ):
            target.start()
            self.addCleanup(target.stop)
        self.godot = Godot(Path("/usr/bin/godot"), "4.6.3", private=False)

    def _manifest(self, folder: str, library: str) -> Path:
        file = self.folder / folder / "openxr_monado.json"
        file.parent.mkdir()
        file.write_text(json.dumps({"runtime": {"library_path": library}}), encoding="utf-8")
        return file

    def _install(self) -> Monado:
        """Monado as the system's packages leave it."""
        service = self.folder / "monado-service"
        service.touch(0o755)
        return Monado(service, self._manifest("system", "libopenxr_monado.so"))

    def _own_godot(self) -> Godot:
        """A private copy of Godot whose loader knows this machine's libraries, as far as --list asks for them."""
        libraries = self.folder / "godot" / "root" / "usr/lib/x86_64-linux-gnu"
        libraries.mkdir(parents=True)
        (libraries / "libc.so.6").touch()
        loader = libraries / "ld-linux-x86-64.so.2"
        loader.write_text('#!/bin/sh\n[ "$4" = libc.so.6 ]\n', encoding="utf-8")
        loader.chmod(0o755)
        return Godot(self.folder / "godot" / "bin" / "godot", "4.6.3", private=True)

    def test_the_systems(self) -> None:
        installed = self._install()
        self.assertEqual(monado.find(self.godot), installed)

    def test_both_halves_must_be_there(self) -> None:
        self._install().manifest.unlink()
        self.assertEqual(monado.find(self.godot), self.private)
        self._manifest("none", "libopenxr_monado.so")
        (self.folder / "monado-service").unlink()
        self.assertEqual(monado.find(self.godot), self.private)

    def test_the_private_godot_takes_the_private_copy(self) -> None:
        self._install()
        self.assertEqual(monado.find(self._own_godot()), self.private)

    def test_a_copy_that_this_godot_cannot_load(self) -> None:
        for godot, remedy in ((self.godot, "unset .GODOT"), (self._own_godot(), "clean --cache")):
            self.private.manifest.write_text('{"runtime": {"library_path": "/nowhere.so"}}', encoding="utf-8")
            with self.subTest(godot), self.assertRaisesRegex(Failure, f"/nowhere.so.*{remedy}") as caught:
                monado.find(godot)
            self.assertEqual(caught.exception.code, 3)


class Copies(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.cache = Path(holder.name)

    def _complete(self, version: str) -> Path:
        folder = self.cache / f"monado-{version}"
        stamps.write(folder / "stamp", monado._stamp(folder))
        return folder

    def test_the_newest_complete_one(self) -> None:
        self.assertIsNone(monado.newest(self.cache))
        self._complete("25.1.0")
        newest = self._complete("25.10.0")
        (self.cache / "monado-26.0.0").mkdir()  # begun and never ended
        self.assertEqual(
            monado.newest(self.cache), Monado(newest / "bin/monado-service", newest / "openxr_monado.json")
        )

    def test_nothing_is_made_again(self) -> None:
        folder = self._complete("25.1.0")
        with mock.patch.object(monado.paths, "cache_dir", return_value=self.cache), \
                mock.patch.object(private_packages, "offer") as offer:
            self.assertEqual(monado.bring().service, folder / "bin/monado-service")
        offer.assert_not_called()

    def test_where_none_can_be_had(self) -> None:
        with mock.patch.object(monado.paths, "cache_dir", return_value=self.cache), \
                mock.patch.object(private_packages.archive, "candidates", return_value=[]), \
                mock.patch.object(monado, "say"), mock.patch.object(monado, "note"), \
                self.assertRaisesRegex(Failure, "Monado was not found(.|\n)*simulated headset only"):
            monado.bring()

    def test_the_manifest_names_the_patched_library(self) -> None:
        folder = self.cache / "monado-1.0"
        root = mock.Mock(libraries=Path("/libraries"))
        with mock.patch.object(monado.relocate, "find_root", return_value=root):
            folder.mkdir()
            monado._install(folder, self.cache / "log")
        manifest = json.loads((folder / "openxr_monado.json").read_text(encoding="utf-8"))
        self.assertEqual(manifest["runtime"]["library_path"], str(folder / "lib/libopenxr_monado.so"))
        root.library.assert_called_once_with(
            Path("/libraries/libopenxr_monado.so"), folder / "lib/libopenxr_monado.so", self.cache / "log"
        )


if __name__ == "__main__":
    unittest.main()
