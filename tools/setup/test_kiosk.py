# SPDX-License-Identifier: MIT
import contextlib
import io
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from setup import kiosk
from setup.console import Failure


class Arguments(unittest.TestCase):
    def test_right_ones(self) -> None:
        for arguments, simulated, engine, exhibit in (
            ([], False, [], []),
            (["--simulated"], True, [], []),
            (["--", "--verbose"], False, ["--verbose"], []),
            (["--simulated", "--", "--resolution", "640x360", "--", "--time-scale=9"],
             True, ["--resolution", "640x360"], ["--time-scale=9"]),
            (["--", "--", "--few-stars"], False, [], ["--few-stars"]),
        ):
            with self.subTest(arguments):
                wish = kiosk.parse(arguments)
                self.assertEqual((wish.simulated, wish.engine, wish.exhibit), (simulated, engine, exhibit))
                self.assertIsNone(wish.config)

    def test_wrong_ones(self) -> None:
        for arguments in (["fast"], ["--simulate"], ["--config"], ["--config", "--"], ["--simulated", "fast"]):
            with self.subTest(arguments), self.assertRaisesRegex(Failure, "usage:") as caught:
                kiosk.parse(arguments)
            self.assertEqual(caught.exception.code, 2)

    def test_a_settings_file(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "kiosk.json"
            with self.assertRaisesRegex(Failure, str(file)) as caught:
                kiosk.parse(["--config", str(file)])
            self.assertEqual(caught.exception.code, 2)
            file.write_text("{}", encoding="utf-8")
            wish = kiosk.parse(["--config", str(file), "--", "--verbose"])
        self.assertEqual(wish.config, file)
        self.assertEqual(kiosk.engine_arguments(wish), [
            "--headless", kiosk.SUPERVISOR, "--", "--supervise", f"--kiosk-config={file}", "--engine=--verbose",
        ])


class Run(unittest.TestCase):
    def _run(self, *arguments: str, screen: bool = True) -> list[object]:
        """What the project was opened with."""
        headset = mock.MagicMock()
        headset.__enter__.return_value = mock.Mock(port=4711, environment=lambda: {"XR_RUNTIME_JSON": "/m.json"})
        with mock.patch.object(kiosk.prepare, "project", return_value="godot"), \
                mock.patch.object(kiosk.monado, "find", return_value="monado"), \
                mock.patch.object(kiosk, "SimulatedHeadset", return_value=headset), \
                mock.patch.object(kiosk.display, "has_display", return_value=screen), \
                mock.patch.object(kiosk.session, "open_project", return_value=0) as opened, \
                contextlib.redirect_stderr(io.StringIO()):
            self.assertEqual(kiosk.run(list(arguments)), 0)
        self.assertEqual(headset.__exit__.called, "--simulated" in arguments)
        return list(opened.call_args.args)

    def test_plain(self) -> None:
        self.assertEqual(self._run(), ["godot", ["--headless", kiosk.SUPERVISOR, "--", "--supervise"], {}])

    def test_simulated(self) -> None:
        opened = self._run("--simulated", "--", "--verbose")
        self.assertEqual(opened[2], {"XR_RUNTIME_JSON": "/m.json"})
        words = ["--engine=--rendering-method", "--engine=mobile", "--engine=--verbose"]
        self.assertEqual(opened[1], ["--headless", kiosk.SUPERVISOR, "--", "--supervise", *words])

    def test_without_a_display_it_says_so(self) -> None:
        with self.assertRaisesRegex(Failure, "display") as caught:
            self._run(screen=False)
        self.assertEqual(caught.exception.code, 3)


if __name__ == "__main__":
    unittest.main()
