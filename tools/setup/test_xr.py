# SPDX-License-Identifier: MIT
import contextlib
import io
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from setup import openxr_runtime, xr
from setup.console import Failure


class Arguments(unittest.TestCase):
    def test_right_ones(self) -> None:
        for arguments, expected in (
            ([], (False, [])),
            (["--simulated"], (True, [])),
            (["--", "--verbose"], (False, ["--verbose"])),
            (["--simulated", "--", "--simulated"], (True, ["--simulated"])),
        ):
            with self.subTest(arguments):
                self.assertEqual(xr.parse(arguments), expected)

    def test_a_strip(self) -> None:
        self.assertIsNone(xr.strip_folder([]))
        self.assertIsNone(xr.strip_folder(["--simulated"]))
        self.assertEqual(xr.strip_folder(["--strip", "out"]), Path.cwd() / "out")
        for arguments in (["--strip"], ["--strip", "out", "more"]):
            with self.subTest(arguments), self.assertRaisesRegex(Failure, "usage:"):
                xr.strip_folder(arguments)

    def test_wrong_ones(self) -> None:
        for arguments in (["fast"], ["--simulate"], ["--simulated", "fast"]):
            with self.subTest(arguments), self.assertRaisesRegex(Failure, "usage:") as caught:
                xr.parse(arguments)
            self.assertEqual(caught.exception.code, 2)


class Supervise(unittest.TestCase):
    def _run(self, statuses: list[int], seconds_apart: float = 1.0) -> tuple[int, int]:
        """(status, starts) with an engine that ends with these statuses, each after some time."""
        left, now = list(statuses), [0.0]

        def start(variables: dict[str, str]) -> int:
            self.assertEqual(variables["BLACKHOLE_SUPERVISED"], "1")
            self.assertEqual("BLACKHOLE_STARTED_AGAIN" in variables, len(left) < len(statuses))
            now[0] += seconds_apart
            return left.pop(0)

        with contextlib.redirect_stderr(io.StringIO()):
            status = xr.supervise(start, lambda: now[0])
        return status, len(statuses) - len(left)

    def test_an_end_is_an_end(self) -> None:
        for status in (0, 1, 130, 139):
            self.assertEqual(self._run([status, 0]), (status, 1))

    def test_started_again_when_asked(self) -> None:
        self.assertEqual(self._run([75, 75, 0]), (0, 3))

    def test_not_more_than_five_times_in_a_minute(self) -> None:
        self.assertEqual(self._run([75] * 5 + [0]), (0, 6))
        with self.assertRaisesRegex(Failure, "6 times within a minute") as caught:
            self._run([75] * 7)
        self.assertEqual(caught.exception.code, 75)

    def test_waits_for_a_runtime_as_long_as_it_takes(self) -> None:
        self.assertEqual(self._run([75] + [76] * 50 + [0]), (0, 52))

    def test_as_often_as_it_takes_when_it_takes_long(self) -> None:
        self.assertEqual(self._run([75] * 50 + [3], seconds_apart=13.0), (3, 51))


class Run(unittest.TestCase):
    def _run(self, *arguments: str, runtime: Path | None = None, screen: bool = True) -> tuple[list[object], str]:
        """(what the project was opened with, what was printed)."""
        headset = mock.MagicMock()
        headset.__enter__.return_value = mock.Mock(port=4711, environment=lambda: {"XR_RUNTIME_JSON": "/m.json"})
        printed = io.StringIO()
        with mock.patch.object(xr.prepare, "project", return_value="godot"), \
                mock.patch.object(xr.monado, "find", return_value="monado"), \
                mock.patch.object(xr, "SimulatedHeadset", return_value=headset), \
                mock.patch.object(xr.openxr_runtime, "manifest", return_value=runtime), \
                mock.patch.object(xr.display, "has_display", return_value=screen), \
                mock.patch.object(xr.session, "open_project", return_value=0) as opened, \
                contextlib.redirect_stderr(printed):
            self.assertEqual(xr.run(list(arguments)), 0)
        self.assertEqual(headset.__exit__.called, "--simulated" in arguments)
        return list(opened.call_args.args), printed.getvalue()

    def test_simulated(self) -> None:
        opened, printed = self._run("--simulated", "--", "--verbose")
        words = ["--xr-mode", "on", xr.SCENE, "--rendering-method", "mobile", "--verbose"]
        self.assertEqual(opened[:2], ["godot", words])
        self.assertEqual(opened[2]["XR_RUNTIME_JSON"], "/m.json")
        self.assertIn("remote.py --port 4711", printed)

    def test_with_a_runtime(self) -> None:
        opened, printed = self._run(runtime=Path("/etc/runtime.json"))
        self.assertEqual(opened[:2], ["godot", ["--xr-mode", "on", xr.SCENE]])
        self.assertNotIn("XR_RUNTIME_JSON", opened[2])
        self.assertIn("/etc/runtime.json", printed)

    def test_without_a_runtime_it_starts_and_says_what_helps(self) -> None:
        opened, printed = self._run()
        self.assertEqual(opened[0], "godot")
        self.assertIn("./run xr --simulated", printed)

    def test_without_a_screen_it_is_silent(self) -> None:
        opened, _ = self._run(screen=False)
        self.assertEqual(opened[1], ["--xr-mode", "on", "--audio-driver", "Dummy", xr.SCENE])


class Runtime(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)
        self.env = {"HOME": str(self.folder / "home"), "XDG_CONFIG_DIRS": str(self.folder / "xdg")}

    def _make(self, name: str) -> Path:
        file = self.folder / name
        file.parent.mkdir(parents=True)
        file.touch()
        return file

    def _found(self) -> Path | None:
        return openxr_runtime.manifest(self.env, (str(self.folder / "etc"),))

    def test_the_order(self) -> None:
        self.assertIsNone(self._found())
        for name in (
            "etc/openxr/1/active_runtime.json", "xdg/openxr/1/active_runtime.x86_64.json",
            "home/.config/openxr/1/active_runtime.json",
        ):
            file = self._make(name)
            self.assertEqual(self._found(), file)
        self.env["XR_RUNTIME_JSON"] = str(self._make("mine/runtime.json"))
        self.assertEqual(self._found(), self.folder / "mine/runtime.json")

    def test_what_is_gone_does_not_count(self) -> None:
        folder = self.folder / "xdg/openxr/1"
        folder.mkdir(parents=True)
        (folder / "active_runtime.json").symlink_to("/nowhere/steamxr.json")
        self.assertIsNone(self._found())
        self._make("home/.config/openxr/1/active_runtime.json")
        self.env["XR_RUNTIME_JSON"] = "/nowhere/runtime.json"
        self.assertIsNone(self._found())


if __name__ == "__main__":
    unittest.main()
