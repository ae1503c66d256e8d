# SPDX-License-Identifier: MIT
"""The version of what is handed on: the addon's, from its plugin.cfg."""

from __future__ import annotations

import re
from pathlib import Path

from setup import paths
from setup.console import Failure

FILE = paths.ROOT / "addons" / "blackhole_sky" / "plugin.cfg"


def text(file: Path = FILE) -> str:
    """The text in the file, such as 1.2.3."""
    match = re.search(r'^version="([0-9A-Za-z.+-]+)"$', file.read_text(encoding="utf-8"), re.MULTILINE)
    if not match:
        raise Failure(f'{file} has no line version="..."; add it.')
    return match.group(1)


def number(version: str) -> int:
    """A whole number that grows with the version, as Android wants it: 10203 for 1.2.3."""
    major, minor, patch = (int(part) for part in re.findall(r"\d+", version)[:3])
    return major * 10000 + minor * 100 + patch
