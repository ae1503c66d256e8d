# SPDX-License-Identifier: MIT
"""Which Godot is it? Versions as the engine prints them."""

from __future__ import annotations

import re
from pathlib import Path

from setup import paths, process, stamps

MINIMUM = (4, 6)
MINIMUM_TEXT = "4.6"


def parse(text: str) -> tuple[int, int, int] | None:
    """(major, minor, patch) of a line such as `4.6.3.stable.debian` or `4.7.beta1`; None when it is no version."""
    match = re.match(r"\s*v?(\d+)\.(\d+)(?:\.(\d+))?", text)
    if not match:
        return None
    return int(match.group(1)), int(match.group(2)), int(match.group(3) or 0)


def is_enough(version: tuple[int, int, int] | None) -> bool:
    """True from Godot 4.6 on, within the 4 series."""
    return version is not None and version[0] == MINIMUM[0] and version[:2] >= MINIMUM


def of_executable(executable: Path) -> tuple[int, int, int] | None:
    """Asks an executable for its version; remembered until the file changes. None when it does not start."""
    try:
        state = executable.stat()
    except OSError:
        return None
    stamp = paths.STAMPS / f"godot-version-{stamps.digest(executable, state.st_mtime_ns, state.st_size)[:16]}"
    try:
        return parse(stamp.read_text(encoding="utf-8"))
    except OSError:
        pass
    printed = process.capture([executable, "--headless", "--version"])
    last = printed.strip().splitlines()[-1] if printed and printed.strip() else ""
    version = parse(last)
    if version:
        stamps.write(stamp, last)
    return version
