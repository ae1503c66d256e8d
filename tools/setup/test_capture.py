# SPDX-License-Identifier: MIT
import json
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from setup import capture
from setup.capture import Job
from setup.console import Failure
from setup.session import reason


class Capture(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)

    def _shot(self, name: str, **keys: object) -> str:
        path = self.folder / name
        path.write_text(json.dumps({"position_rs": [0, 0, 10], **keys}), encoding="utf-8")
        return str(path)

    def _renderer(self, out: str, **keys: object) -> str:
        return capture.renderer_of(Job(Path(self._shot("shot.json", **keys)), Path(out)))

    def test_the_renderer_named_in_the_shot(self) -> None:
        self.assertEqual(self._renderer("a.png", renderer="gl_compatibility"), "gl_compatibility")
        self.assertEqual(self._renderer("a.exr", renderer="mobile"), "mobile")

    def test_without_a_name(self) -> None:
        self.assertEqual(self._renderer("a.png"), "mobile")
        self.assertEqual(self._renderer("a.exr"), "forward_plus")

    def test_a_wrong_name_is_left_to_the_scene(self) -> None:
        self.assertEqual(self._renderer("a.png", renderer="vulcan"), "mobile")

    def test_a_wrong_command_line(self) -> None:
        for arguments in ([], ["a.json"], ["a", "b", "c"], ["--batch"], ["--help"], ["--bach", "l.json"]):
            with self.subTest(arguments), self.assertRaises(Failure) as caught:
                capture.run(arguments)
            self.assertEqual(caught.exception.code, 2)

    def test_files_that_cannot_be_read(self) -> None:
        broken = self.folder / "broken.json"
        broken.write_text("{", encoding="utf-8")
        for path, words in {self.folder / "none.json": "cannot read", broken: "is not JSON"}.items():
            for arguments in ([str(path), "o.png"], ["--batch", str(path)]):
                with self.subTest(arguments), self.assertRaisesRegex(Failure, words):
                    capture.run(arguments)

    def test_a_wrong_list(self) -> None:
        path = self.folder / "list.json"
        for listed in (
            {"shot": "a", "out": "b"}, [], [{"shot": "a"}], [{"shot": "a", "out": 1}], [{"shot": 1, "out": "b"}], ["a"],
        ):
            path.write_text(json.dumps(listed), encoding="utf-8")
            with self.subTest(listed), self.assertRaisesRegex(Failure, "list|entry 1"):
                capture.run(["--batch", str(path)])

    def test_one_start_of_godot_for_each_renderer_in_use(self) -> None:
        outs = [self.folder / "out" / f"{number}.png" for number in range(3)]
        shots = ["a.json", {"position_rs": [0, 0, 9], "renderer": "forward_plus"}, "c.json"]
        self._shot("a.json")
        self._shot("c.json")
        path = self.folder / "list.json"
        path.write_text(json.dumps([{"shot": s, "out": f"out/{o.name}"} for s, o in zip(shots, outs)]), encoding="utf-8")
        starts: list[tuple[str, list[str], Path]] = []

        def draw(_godot: object, _script: str, renderer: str, arguments: list[str], base: Path) -> str:
            drawn = [{"out": arguments[1]}]
            if arguments[0] == "--batch":
                drawn = json.loads(Path(arguments[1]).read_text(encoding="utf-8"))
            starts.append((renderer, [entry["out"] for entry in drawn], base))
            for entry in drawn:
                Path(entry["out"]).parent.mkdir(exist_ok=True)
                Path(entry["out"]).touch()
            return ""

        with mock.patch("setup.prepare.project"), mock.patch("setup.session.run_script", draw), \
                mock.patch("builtins.print") as printed:
            self.assertEqual(capture.run(["--batch", str(path)]), 0)
        self.assertEqual(starts, [
            ("mobile", [str(outs[0]), str(outs[2])], self.folder), ("forward_plus", [str(outs[1])], self.folder),
        ])
        self.assertEqual([call.args[0] for call in printed.call_args_list], outs)

    def test_a_picture_that_was_not_written_is_a_failure(self) -> None:
        with mock.patch("setup.prepare.project"), mock.patch("setup.session.run_script", return_value=""):
            with self.assertRaisesRegex(Failure, "did not write"):
                capture.run([self._shot("a.json"), str(self.folder / "a.png")])


class Reason(unittest.TestCase):
    def test_the_scripts_own_lines(self) -> None:
        printed = "Godot Engine v4.6\ncapture: unknown key 'positon_rs'\nERROR: noise\n"
        self.assertEqual(reason(printed), "capture: unknown key 'positon_rs'")
