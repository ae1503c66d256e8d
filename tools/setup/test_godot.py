# SPDX-License-Identifier: MIT
import os
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from setup import godot, godot_version, private_copy, stamps
from setup.console import Failure


def _fake_engine(folder: Path, name: str, version: str) -> Path:
    path = folder / name
    path.write_text(f"#!/bin/sh\necho {version}\n", encoding="utf-8")
    path.chmod(0o755)
    return path


class Versions(unittest.TestCase):
    def test_parse(self) -> None:
        for text, expected in {
            "4.6.3.stable.debian4.6.3+ds-2": (4, 6, 3),
            "4.6.stable.official": (4, 6, 0),
            "4.7.beta1.custom_build": (4, 7, 0),
            "4.6.3+ds-2": (4, 6, 3),
            "not a version": None,
            "": None,
        }.items():
            with self.subTest(text):
                self.assertEqual(godot_version.parse(text), expected)

    def test_is_enough(self) -> None:
        for version, expected in {(4, 6, 0): True, (4, 7, 1): True, (4, 5, 9): False, (5, 0, 0): False}.items():
            with self.subTest(version):
                self.assertEqual(godot_version.is_enough(version), expected)
        self.assertFalse(godot_version.is_enough(None))


class Find(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)
        for target in (
            mock.patch.dict(os.environ, {"PATH": f"{self.folder}:/usr/bin:/bin"}),
            mock.patch("setup.paths.STAMPS", self.folder / "stamps"),
            mock.patch.object(private_copy, "bring", return_value=(Path("/private/godot"), "4.6.3")),
        ):
            target.start()
            self.addCleanup(target.stop)
        os.environ.pop("GODOT", None)

    def test_the_variable_comes_first(self) -> None:
        named = _fake_engine(self.folder, "mine", "4.6.1.stable")
        _fake_engine(self.folder, "godot", "4.7.stable")
        os.environ["GODOT"] = str(named)
        self.assertEqual(godot.find(), godot.Godot(named, "4.6.1", private=False))

    def test_the_private_copy_may_be_named(self) -> None:
        os.environ["XDG_CACHE_HOME"] = str(self.folder)
        cache = self.folder / "blackhole_sky"
        cache.mkdir()
        os.environ["GODOT"] = str(_fake_engine(cache, "godot", "4.6.1.stable"))
        self.assertTrue(godot.find().private)

    def test_an_old_engine_in_the_variable_is_refused_by_version(self) -> None:
        os.environ["GODOT"] = str(_fake_engine(self.folder, "old", "4.3.stable"))
        with self.assertRaisesRegex(Failure, r"4\.3\.0.*needs 4\.6"):
            godot.find()

    def test_a_variable_that_names_nothing_is_refused(self) -> None:
        os.environ["GODOT"] = "/nowhere/godot"
        with self.assertRaisesRegex(Failure, "/nowhere/godot"):
            godot.find()

    def test_an_old_engine_on_the_path_is_passed_over(self) -> None:
        _fake_engine(self.folder, "godot4", "4.2.1.stable")
        found = _fake_engine(self.folder, "godot", "4.6.2.stable")
        self.assertEqual(godot.find(), godot.Godot(found, "4.6.2", private=False))

    def test_else_the_private_copy(self) -> None:
        _fake_engine(self.folder, "godot", "4.2.1.stable")
        self.assertTrue(godot.find().private)

    def test_a_replaced_engine_is_asked_again(self) -> None:
        engine = _fake_engine(self.folder, "godot", "4.6.2.stable")
        self.assertEqual(godot_version.of_executable(engine), (4, 6, 2))
        _fake_engine(self.folder, "godot", "4.6.20.stable")
        self.assertEqual(godot_version.of_executable(engine), (4, 6, 20))


class NewestCopy(unittest.TestCase):
    def test_the_newest_complete_one(self) -> None:
        with tempfile.TemporaryDirectory() as holder:
            cache = Path(holder)
            for version in ("4.6.3", "4.6.12"):
                folder = cache / f"godot-{version}"
                stamps.write(folder / "stamp", private_copy._stamp(folder))
            (cache / "godot-4.7.0").mkdir()  # begun and never ended
            self.assertEqual(private_copy.newest(cache), (cache / "godot-4.6.12/bin/godot", "4.6.12"))

    def test_a_copy_that_was_moved_is_none(self) -> None:
        with tempfile.TemporaryDirectory() as holder:
            folder = Path(holder) / "godot-4.6.3"
            stamps.write(folder / "stamp", private_copy._stamp(Path("/elsewhere/godot-4.6.3")))
            self.assertIsNone(private_copy.newest(Path(holder)))
