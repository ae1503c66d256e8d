# SPDX-License-Identifier: MIT
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from setup import project_import
from setup.godot import Godot

_GODOT = Godot(Path("/engine/godot"), "4.6.3", private=True)


class EnsureImported(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.root = Path(holder.name)
        (self.root / "art").mkdir()
        (self.root / "art" / "sky.png").write_text("one", encoding="utf-8")
        (self.root / "hidden").mkdir()
        (self.root / "hidden" / ".gdignore").touch()
        (self.root / "hidden" / "notes.txt").touch()
        for target in (
            mock.patch("setup.paths.BUILD", self.root / "hidden"),
            mock.patch("setup.paths.LOGS", self.root / "hidden"),
            mock.patch("setup.process.require", side_effect=self._import),
        ):
            target.start()
            self.addCleanup(target.stop)
        self.imports = 0

    def _import(self, *_command: object, **_options: object) -> None:
        self.imports += 1
        (self.root / "art" / "sky.png.import").write_text(f"import {self.imports}", encoding="utf-8")

    def _ensure(self, godot: Godot = _GODOT) -> int:
        project_import.ensure_imported(godot, self.root)
        return self.imports

    def test_once(self) -> None:
        self.assertEqual((self._ensure(), self._ensure()), (1, 1))

    def test_again_when_an_asset_changed_came_or_went(self) -> None:
        self._ensure()
        (self.root / "art" / "sky.png").write_text("two two", encoding="utf-8")
        self.assertEqual(self._ensure(), 2)
        (self.root / "art" / "new.png").touch()
        self.assertEqual(self._ensure(), 3)
        (self.root / "art" / "new.png").unlink()
        self.assertEqual(self._ensure(), 4)

    def test_again_with_another_engine(self) -> None:
        self._ensure()
        self.assertEqual(self._ensure(Godot(Path("/engine/godot"), "4.7.0", private=True)), 2)

    def test_of_a_script_only_its_class_counts(self) -> None:
        script = self.root / "art" / "a.gd"
        script.write_text("class_name A\nextends Node\nvar x := 1\n", encoding="utf-8")
        self._ensure()
        script.write_text("class_name A\nextends Node\nvar x := 2000\n", encoding="utf-8")
        self.assertEqual(self._ensure(), 1)
        script.write_text("class_name B\nextends Node\nvar x := 2000\n", encoding="utf-8")
        self.assertEqual(self._ensure(), 2)

    def test_not_for_a_library_or_a_hidden_folder(self) -> None:
        self._ensure()
        (self.root / "art" / "lib.so").touch()
        (self.root / "hidden" / "more.txt").touch()
        self.assertEqual(self._ensure(), 1)

    def test_the_extension_is_announced_before_the_first_import(self) -> None:
        self._ensure()
        listed = (self.root / ".godot" / "extension_list.cfg").read_text(encoding="utf-8")
        self.assertEqual(listed, "res://addons/blackhole_sky/blackhole_sky.gdextension\n")
