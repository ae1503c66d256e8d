# SPDX-License-Identifier: MIT
"""Everything that must be there before Godot opens the project."""

from __future__ import annotations

from pathlib import Path

from setup import build, display, godot, packages, paths, project_import
from setup.godot import Godot


def engine(extra_packages: list[str] | None = None) -> Godot:
    """Godot and the system packages."""
    _hide_from_godot()
    found = godot.find()
    wanted = [*packages.BUILD, *(extra_packages or [])]
    if not display.has_display():
        wanted += packages.VIRTUAL_SCREEN
        if not found.private:
            wanted += packages.SOFTWARE_DRIVERS
    packages.ensure(wanted)
    return found


def table_tool() -> Path:
    """The built table tool."""
    return build.build("release", engine(), "blackhole-lut") / "lut_cli" / "blackhole-lut"


def project(extra_packages: list[str] | None = None) -> Godot:
    """engine(), the built extension and the imported project: ready to start."""
    found = engine(extra_packages)
    build.build("release", found)
    project_import.ensure_imported(found)
    return found


def _hide_from_godot() -> None:
    """What is built and written is none of the project's assets."""
    for folder in (paths.BUILD, paths.OUT):
        folder.mkdir(exist_ok=True)
        (folder / ".gdignore").touch()
