# SPDX-License-Identifier: MIT
"""Starting Godot on the project: in the open for the visitor, or quietly for a script that works and ends."""

from __future__ import annotations

import os
import re
import subprocess
import tempfile
from collections.abc import Callable, Mapping
from pathlib import Path

from setup import display, paths, process
from setup.console import Failure, tail
from setup.godot import Godot
from setup.simulated_headset import SimulatedHeadset

RENDERERS = ("mobile", "forward_plus", "gl_compatibility")
_TIMEOUT_S = 3600.0
# A script's reasons are the lines that start like this; everything else the engine prints is noise.
_REASON = ("capture:", "bench:", "SCRIPT ERROR:", "SHADER ERROR:")
# The engine goes on without a script or shader that does not compile; what it then draws or measures is worth nothing.
_BROKEN = re.compile(r"^(SCRIPT|SHADER) ERROR:", re.MULTILINE)


def open_project(godot: Godot, arguments: list[str], variables: Mapping[str, str] | None = None) -> int:
    """Starts the project in a window (or the editor) and waits until it is closed. `variables` join the environment."""
    return start(display.on_screen([str(godot.executable), "--path", str(paths.ROOT), *arguments]), variables)


def start(command: list[str], variables: Mapping[str, str] | None = None) -> int:
    """Runs a command in the open and returns its exit status. `variables` join the environment."""
    try:
        return subprocess.run(command, env={**os.environ, **(variables or {})}, check=False).returncode
    except KeyboardInterrupt:
        return 130


def script_command(
    godot: Godot, script: str, renderer: str, arguments: list[str], in_headset: bool = False
) -> list[str]:
    """The command that runs a script of the project as main loop where it can draw."""
    headset = ["--xr-mode", "on"] if in_headset else []
    return display.on_screen([
        str(godot.executable), "--path", str(paths.ROOT), "--rendering-method", renderer,
        "--audio-driver", "Dummy", *headset, "-s", script, "--", *arguments,
    ])


def run_script(
    godot: Godot, script: str, renderer: str, arguments: list[str], base: Path | None = None,
    on_line: Callable[[str], None] | None = None, headset: SimulatedHeadset | None = None,
) -> str:
    """Runs a script to its end and returns what it and the engine printed; its exit status as a Failure.

    The script learns `base` (else the current folder) as the place from which the visitor's relative paths count.
    on_line sees each line that is printed; a script so watched may take its time.
    """
    paths.LOGS.mkdir(parents=True, exist_ok=True)
    name = Path(script).stem
    handle, log_name = tempfile.mkstemp(prefix=f"{name}-{renderer}-", suffix=".log", dir=paths.LOGS)
    os.close(handle)
    log = Path(log_name)
    env = {**os.environ, "BLACKHOLE_CALLER_DIR": str(base or Path.cwd())}
    if headset is not None:
        env |= headset.environment()
    command = script_command(godot, script, renderer, arguments, headset is not None)
    status = process.run_logged(command, log, env=env, timeout_s=_TIMEOUT_S, on_line=on_line)
    printed = log.read_text(encoding="utf-8", errors="replace")
    if status != 0 or _BROKEN.search(printed):
        why = reason(printed) or tail(log)
        raise Failure(f"{why}\n(exit status {status}; all of the output is in {log})", status or 1)
    log.unlink()
    return printed


def reason(printed: str) -> str:
    """The lines of a script's output that say why it failed."""
    return "\n".join(line for line in printed.splitlines() if line.lstrip().startswith(_REASON))
