# SPDX-License-Identifier: MIT
"""The official export templates, where Godot's editor puts them: with these, programs run on other machines too."""

from __future__ import annotations

import os
from pathlib import Path

from setup import godot_version

# By Godot's word for the platform: what the editor unpacks, with {kind} for release or debug.
_FILES = {
    "Linux": "linux_{kind}.x86_64",
    "Windows Desktop": "windows_{kind}_x86_64.exe",
    "Android": "android_source.zip",
}


def file(platform: str, kind: str, engine: str) -> Path:
    """Where the template for a platform is when it is installed, for an engine of this version."""
    return folder(engine) / _FILES[platform].format(kind=kind)


def folder(engine: str) -> Path:
    """Where Godot looks for the templates of this version (Linux)."""
    version = godot_version.parse(engine)
    assert version is not None
    numbers = ".".join(str(part) for part in (version if version[2] else version[:2]))
    base = os.environ.get("XDG_DATA_HOME") or str(Path.home() / ".local" / "share")
    return Path(base) / "godot" / "export_templates" / f"{numbers}.stable"
