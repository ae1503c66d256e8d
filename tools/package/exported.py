# SPDX-License-Identifier: MIT
"""An exported program, started as its user would: from another folder, with another home, without the sources."""

from __future__ import annotations

import json
import re
import subprocess
import time
from collections.abc import Mapping, Sequence
from pathlib import Path

from kiosk.running_exhibit import RunningExhibit
from package import version
from package.engine_output import complaints
from setup import display, kiosk, paths, process
from setup.console import tail

_SETTINGS = {"mode": "screen", "fullscreen": False, "daily_restart_hour": -1}
_READY_S = 90.0
_DEMO_FRAMES = 30
# Godot 4.6.3's release template, and neither its debug template nor the editor, says this of each child of a container
# while it frees the demo's scene at the end. The signals and their connections are the containers' own.
_AT_THE_END = re.compile(
    r"ERROR: Attempt to disconnect a nonexistent connection from '.*'\. "
    r"Signal: '(?:size_flags_changed|visibility_changed)', callable: ''\.$"
)
# Drawn fast where the processor draws.
_SMALL = ("--resolution", "320x180")


class ExportedProgram:
    """The program; `folder` is its user's home, which is made. Each method says what is wrong, or nothing."""

    def __init__(self, program: Path, folder: Path, environment: Mapping[str, str]) -> None:
        self._program = program
        self._folder = folder
        self._environment = {**environment, "HOME": str(folder), "XDG_DATA_HOME": str(folder / "data")}
        folder.mkdir(parents=True, exist_ok=True)

    def self_test(self, renderer: str) -> str:
        """It says PASS and which versions it is of."""
        status, printed, wrong = self._run(["--rendering-method", renderer, "--self-test"], f"self-test-{renderer}")
        wanted = ("PASS: ", f"addon     {version.text()}\n", "godot     4.", f"renderer  {renderer}\n")
        wrong += [f"it does not print '{words.strip()}'" for words in wanted if words not in printed]
        return _sentences(status, wrong, printed)

    def demo(self) -> str:
        """It draws a short film without an error: slowly enough for the scene to be there before the end."""
        film = self._folder / "film"
        film.mkdir(exist_ok=True)
        words = [*_SMALL, "--write-movie", film / "picture.png", "--fixed-fps", "10", "--quit-after", str(_DEMO_FRAMES)]
        status, printed, wrong = self._run(words, "demo")
        wrong = [line for line in wrong if not _AT_THE_END.match(line)]
        if len(list(film.glob("*.png"))) < _DEMO_FRAMES:
            wrong.append(f"it drew fewer than {_DEMO_FRAMES} pictures into {film}")
        return _sentences(status, wrong, printed)

    def exhibit(self) -> str:
        """Its supervisor brings up the exhibit, with the settings beside the program, and both end."""
        settings = self._program.parent / "kiosk.json"
        settings.write_text(json.dumps({**_SETTINGS, "log_folder": str(self._folder / "logs")}), encoding="utf-8")
        logs, log = self._folder / "logs", self._log("exhibit")
        log.parent.mkdir(parents=True, exist_ok=True)
        handed = [f"--engine={word}" for word in ("--audio-driver", "Dummy", *_SMALL)]
        command = [str(self._program), "--headless", "--supervise", "--", *handed]
        with log.open("wb") as sink, RunningExhibit(
            self._program, kiosk.Wish(), logs, self._environment, sink, command,
        ) as running:
            deadline = time.monotonic() + _READY_S
            while not running.beat().get("ready") and time.monotonic() < deadline and running.status() is None:
                time.sleep(0.2)
            ready = running.beat().get("ready")
        wrong = [] if ready else [f"the exhibit was not ready within {_READY_S:.0f} s"]
        if running.outlived:
            wrong.append("it did not end when its supervisor was gone")
        told = (logs / "kiosk.log").read_text(encoding="utf-8") if (logs / "kiosk.log").exists() else ""
        if str(settings) not in told:
            wrong.append(f"kiosk.log does not name {settings}")
        return "\n".join([*wrong, f"The end of {log}:\n{tail(log)}"]) if wrong else ""

    def _run(self, arguments: Sequence[object], name: str) -> tuple[int, str, list[str]]:
        log = self._log(name)
        command = display.on_screen([str(self._program), "--audio-driver", "Dummy", *map(str, arguments)])
        status = process.run_logged(command, log, cwd=self._folder, env=self._environment, timeout_s=240)
        printed = log.read_text(encoding="utf-8", errors="replace")
        return status, printed, complaints(printed)

    def _log(self, name: str) -> Path:
        return paths.LOGS / f"exported-{name}.log"


def variables(script: Path) -> dict[str, str]:
    """The environment after a shell has sourced a script."""
    printed = subprocess.run(["sh", "-c", f'. "{script}"; env -0'], stdout=subprocess.PIPE, check=True).stdout
    return dict(entry.split("=", 1) for entry in printed.decode().split("\0") if "=" in entry)


def _sentences(status: int, wrong: list[str], printed: str) -> str:
    if status == 0 and not wrong:
        return ""
    return "\n".join([*wrong, f"exit status {status}", *printed.splitlines()[-20:]])
