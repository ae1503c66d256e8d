# SPDX-License-Identifier: MIT
import socket
import subprocess
import tempfile
import unittest
from pathlib import Path

from setup import display

_SCRIPT = Path(__file__).parent / "godot_env.sh"


class Display(unittest.TestCase):
    def test_none(self) -> None:
        self.assertFalse(display.has_display({}))

    def test_a_display_that_nobody_serves_does_not_count(self) -> None:
        self.assertFalse(display.has_display({"DISPLAY": ":4711"}))
        self.assertFalse(display.has_display({"DISPLAY": "nonsense"}))

    def test_a_wayland_session_that_answers(self) -> None:
        with tempfile.TemporaryDirectory() as folder, socket.socket(socket.AF_UNIX) as server:
            session = {"WAYLAND_DISPLAY": "wayland-0", "XDG_RUNTIME_DIR": folder}
            self.assertFalse(display.has_display(session))
            server.bind(f"{folder}/wayland-0")
            server.listen()
            self.assertTrue(display.has_display(session))
            self.assertEqual(display.on_screen(["godot"], session), ["godot"])
            session["BLACKHOLE_VIRTUAL_DISPLAY"] = "1"
            self.assertEqual(display.on_screen(["godot"], session)[0], "xvfb-run")


class Drivers(unittest.TestCase):
    """godot_env.sh, in a folder that stands for the private copy."""

    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.root = Path(holder.name) / "root"
        drivers = self.root / "usr/share/vulkan/icd.d"
        drivers.mkdir(parents=True)
        for name in ("intel_icd.json", "lvp_icd.json", "radeon_icd.json"):
            (drivers / name).touch()
        self.devices = Path(holder.name) / "dev"
        (self.devices / "dri").mkdir(parents=True)
        self.system = Path(holder.name) / "share"
        (self.system / "vulkan/icd.d").mkdir(parents=True)

    def _vulkan(self, **env: str) -> list[str]:
        text = _SCRIPT.read_text(encoding="utf-8").replace("/dev/", f"{self.devices}/")
        text = text.replace("/usr/share/vulkan", f"{self.system}/vulkan").replace(f'"$root"{self.system}', '"$root"/usr/share')
        text += '\nprintf %s "$VK_DRIVER_FILES"\n'
        values = {"root": str(self.root), "libraries": "/l", "PATH": "/usr/bin:/bin", **env}
        done = subprocess.run(["sh", "-euc", text], env=values, stdout=subprocess.PIPE, text=True, check=True)
        return [Path(name).name for name in done.stdout.split(":")]

    def test_without_a_card_the_software_driver(self) -> None:
        self.assertEqual(self._vulkan(), ["lvp_icd.json"])

    def test_with_a_card_its_drivers_come_first(self) -> None:
        (self.devices / "dri/renderD128").touch()
        self.assertEqual(self._vulkan(), ["intel_icd.json", "radeon_icd.json", "lvp_icd.json"])

    def test_the_driver_of_nvidia_is_the_systems(self) -> None:
        (self.system / "vulkan/icd.d/nvidia_icd.json").touch()
        self.assertEqual(self._vulkan(), ["lvp_icd.json"], "a description without a card is not used")
        (self.devices / "nvidiactl").touch()
        self.assertEqual(self._vulkan(), ["nvidia_icd.json", "lvp_icd.json"])

    def test_what_the_user_has_set_stays(self) -> None:
        self.assertEqual(self._vulkan(VK_DRIVER_FILES="/mine.json"), ["mine.json"])
