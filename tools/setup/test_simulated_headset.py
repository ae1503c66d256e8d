# SPDX-License-Identifier: MIT
import json
import os
import socket
import stat
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path
from unittest import mock

from setup.console import Failure
from setup.monado import Monado
from setup.simulated_headset import SimulatedHeadset

# Stands for the service: does what its config and environment say, with a child, whose id it prints.
_SERVICE = f"""#!{sys.executable}
import json, os, socket, subprocess, time
folder = os.environ["XDG_RUNTIME_DIR"]
assert os.environ["XRT_COMPOSITOR_NULL"] == os.environ["XRT_NO_STDIN"] == "1"
with open(os.environ["XDG_CONFIG_HOME"] + "/monado/config_v0.json") as file:
    config = json.load(file)
assert config["active"] == "remote" and config["remote"]["view_count"] == 2
hub = socket.create_server(("127.0.0.1", config["remote"]["port"]))
ipc = socket.socket(socket.AF_UNIX)
ipc.bind(folder + "/monado_comp_ipc")
child = subprocess.Popen(["sleep", "60"])
print("child", child.pid, flush=True)
print("Listening on port", flush=True)
time.sleep(60)
"""


def _lives(pid: int) -> bool:
    """True for a process that is there and no corpse."""
    try:
        state = Path(f"/proc/{pid}/stat").read_text(encoding="ascii").rpartition(")")[2].split()[0]
    except OSError:
        return False
    return state not in "ZX"


def _ends(pid: int) -> bool:
    """True when the process ends soon: a signal needs a moment."""
    deadline = time.monotonic() + 5.0
    while _lives(pid) and time.monotonic() < deadline:
        time.sleep(0.01)
    return not _lives(pid)


class Headset(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)

    def _headset(self, service: str = _SERVICE, patience_s: float = 10.0) -> SimulatedHeadset:
        path = self.folder / "monado-service"
        path.write_text(service, encoding="utf-8")
        path.chmod(0o755)
        return SimulatedHeadset(Monado(path, self.folder / "openxr_monado.json"), patience_s)

    def _children(self, headset: SimulatedHeadset) -> list[int]:
        """The children of the services so far, from the log."""
        lines = headset.log.read_text(encoding="utf-8").splitlines()
        return [int(line.split()[1]) for line in lines if line.startswith("child")]

    def test_a_place_and_a_port_of_its_own(self) -> None:
        with self._headset() as headset:
            self.assertEqual(stat.S_IMODE(headset.folder.stat().st_mode), 0o700)
            self.assertLess(len(str(headset.folder)), 40, "the path of a socket must be short")
            socket.create_connection(("127.0.0.1", headset.port), timeout=5).close()
            found = headset.environment()
            self.assertEqual(found["XR_RUNTIME_JSON"], str(self.folder / "openxr_monado.json"))
            self.assertEqual(found["XDG_RUNTIME_DIR"], str(headset.folder))
            self.assertEqual(found["BLACKHOLE_HEADSET_PORT"], str(headset.port))

    def test_nothing_is_left(self) -> None:
        with self._headset() as headset:
            child = self._children(headset)[0]
            self.assertTrue(_lives(child))
        self.assertFalse(headset.running)
        self.assertFalse(headset.folder.exists())
        self.assertTrue(_ends(child))

    def test_killed_and_started_again(self) -> None:
        with self._headset() as headset:
            headset.kill()
            self.assertFalse(headset.running)
            self.assertTrue(_ends(self._children(headset)[0]))
            headset.start()
            self.assertTrue(headset.running)
            socket.create_connection(("127.0.0.1", headset.port), timeout=5).close()

    def test_from_another_program(self) -> None:
        with self._headset() as headset:
            control = headset.environment()["BLACKHOLE_HEADSET_CONTROL"]
            for word, running in (("kill", False), ("start", True)):
                subprocess.run([control, word], check=True, timeout=20)
                self.assertEqual(headset.running, running)
            last = self._children(headset)[-1]
            done = subprocess.run([control, "fly"], capture_output=True, text=True, check=False, timeout=20)
            self.assertEqual(done.returncode, 1)
            self.assertIn("kill, start", done.stderr)
        self.assertTrue(_ends(last), "what another program had started is ended too")

    def test_a_failed_restart_is_told_to_the_other_program(self) -> None:
        with self._headset() as headset:
            control = headset.environment()["BLACKHOLE_HEADSET_CONTROL"]
            subprocess.run([control, "kill"], check=True, timeout=20)
            (self.folder / "monado-service").write_text("#!/bin/sh\necho worn out\nexit 4\n", encoding="utf-8")
            done = subprocess.run([control, "start"], capture_output=True, text=True, check=False, timeout=20)
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, r"status 4(.|\n)*worn out")

    def test_a_service_that_ends(self) -> None:
        headset = self._headset("#!/bin/sh\necho no device\nexit 3\n")
        with self.assertRaisesRegex(Failure, r"status 3(.|\n)*no device"):
            headset.__enter__()
        self.assertFalse(headset.folder.exists())

    def test_a_service_that_never_listens(self) -> None:
        headset = self._headset(_SERVICE.replace("Listening", "Deaf"), patience_s=0.5)
        with self.assertRaisesRegex(Failure, "not ready"):
            headset.__enter__()
        self.assertFalse(headset.running)
        self.assertFalse(headset.folder.exists())

    def test_it_ends_with_a_keeper_who_is_killed(self) -> None:
        keeper = (
            "import sys, time; from pathlib import Path; from setup.monado import Monado\n"
            "from setup.simulated_headset import SimulatedHeadset\n"
            "with SimulatedHeadset(Monado(Path(sys.argv[1]), Path('/none'))) as headset:\n"
            "    print(headset._service.pid, headset.folder, flush=True)\n"
            "    time.sleep(60)\n"
        )
        self._headset(_SERVICE.replace('["sleep", "60"]', '["true"]'))
        with subprocess.Popen(
            [sys.executable, "-c", keeper, str(self.folder / "monado-service")],
            cwd=Path(__file__).parent.parent, stdout=subprocess.PIPE, text=True,
        ) as process:
            assert process.stdout
            service, folder = process.stdout.readline().split()
            process.kill()
        self.addCleanup(subprocess.run, ["rm", "-r", folder], check=True)
        self.assertTrue(_ends(int(service)))

    def test_the_screen_of_a_wayland_session_is_still_found(self) -> None:
        session = {"WAYLAND_DISPLAY": "wayland-0", "XDG_RUNTIME_DIR": "/run/user/1"}
        with mock.patch.dict(os.environ, session), self._headset() as headset:
            self.assertEqual(headset.environment()["WAYLAND_DISPLAY"], "/run/user/1/wayland-0")

    def test_the_config(self) -> None:
        with self._headset() as headset:
            config = json.loads((headset.folder / "monado" / "config_v0.json").read_text(encoding="utf-8"))
        remote = {"version": 0, "port": headset.port, "view_count": 2}
        self.assertEqual(config, {"active": "remote", "remote": remote})


if __name__ == "__main__":
    unittest.main()
