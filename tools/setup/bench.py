# SPDX-License-Identifier: MIT
"""./run bench: measures the program and writes the figures as JSON."""

from __future__ import annotations

import argparse
from pathlib import Path

from setup import paths, prepare, session
from setup.console import Failure, say

SCRIPT = "res://scenes/bench/bench.gd"
USAGE = "usage: ./run bench [OUT.json] [--renderer mobile|forward_plus|gl_compatibility]"


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> None:  # type: ignore[override]
        raise Failure(f"bench: {message}\n{USAGE}", 2)


def run(arguments: list[str]) -> int:
    """The subcommand; returns the exit status."""
    parser = _Parser(add_help=False)
    parser.add_argument("out", nargs="?", default=str(paths.OUT / "bench.json"))
    parser.add_argument("--renderer", choices=session.RENDERERS, default="mobile")
    chosen = parser.parse_args(arguments)
    out = Path(chosen.out).absolute()
    out.parent.mkdir(parents=True, exist_ok=True)
    godot = prepare.project()
    say(f"Measuring ({chosen.renderer}); this takes a few minutes")
    printed = session.run_script(godot, SCRIPT, chosen.renderer, [str(out)])
    print(printed, end="")
    return 0
