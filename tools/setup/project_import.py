# SPDX-License-Identifier: MIT
"""Lets Godot import the project's assets, once and again whenever they changed."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

from setup import paths, process, stamps
from setup.console import say
from setup.godot import Godot
from setup.locks import locked

_EXTENSION = "res://addons/blackhole_sky/blackhole_sky.gdextension"


def ensure_imported(godot: Godot, root: Path = paths.ROOT) -> None:
    """Runs the engine's import when a file of the project is new, gone or changed since the last one."""
    with locked(paths.BUILD / "import.lock", "importing the project"):
        stamp = root / ".godot" / "imported.stamp"
        if stamps.is_fresh(stamp, _wanted(godot, root)):
            return
        say("Importing the project")
        _announce_extension(root)
        log = paths.LOGS / "import.log"
        command = [godot.executable, "--headless", "--path", root, "--import"]
        process.require(command, log, "Importing the project", timeout_s=600)
        stamps.write(stamp, _wanted(godot, root))  # after: the import itself writes files beside the assets


def project_files(root: Path) -> Iterator[Path]:
    """The files that Godot sees: not the hidden folders, nor those with a .gdignore, nor what is built."""
    for folder, names, files in os.walk(root):
        here = Path(folder)
        if here != root and ".gdignore" in files:
            names.clear()
            continue
        names[:] = sorted(name for name in names if not name.startswith("."))
        yield from (here / name for name in sorted(files) if not name.startswith("."))


def _wanted(godot: Godot, root: Path) -> str:
    states = []
    for file in project_files(root):
        try:
            state = file.stat()
        except FileNotFoundError:
            continue
        # The library is loaded, not imported: a new build is no reason to import again.
        if file.suffix != ".so":
            states.append(f"{file.relative_to(root)} {state.st_mtime_ns} {state.st_size}")
    return stamps.digest(godot.version, *states)


def _announce_extension(root: Path) -> None:
    """Godot 4.6 aborts at the end of a project's first import when it meets an extension only then; it is told
    before, in the list that it would write itself."""
    known = root / ".godot" / "extension_list.cfg"
    if not known.exists():
        known.parent.mkdir(exist_ok=True)
        known.write_text(_EXTENSION + "\n", encoding="utf-8")
