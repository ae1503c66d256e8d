# SPDX-License-Identifier: MIT
"""The version of what is handed on: the addon's, from its plugin.cfg."""

from __future__ import annotations

import re
from pathlib import Path

from setup import paths
from setup.console import Failure

FILE = paths.ROOT / "addons" / "blackhole_sky" / "plugin.cfg"


def text(file: Path = FILE) -> str:
    """Such as 0.1.0."""
    match = re.search(r'^version="([0-9A-Za-z.+-]+)"$', file.read_text(encoding="utf-8"), re.MULTILINE)
    if not match:
        raise Failure(f'{file} has no line version="..."; add it.')
    return match.group(1)
