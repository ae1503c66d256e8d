# SPDX-License-Identifier: MIT
"""Has this machine an OpenXR runtime, such as a headset's software installs?"""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

_NAME = "openxr/1/active_runtime*.json"


def manifest(env: Mapping[str, str] = os.environ, system: tuple[str, ...] = ("/etc", "/usr/local/etc")) -> Path | None:
    """The manifest that the OpenXR loader will take, or None: the variable's, else the user's, else the system's."""
    named = env.get("XR_RUNTIME_JSON")
    if named:
        return Path(named) if Path(named).is_file() else None
    folders = [env.get("XDG_CONFIG_HOME") or f"{env.get('HOME', '/')}/.config"]
    folders += (env.get("XDG_CONFIG_DIRS") or "/etc/xdg").split(":")
    for folder in (*folders, *system):
        for file in sorted(Path(folder).glob(_NAME)):
            if file.is_file():  # a link that leads nowhere is left by a runtime that was removed
                return file
    return None
