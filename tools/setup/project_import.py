# SPDX-License-Identifier: MIT
"""Lets Godot import the project's assets, once and again whenever they changed."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from pathlib import Path

from setup import paths, process, stamps
from setup.console import say
from setup.godot import Godot
from setup.locks import locked

_LOADED_AS_IT_IS = frozenset((
    ".tscn", ".tres", ".gdshader", ".gdshaderinc", ".gdextension", ".uid", ".json", ".md", ".txt", ".stars", ".lut",
))
_CLASS_LINE = re.compile(r"^(?:@tool|@abstract|@icon\(.*|class_name\b.*|extends\b.*)$", re.MULTILINE)
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
    return stamps.digest(godot.version, *filter(None, (_state(file, root) for file in project_files(root))))


def _state(file: Path, root: Path) -> str:
    """What the import takes from a file: of a script its class, of what is loaded as it is only that it is there."""
    name = str(file.relative_to(root))
    try:
        if file.suffix in (".so", ".dll"):
            return ""
        if file.suffix in _LOADED_AS_IT_IS:
            return name
        if file.suffix == ".gd":
            return name + " ".join(_CLASS_LINE.findall(file.read_text(encoding="utf-8")))
        state = file.stat()
        return f"{name} {state.st_mtime_ns} {state.st_size}"
    except FileNotFoundError:
        return ""


def _announce_extension(root: Path) -> None:
    """Godot 4.6 aborts at the end of a project's first import when it meets an extension only then; it is told
    before, in the list that it would write itself."""
    known = root / ".godot" / "extension_list.cfg"
    if not known.exists():
        known.parent.mkdir(exist_ok=True)
        known.write_text(_EXTENSION + "\n", encoding="utf-8")
