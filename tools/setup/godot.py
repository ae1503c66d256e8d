# SPDX-License-Identifier: MIT
"""Finds Godot: the one named in $GODOT, one on PATH, or a private copy in the user's cache."""

from __future__ import annotations

import os
import shutil
from dataclasses import dataclass
from pathlib import Path

from setup import godot_version, paths, private_copy
from setup.console import Failure


@dataclass(frozen=True)
class Godot:
    """An engine that is new enough. `private` is true for the copy that this project keeps."""

    executable: Path
    version: str
    private: bool


def find() -> Godot:
    """The engine to use; brings the private copy when the machine has none. A Failure says what to do."""
    named = os.environ.get("GODOT")
    if named:
        return _named(named)
    for name in ("godot4", "godot"):
        found = shutil.which(name)
        version = godot_version.of_executable(Path(found)) if found else None
        if found and version and godot_version.is_enough(version):
            return Godot(Path(found), _text(version), private=False)
    executable, text = private_copy.bring()
    return Godot(executable, text, private=True)


def _named(named: str) -> Godot:
    executable = Path(shutil.which(named) or named).absolute()
    version = godot_version.of_executable(executable)
    if version is None:
        raise Failure(f"$GODOT is '{named}', which does not start as Godot. Correct or unset it.", 3)
    if not godot_version.is_enough(version):
        raise Failure(
            f"$GODOT is Godot {_text(version)}, and this project needs {godot_version.MINIMUM_TEXT} or newer "
            "of the 4 series. Correct or unset it.",
            3,
        )
    return Godot(executable, _text(version), private=executable.is_relative_to(paths.cache_dir()))


def _text(version: tuple[int, int, int]) -> str:
    return ".".join(str(part) for part in version)
