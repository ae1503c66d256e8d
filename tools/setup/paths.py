# SPDX-License-Identifier: MIT
"""Where things are: the project's folders and the user's cache."""

from __future__ import annotations

import os
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
BUILD = ROOT / "build"
OUT = ROOT / "out"
LOGS = BUILD / "logs"
STAMPS = BUILD / "stamps"
SOURCES = ROOT / "gdextension"


def cache_dir() -> Path:
    """The user's cache for this project, shared by every clone on the machine."""
    base = os.environ.get("XDG_CACHE_HOME") or str(Path.home() / ".cache")
    return Path(base).resolve() / "blackhole_sky"
