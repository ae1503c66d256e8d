# SPDX-License-Identifier: MIT
"""Settings that are killed while they are written: the old or the new ones are there at the next start."""

from __future__ import annotations

import os
import random
import shutil
import signal
import subprocess
import tempfile
import time
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

_ROOT = Path(__file__).resolve().parent.parent.parent
_SETTINGS = _ROOT / "scenes" / "settings"
# Scripts from elsewhere that they use.
_BESIDES = [
    _ROOT / "addons" / "blackhole_sky" / "overlays" / "bounded_text.gd",
    _ROOT / "scenes" / "capture" / "json_words.gd",
    _ROOT / "scenes" / "capture" / "json_kinds.gd",
]
_WRITER = _ROOT / "tests" / "power_cut" / "write_settings.gd"
_KILLS = 200 if os.environ.get("BLACKHOLE_TEST_ALL") == "1" else 15
_STREAMS = 2
_LONGEST_S = 0.03
_GODOT = os.environ.get("GODOT")


@unittest.skipUnless(_GODOT, "needs the engine: run by ./test")
class PowerCut(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.project = Path(holder.name) / "project"
        self.home = Path(holder.name)
        self._make_project()

    def _make_project(self) -> None:
        """The scripts that write settings, and no more: it starts quickly."""
        self.project.mkdir()
        (self.project / "project.godot").write_text("config_version=5\n", encoding="utf-8")
        for script in _BESIDES:
            shutil.copy(script, self.project)
        for script in [*_SETTINGS.rglob("*.gd"), _WRITER]:
            text = script.read_text(encoding="utf-8")
            if script.parent.name in ("values", "settings", "power_cut") or "binding" in script.parent.name:
                if "BindingNames" not in text and "extends MenuScreen" not in text:
                    shutil.copy(script, self.project)
        done = subprocess.run(
            [str(_GODOT), "--headless", "--path", self.project, "--import"],
            capture_output=True, text=True, timeout=60, check=False,
        )
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def _run_and_kill(self, file: Path, rested: bool, chance: random.Random) -> list[str]:
        """What the writer said, line by line; the last one may be cut."""
        environment = {**os.environ, "SETTINGS_FILE": str(file), "RESTED": str(int(rested))}
        command = [str(_GODOT), "--headless", "--path", str(self.project), "-s", f"res://{_WRITER.name}"]
        with subprocess.Popen(
            command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=environment, start_new_session=True,
        ) as running:
            assert running.stdout is not None
            said: list[str] = []
            for line in running.stdout:
                said.append(line.rstrip("\n"))
                if line.startswith("begin"):
                    break
            time.sleep(chance.uniform(0.0, _LONGEST_S))
            os.killpg(running.pid, signal.SIGKILL)
            said += running.stdout.read().split("\n")
        return said

    def _kill_again_and_again(self, stream: int) -> list[str]:
        """What was wrong after one of the kills, each time in words."""
        file = self.home / str(stream) / "settings.json"
        chance = random.Random(stream)
        possible = {100}
        written = 0
        for number in range(_KILLS // _STREAMS + 2):
            said = self._run_and_kill(file, number % 2 == 1, chance)
            found = [line.split(" ", 2) for line in said if line.startswith("found ")]
            if len(found) != 1 or found[0][2] or int(found[0][1]) not in possible:
                return [f"kill {number}: {found} instead of {possible}: {said[-5:]}"]
            done = [int(line[5:]) for line in said if line.startswith("done ") and line[5:].isdigit()]
            last = done[-1] if done else int(found[0][1])
            possible = {last, (last + 1) % 101}
            written += len(done)
        return [] if written > _KILLS else [f"it wrote {written} times only: it was not killed amid writing"]

    def test_a_kill_at_any_moment_leaves_the_old_or_the_new_settings(self) -> None:
        with ThreadPoolExecutor(_STREAMS) as pool:
            for wrong in pool.map(self._kill_again_and_again, range(_STREAMS)):
                self.assertEqual(wrong, [])


if __name__ == "__main__":
    unittest.main()
