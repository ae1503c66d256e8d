# SPDX-License-Identifier: MIT
import contextlib
import io
import json
import tempfile
import unittest
from collections.abc import Callable
from pathlib import Path
from unittest import mock

from setup import capture, frames
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

        def draw(
            _godot: object, _script: str, renderer: str, arguments: list[str], base: Path, on_line: object,
            headset: object,
        ) -> str:
            self.assertIsNone(on_line)
            self.assertIsNone(headset)
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

    def test_shots_for_a_headset_have_one(self) -> None:
        shot = self.folder / "eyes.json"
        shot.write_text(json.dumps({"position_rs": [0, 0, 9], "xr": {"schwarzschild_radius_m": 2}}), encoding="utf-8")
        out = self.folder / "eyes.png"
        worn = mock.MagicMock()

        def draw(*arguments: object) -> str:
            self.assertIs(arguments[-1], worn.return_value.__enter__.return_value)
            out.touch()
            return ""

        with mock.patch("setup.prepare.project"), mock.patch("setup.session.run_script", draw), \
                mock.patch("setup.monado.find"), mock.patch("setup.capture.SimulatedHeadset", worn), \
                mock.patch("builtins.print"):
            self.assertEqual(capture.run([str(shot), str(out)]), 0)

    def test_a_picture_that_was_not_written_is_a_failure(self) -> None:
        with mock.patch("setup.prepare.project"), mock.patch("setup.session.run_script", return_value=""):
            with self.assertRaisesRegex(Failure, "did not write"):
                capture.run([self._shot("a.json"), str(self.folder / "a.png")])


class Sequence(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)
        ride = {"kind": "fall", "from_rs": 3}
        self.shot = self.folder / "ride.json"
        self.shot.write_text(json.dumps({"path": {"fps": 25, "duration_s": 0.12, "ride": ride}}), encoding="utf-8")

    def _capture(self, out: str, stop_after: int = 9) -> tuple[int, list[str]]:
        """Captures with a stand-in for Godot; returns the exit status and the lines on stderr."""
        def draw(
            _godot: object, _script: str, _renderer: str, arguments: list[str], _base: Path,
            on_line: Callable[[str], None], _headset: object,
        ) -> str:
            pattern = Path(arguments[1])
            pattern.parent.mkdir(exist_ok=True)
            on_line("Godot Engine v4.6")
            for frame in range(3):
                if frame == stop_after:
                    frames.file(pattern, frame).with_name(frames.file(pattern, frame).name + ".part").touch()
                    raise KeyboardInterrupt
                frames.file(pattern, frame).touch()
                on_line(f"capture frame {frame + 1}/3")
            return ""

        with mock.patch("setup.prepare.project"), mock.patch("setup.session.run_script", draw), \
                contextlib.redirect_stdout(io.StringIO()) as results, \
                contextlib.redirect_stderr(io.StringIO()) as self.said:
            status = capture.run([str(self.shot), out])
        return status, results.getvalue().splitlines()

    def test_frames_into_a_folder_with_progress(self) -> None:
        status, results = self._capture(f"{self.folder}/film/")
        self.assertEqual((status, results), (0, [f"{self.folder}/film/frame_%04d.png"]))
        self.assertRegex(self.said.getvalue(), r"    frame 1/3\n    frame 2/3, \d+\.\d frames/s, 0:00 min left\n")

    def test_interrupted_it_leaves_whole_frames_and_says_so(self) -> None:
        with self.assertRaises(KeyboardInterrupt):
            self._capture(f"{self.folder}/film/", stop_after=2)
        self.assertIn(f"stopped: 2 complete frames are in {self.folder}/film", self.said.getvalue())
        self.assertEqual(len(list((self.folder / "film").iterdir())), 2)

    def test_a_movie_is_put_together_from_frames_that_are_then_removed(self) -> None:
        def put_together(pattern: Path, fps: float, out: Path) -> None:
            self.assertEqual([path.name for path in frames.written(pattern)], [f"frame_000{i}.png" for i in range(3)])
            self.assertEqual(fps, 25.0)
            out.touch()

        stale = self.folder / "ride.mp4.frames" / "frame_0003.png"
        stale.parent.mkdir()
        stale.touch()
        with mock.patch("setup.movie.encoders", return_value=["libx264"]), mock.patch("setup.movie.write", put_together):
            status, results = self._capture(f"{self.folder}/ride.mp4")
        self.assertEqual((status, results), (0, [f"{self.folder}/ride.mp4"]))
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["ride.json", "ride.mp4"])

    def test_a_movie_takes_a_sequence_and_ffmpeg(self) -> None:
        with mock.patch("shutil.which", return_value=None), self.assertRaisesRegex(Failure, "ride.mp4.*ffmpeg.*folder"):
            self._capture(f"{self.folder}/ride.mp4")
        self.shot.write_text('{"position_rs": [0, 0, 5]}', encoding="utf-8")
        with self.assertRaisesRegex(Failure, "ride.mp4: a movie takes a sequence, and the shot has no path"):
            self._capture(f"{self.folder}/ride.mp4")
        self.assertEqual(list(self.folder.iterdir()), [self.shot])


class Reason(unittest.TestCase):
    def test_the_scripts_own_lines(self) -> None:
        printed = "Godot Engine v4.6\ncapture: unknown key 'positon_rs'\nERROR: noise\n"
        self.assertEqual(reason(printed), "capture: unknown key 'positon_rs'")
