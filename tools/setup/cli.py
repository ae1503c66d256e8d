# SPDX-License-Identifier: MIT
"""./run: the subcommands."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass

from package import command as package
from package import exports
from setup import (
    bench, capture, display, fuzz, kiosk, paths, prepare, screens, self_test, session, xr,
)
from setup.console import Failure, note, say

FIRST_LOOK = paths.ROOT / "scenes" / "desktop" / "first_look.json"


@dataclass(frozen=True)
class Subcommand:
    """A word after ./run."""

    summary: str
    action: Callable[[list[str]], int]


def main(arguments: list[str]) -> int:
    """Runs one subcommand; returns the exit status: 2 for a wrong command line."""
    word, rest = (arguments[0], arguments[1:]) if arguments else ("demo", [])
    if word == "--":
        word, rest = "demo", arguments
    if word in ("-h", "--help"):
        word = "help"
    subcommand = SUBCOMMANDS.get(word)
    if subcommand is None:
        print(f"run: there is no subcommand '{word}'\n{help_text()}", file=sys.stderr)
        return 2
    try:
        return subcommand.action(rest)
    except Failure as failure:
        print(f"run: {failure}", file=sys.stderr)
        return failure.code
    except KeyboardInterrupt:
        return 130


def help_text() -> str:
    """The list of subcommands, one line each."""
    lines = [f"  {word:<11}{subcommand.summary}" for word, subcommand in SUBCOMMANDS.items()]
    return "usage: ./run [SUBCOMMAND] [ARGUMENTS]\n\n" + "\n".join(lines)


def engine_arguments(word: str, arguments: list[str]) -> list[str]:
    """What follows `--` goes to Godot; before it nothing is expected."""
    if arguments and arguments[0] != "--":
        raise Failure(f"usage: ./run {word} [-- ARGUMENTS FOR GODOT]", 2)
    return arguments[1:]


def _demo(arguments: list[str]) -> int:
    extra = engine_arguments("demo", arguments)
    if display.has_display():
        godot = prepare.project()
        say("Starting")
        return session.open_project(godot, extra)
    say("No display here: drawing one picture instead of opening a window")
    status = capture.run([str(FIRST_LOOK), str(paths.OUT / "first_look.png")])
    note("That is the picture. On a machine with a display, ./run opens the scene itself.")
    return status


def _editor(arguments: list[str]) -> int:
    extra = engine_arguments("editor", arguments)
    if not display.has_display():
        raise Failure("The editor needs a display, and there is none here.", 3)
    return session.open_project(prepare.project(), ["--editor", *extra])


def _lut(arguments: list[str]) -> int:
    return subprocess.run([prepare.table_tool(), *arguments], check=False).returncode


def _bake(arguments: list[str]) -> int:
    if arguments not in ([], ["--check"]):
        raise Failure("usage: ./run bake [--check]", 2)
    table = os.path.relpath(paths.ROOT / "lut" / "schwarzschild.lut")
    return subprocess.run([prepare.table_tool(), "bake", *arguments, table], check=False).returncode


def _clean(arguments: list[str]) -> int:
    if arguments not in ([], ["--cache"]):
        raise Failure("usage: ./run clean [--cache]", 2)
    addon = paths.ROOT / "addons" / "blackhole_sky"
    doomed = [paths.BUILD, paths.OUT, paths.ROOT / ".godot", *addon.glob("data/*.lut")]
    doomed += [file for file in addon.glob("bin/*") if file.name != ".gitkeep"]
    if arguments:
        doomed.append(paths.cache_dir())
    for path in doomed:
        if path.is_dir() and not path.is_symlink():
            shutil.rmtree(path)
        else:
            path.unlink(missing_ok=True)
    if not arguments and paths.cache_dir().exists():
        note(f"Downloads are kept in {paths.cache_dir()}; ./run clean --cache removes them too")
    return 0


def _help(_arguments: list[str]) -> int:
    print(help_text())
    return 0


SUBCOMMANDS = {
    "demo": Subcommand("open the black hole and its sky (the default); without a display: draw one picture", _demo),
    "xr": Subcommand("open it in a headset; --simulated: with one that a script moves (see tools/xr)", xr.run),
    "kiosk": Subcommand("the exhibit for a museum, kept running: [--simulated] [--config FILE]; see docs/kiosk.md", kiosk.run),
    "capture": Subcommand("draw stills and sequences without a window: SHOT.json OUT, or --batch LIST.json; see docs/capture.md", capture.run),
    "screens": Subcommand("draw every page and station of the programs, in every language: OUT/ [PATTERN]", screens.run),
    "bake": Subcommand("compute the lensing tables into lut/; --check computes and compares", _bake),
    "lut": Subcommand("the table tool: bake, inspect, verify, eval; see ./run lut --help", _lut),
    "bench": Subcommand("measure and print a table: [OUT.json] [--renderer mobile|forward_plus|gl_compatibility] [--scale]",
                        bench.run),
    "self-test": Subcommand("is this GPU right? draws, reads back, compares with the exact solution: [OUT.json] "
                            "[--renderer ...]", self_test.run),
    "package": Subcommand("the addon as a zip, with Windows' library: [--out DIR] [--libraries release,debug,windows]",
                          package.run),
    "export": Subcommand("the demo as a program: [Linux|Windows|Quest] [--debug] [--out DIR]; see docs/exporting.md",
                         exports.run),
    "fuzz": Subcommand("try the readers of files with broken ones: [TARGET ...] [--minutes N]; see docs/robustness.md", fuzz.run),
    "editor": Subcommand("open the project in the Godot editor", _editor),
    "clean": Subcommand("remove all that was built and drawn; --cache removes the downloads too", _clean),
    "help": Subcommand("show this list", _help),
}
