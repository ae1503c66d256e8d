# SPDX-License-Identifier: MIT
"""./run screens: every page and station of the programs as pictures, in every language and at two sizes."""

from __future__ import annotations

from pathlib import Path

from setup import prepare, session
from setup.console import Failure, say

USAGE = """usage: ./run screens OUT/ [PATTERN]      (PATTERN, for example 'tour_*': only the pages of such a name)"""
_SCRIPT = "res://scenes/screens/screens.gd"


def run(arguments: list[str]) -> int:
    """The subcommand; 1 when a text is cut off, covered or too faint."""
    if not 1 <= len(arguments) <= 2 or arguments[0].startswith("-"):
        raise Failure(USAGE, 2)
    folder, *pattern = arguments
    godot = prepare.project()
    say("Drawing the pages; without a graphics card this takes some minutes")
    command = session.script_command(godot, _SCRIPT, "mobile", [str(Path(folder).absolute()), *pattern])
    return session.start(command)
