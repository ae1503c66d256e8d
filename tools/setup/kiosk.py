# SPDX-License-Identifier: MIT
"""./run kiosk: the exhibit, kept running by its supervisor."""

from __future__ import annotations

import contextlib
import os
from dataclasses import dataclass, field
from pathlib import Path

from setup import display, monado, prepare, session
from setup.console import Failure, note, say
from setup.simulated_headset import SimulatedHeadset

SUPERVISOR = "res://scenes/kiosk/supervisor/supervisor.tscn"
USAGE = """usage: ./run kiosk [--simulated] [--config FILE] [-- ARGUMENTS FOR GODOT [-- ARGUMENTS FOR THE EXHIBIT]]"""


@dataclass
class Wish:
    """What the command line asks for."""

    simulated: bool = False
    config: Path | None = None
    engine: list[str] = field(default_factory=list)
    exhibit: list[str] = field(default_factory=list)


def run(arguments: list[str]) -> int:
    """The subcommand."""
    wish = parse(arguments)
    if not display.has_display():
        raise Failure("The exhibit needs a display, and there is none here. Start it from a graphical session.", 3)
    godot = prepare.project()
    with contextlib.ExitStack() as stack:
        variables: dict[str, str] = {}
        if wish.simulated:
            say("Starting a simulated headset")
            headset = stack.enter_context(SimulatedHeadset(monado.find(godot)))
            note(f"It listens on port {headset.port}; see tools/xr/remote.py --help")
            variables = headset.environment()
            wish.engine = ["--rendering-method", "mobile", *wish.engine]
        say("Starting the exhibit; Ctrl+C here, or its operator's panel (Ctrl+Shift+F12), ends it")
        return session.open_project(godot, engine_arguments(wish), variables)


def parse(arguments: list[str]) -> Wish:
    """The command line, taken apart; a Failure for a wrong one."""
    wish, rest = Wish(), list(arguments)
    while rest and rest[0] != "--":
        word = rest.pop(0)
        if word == "--simulated":
            wish.simulated = True
        elif word == "--config" and rest and rest[0] != "--":
            wish.config = Path(os.path.abspath(rest.pop(0)))
        else:
            raise Failure(USAGE, 2)
    if wish.config and not wish.config.is_file():
        raise Failure(f"There is no settings file {wish.config}; docs/kiosk.md says what may be in it.", 2)
    wish.engine = rest[1:]
    if "--" in wish.engine:
        at = wish.engine.index("--")
        wish.engine, wish.exhibit = wish.engine[:at], wish.engine[at + 1:]
    return wish


def engine_arguments(wish: Wish) -> list[str]:
    """What Godot is started with, as the supervisor, which hands the rest on to the exhibit."""
    config = [f"--kiosk-config={wish.config}"] if wish.config else []
    handed = [f"--engine={argument}" for argument in wish.engine]
    return ["--headless", SUPERVISOR, "--", "--supervise", *config, *handed, *wish.exhibit]
