# SPDX-License-Identifier: MIT
"""gdformat and gdlint, the style tools for GDScript, in a virtual environment in the user's cache."""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

from setup import locks, paths, process, stamps
from setup.console import say

VERSION = "4.5.0"


def bring() -> Path:
    """The folder with the executables gdformat and gdlint; fetched from the Python package index once."""
    folder = paths.cache_dir() / f"gdtoolkit-{VERSION}"
    wanted = stamps.digest(folder, VERSION)
    stamp = folder / "stamp"
    if not stamps.is_fresh(stamp, wanted):
        with locks.locked(paths.cache_dir() / "gdtoolkit.lock", "bringing gdtoolkit"):
            if not stamps.is_fresh(stamp, wanted):
                _make(folder)
                stamps.write(stamp, wanted)
    return folder / "bin"


def _make(folder: Path) -> None:
    say(f"Bringing gdtoolkit {VERSION}, the style tools for GDScript (once)")
    log = paths.LOGS / "gdtoolkit.log"
    shutil.rmtree(folder, ignore_errors=True)
    process.require([sys.executable, "-m", "venv", folder], log, "Making a Python environment")
    install = [folder / "bin" / "python", "-m", "pip", "install", "--disable-pip-version-check", "-q"]
    process.require([*install, f"gdtoolkit=={VERSION}"], log, "Installing gdtoolkit", append=True)
