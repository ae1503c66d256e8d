# SPDX-License-Identifier: MIT
"""./run as a visitor uses it, on the built project. Run by the stage `commands` of ./test."""

from __future__ import annotations

import json
import struct
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

_ROOT = Path(__file__).resolve().parent.parent.parent
_SUBCOMMANDS = ("demo", "xr", "kiosk", "capture", "screens", "bake", "lut", "bench", "self-test", "package", "export", "editor", "clean",
                "help")


def run(*arguments: str | Path, cwd: Path = _ROOT) -> subprocess.CompletedProcess[str]:
    """./run with these arguments."""
    return subprocess.run(
        [str(_ROOT / "run"), *(str(part) for part in arguments)],
        cwd=cwd, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=300, check=False,
    )


class CommandLine(unittest.TestCase):
    def test_help_has_one_line_for_each_subcommand(self) -> None:
        done = run("help")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for word in _SUBCOMMANDS:
            self.assertRegex(done.stdout, rf"(?m)^  {word} +\S")

    def test_an_unknown_word_gets_the_list_and_2(self) -> None:
        done = run("fly")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("'fly'", done.stderr)
        self.assertIn(run("help").stdout.strip(), done.stderr)

    def test_wrong_arguments_are_2(self) -> None:
        for arguments in (
            ["capture"], ["bake", "--chek"], ["clean", "all"], ["bench", "a", "b"], ["bench", "--renderer", "vulcan"],
            ["self-test", "a", "b"], ["screens"], ["self-test", "--renderer", "vulcan"],
            ["demo", "fast"], ["editor", "fast"], ["xr", "fast"], ["xr", "--simulate"],
            ["kiosk", "fast"], ["kiosk", "--config"], ["package", "fast"], ["package", "--libraries", "release,beos"],
            ["package", "--libraries", "debug"], ["export", "BeOS"], ["export", "Linux", "--fast"],
        ):
            with self.subTest(arguments):
                done = run(*arguments)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertIn("usage:", done.stderr)

    def test_a_second_start_is_quick(self) -> None:
        ready = [sys.executable, "-c", "from setup import prepare; prepare.project()"]
        for limit_s in (600.0, 3.0):
            started = time.monotonic()
            done = subprocess.run(ready, cwd=_ROOT / "tools", capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertLess(time.monotonic() - started, limit_s)
        self.assertEqual(done.stderr, "", "nothing is left to do")

    def test_from_any_folder_and_through_a_link(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            link = Path(folder) / "sky"
            link.symlink_to(_ROOT / "run")
            done = subprocess.run([link, "help"], cwd=folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)


class Capture(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)

    def _shot(self, name: str, **keys: object) -> str:
        shot = {"position_rs": [0, 0, 10], "resolution": [160, 90], **keys}
        (self.folder / name).write_text(json.dumps(shot), encoding="utf-8")
        return name

    def test_a_picture_of_the_size_asked_for(self) -> None:
        done = run("capture", self._shot("shot.json", background="grid"), "new/picture.png", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        picture = self.folder / "new" / "picture.png"
        self.assertEqual(done.stdout, f"{picture}\n")
        self.assertEqual(struct.unpack(">II", picture.read_bytes()[16:24]), (160, 90))

    def test_linear_light_needs_no_renderer_named(self) -> None:
        done = run("capture", self._shot("shot.json"), "light.exr", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((self.folder / "light.exr").read_bytes()[:4], b"\x76\x2f\x31\x01")

    def test_a_sequence_into_a_folder(self) -> None:
        path = {"fps": 3, "duration_s": 1, "ride": {"kind": "fall", "from_rs": 1.5, "to_rs": 0.5}}
        (self.folder / "fall.json").write_text(json.dumps({"resolution": [64, 48], "path": path}), encoding="utf-8")
        done = run("capture", "fall.json", "film/", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("frame 3/3", done.stderr)
        names = sorted(picture.name for picture in (self.folder / "film").iterdir())
        self.assertEqual(names, ["frame_0000.png", "frame_0001.png", "frame_0002.png"])

    def test_a_list_with_several_renderers(self) -> None:
        shots = [self._shot(f"{name}.json", renderer=name) for name in ("mobile", "gl_compatibility")]
        listed = [{"shot": shot, "out": f"{shot}.png"} for shot in shots]
        (self.folder / "list.json").write_text(json.dumps(listed), encoding="utf-8")
        done = run("capture", "--batch", "list.json", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        for shot in shots:
            self.assertTrue((self.folder / f"{shot}.png").is_file())

    def test_impossible_requests_are_refused_by_name(self) -> None:
        refused: dict[str, dict[str, object]] = {
            "positon": {"positon": [0, 0, 1]},
            "resolution": {"resolution": "large"},
            "renderer": {"renderer": "vulcan"},
            "static": {"position_rs": [0, 0, 0.5], "observer": "static"},
            "nowhere.csv": {"stars": {"catalogue": "nowhere.csv"}},
            "nowhere.png": {"background": "nowhere.png"},
        }
        for words, keys in refused.items():
            with self.subTest(words):
                done = run("capture", self._shot("shot.json", **keys), "picture.png", cwd=self.folder)
                self.assertNotEqual(done.returncode, 0)
                self.assertIn(words, done.stderr)
                self.assertEqual(done.stdout, "")
                self.assertFalse((self.folder / "picture.png").exists())


class SelfTest(unittest.TestCase):
    def test_the_card_of_this_machine_is_right(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "found.json"
            done = run("self-test", out, "--renderer", "gl_compatibility")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            found = json.loads(out.read_text(encoding="utf-8"))
        self.assertTrue(found["passed"])
        self.assertEqual(found["renderer"], "gl_compatibility")
        self.assertIn(found["device"], done.stdout)
        self.assertIn(found["verdict"], done.stdout)
        for check in found["checks"]:
            self.assertRegex(done.stdout, rf"(?m)^{check['check']} .* ok$")


class Tables(unittest.TestCase):
    def test_the_committed_table_is_what_bake_makes(self) -> None:
        done = run("bake", "--check")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_the_table_tool_refuses_a_wrong_file(self) -> None:
        done = run("lut", "inspect", "/nowhere.lut")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("/nowhere.lut", done.stderr)


if __name__ == "__main__":
    unittest.main()
