# SPDX-License-Identifier: MIT
"""Configures and builds the C++ side with the presets of gdextension/CMakePresets.json."""

from __future__ import annotations

import os
import re
from pathlib import Path

from setup import paths, process, stamps
from setup.console import Failure, Progress, note, say
from setup.godot import Godot
from setup.locks import locked


def build(preset: str, godot: Godot | None, target: str = "all") -> Path:
    """Brings `target` in build/PRESET up to date and returns that folder; quick when nothing changed.

    The engine's own description of its API is asked from `godot`. $GODOT_CPP_DIR names a folder with upstream
    godot-cpp to build against; without it CMake decides.
    """
    folder = paths.BUILD / preset
    with locked(paths.BUILD / f"{preset}.lock", f"building {preset}"):
        _configure(preset, folder, godot)
        _compile(preset, folder, target)
    return folder


def _configure(preset: str, folder: Path, godot: Godot | None) -> None:
    options = [f"-DGODOT_EXECUTABLE={godot.executable}"] if godot else []
    if upstream := os.environ.get("GODOT_CPP_DIR"):
        options.append(f"-DGODOT_CPP_DIR={os.path.abspath(upstream)}")
    presets = (paths.SOURCES / "CMakePresets.json").read_text(encoding="utf-8")
    wanted = stamps.digest(folder, presets, godot.version if godot else "", *options)
    stamp = folder / "configured.stamp"
    if (folder / "build.ninja").exists() and stamps.is_fresh(stamp, wanted):
        return  # Ninja itself configures again when a CMake file changed
    say(f"Configuring the build ({preset})")
    log = paths.LOGS / f"configure-{preset}.log"
    (folder / "CMakeCache.txt").unlink(missing_ok=True)  # what an earlier configuration chose is not to linger
    process.require(["cmake", "--preset", preset, *options], log, "Configuring the build", cwd=paths.SOURCES)
    stamps.write(stamp, wanted)


def _compile(preset: str, folder: Path, target: str) -> None:
    log = paths.LOGS / f"build-{preset}.log"
    progress = Progress(f"built ({preset})")
    announced = False

    def watch(line: str) -> None:
        nonlocal announced
        match = re.match(r"\[(\d+)/(\d+)\]", line)
        if not match or match.group(1) == "0":  # looking whether there is work is no work
            return
        if not announced:
            say(f"Building ({preset})")
            note(f"Details in {log}")
            announced = True
        progress.update(int(match.group(1)), int(match.group(2)))

    status = process.run_logged(["cmake", "--build", folder, "--target", target], log, on_line=watch)
    progress.close()
    if status != 0:
        raise Failure(f"The build ({preset}) failed. From {log}:\n{first_error(log.read_text(errors='replace'))}")


def first_error(printed: str) -> str:
    """The output of the first command that failed, of which the others are often consequences."""
    lines = printed.splitlines()
    begin = next((number for number, line in enumerate(lines) if line.startswith("FAILED:")), max(0, len(lines) - 30))
    return "\n".join("    | " + line[:300] for line in lines[begin : begin + 30])
