# SPDX-License-Identifier: MIT
"""./run xr: the black hole in a headset, be it a real or a simulated one."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

from setup import display, monado, openxr_runtime, prepare, session
from setup.console import Failure, note, say
from setup.godot import Godot
from setup.monado import Monado
from setup.simulated_headset import SimulatedHeadset

SCENE = "res://scenes/xr/xr.tscn"
USAGE = """usage: ./run xr [--simulated] [-- ARGUMENTS FOR GODOT]
       ./run xr --strip OUT/      (pictures of a whole visit, by a simulated headset)"""
# The scene ends with one of these when it has lost the runtime, and when that has not come back yet: the engine looks for
# a runtime only when it starts.
LOST, STILL_WAITING = 75, 76
_MOST_RESTARTS = 5
_WITHIN_S = 60.0


def run(arguments: list[str]) -> int:
    """The subcommand."""
    strip = strip_folder(arguments)
    simulated, extra = (True, []) if strip else parse(arguments)
    godot = prepare.project()
    if not simulated:
        return _with_runtime(godot, extra)
    found = monado.find(godot)
    if strip:
        return _strip(godot, found, strip)
    say("Starting a simulated headset")
    with SimulatedHeadset(found) as headset:
        note(f"It listens on port {headset.port}; head and hands move with, for example,")
        note(f"tools/xr/remote.py --port {headset.port} --yaw 30 --trigger right 1    (--help lists all)")
        extra = ["--rendering-method", "mobile", *extra]
        return supervise(lambda variables: _start(godot, extra, variables | headset.environment()))


def parse(arguments: list[str]) -> tuple[bool, list[str]]:
    """(is the headset simulated, arguments for Godot); a Failure for anything else."""
    simulated = arguments[:1] == ["--simulated"]
    rest = arguments[1:] if simulated else arguments
    if rest and rest[0] != "--":
        raise Failure(USAGE, 2)
    return simulated, rest[1:]


def strip_folder(arguments: list[str]) -> Path | None:
    """The folder for the pictures of a visit, if that is asked for."""
    if arguments[:1] != ["--strip"]:
        return None
    if len(arguments) != 2:
        raise Failure(USAGE, 2)
    return Path(arguments[1]).absolute()


def _strip(godot: Godot, runtime: Monado, folder: Path) -> int:
    say("Visiting with a simulated headset; without a graphics card this takes some minutes")
    with SimulatedHeadset(runtime) as headset:
        arguments = ["--rendering-method", "mobile", "--audio-driver", "Dummy", "--xr-mode", "on", SCENE, "--"]
        return session.open_project(godot, [*arguments, "--strip", str(folder)], headset.environment())


def supervise(start: Callable[[dict[str, str]], int], clock: Callable[[], float] = time.monotonic) -> int:
    """Starts again what asks for it, `start` being given the variables to start it with; returns the status it ends with
    otherwise. A runtime that is lost too often is a Failure."""
    variables = {"BLACKHOLE_SUPERVISED": "1"}
    asked: list[float] = []
    while True:
        status = start(variables)
        variables["BLACKHOLE_STARTED_AGAIN"] = "1"
        if status == STILL_WAITING:
            continue
        if status != LOST:
            return status
        now = clock()
        asked = [before for before in asked if now - before < _WITHIN_S] + [now]
        if len(asked) > _MOST_RESTARTS:
            raise Failure(
                f"The scene asked {len(asked)} times within a minute to be started again: the OpenXR runtime gives it "
                "no session that lasts. Is the headset connected, and does its software run?",
                LOST,
            )
        say("The OpenXR runtime has gone: starting again until it is back")


def _with_runtime(godot: Godot, extra: list[str]) -> int:
    runtime = openxr_runtime.manifest()
    if runtime:
        say(f"Starting with the OpenXR runtime of {runtime}")
    else:
        say("Starting; this machine has no OpenXR runtime, so the scene opens on the desktop")
        note("A headset's software brings one and makes it the active one. Without a headset: ./run xr --simulated")
    return supervise(lambda variables: _start(godot, extra, variables))


def _start(godot: Godot, extra: list[str], variables: dict[str, str]) -> int:
    silent = [] if display.has_display() else ["--audio-driver", "Dummy"]
    return session.open_project(godot, ["--xr-mode", "on", *silent, SCENE, *extra], variables)
