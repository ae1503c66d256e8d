# SPDX-License-Identifier: MIT
"""Is there a screen to draw on? When there is none, a virtual one serves."""

from __future__ import annotations

import os
import re
import socket
from collections.abc import Mapping
from pathlib import Path

_VIRTUAL = ["xvfb-run", "-a", "-s", "-screen 0 1280x720x24"]


def has_display(env: Mapping[str, str] = os.environ) -> bool:
    """True when a graphical session answers. A DISPLAY left over from a closed session does not count.

    BLACKHOLE_VIRTUAL_DISPLAY=1 asks for the virtual screen although there is a real one.
    """
    if env.get("BLACKHOLE_VIRTUAL_DISPLAY") == "1":
        return False
    return _wayland_answers(env) or _x11_answers(env.get("DISPLAY", ""))


def on_screen(command: list[str], env: Mapping[str, str] = os.environ) -> list[str]:
    """The command as it must be started to draw: as it is, or on a virtual screen."""
    return command if has_display(env) else [*_VIRTUAL, *command]


def _wayland_answers(env: Mapping[str, str]) -> bool:
    name = env.get("WAYLAND_DISPLAY", "")
    if not name:
        return False
    return _unix_socket_answers(str(Path(env.get("XDG_RUNTIME_DIR", "/")) / name))


def _x11_answers(display: str) -> bool:
    match = re.fullmatch(r"(?:unix)?([^:/]*):(\d+)(?:\.\d+)?", display)
    if not match:
        return False
    host, number = match.group(1), int(match.group(2))
    if host:
        try:
            socket.create_connection((host, 6000 + number), timeout=1.0).close()
        except OSError:
            return False
        return True
    path = f"/tmp/.X11-unix/X{number}"
    return _unix_socket_answers(path) or _unix_socket_answers("\0" + path)


def _unix_socket_answers(address: str) -> bool:
    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as probe:
        probe.settimeout(1.0)
        try:
            probe.connect(address)
        except OSError:
            return False
    return True
