# SPDX-License-Identifier: MIT
"""./run bench: measures the program and writes the figures as JSON."""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from setup import bench_parts, bench_report, paths, prepare, session
from setup.console import Failure, say

SCRIPT = "res://scenes/bench/bench.gd"
USAGE = "usage: ./run bench [OUT.json] [--renderer mobile|forward_plus|gl_compatibility] [--scale]"


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> None:  # type: ignore[override]
        raise Failure(f"bench: {message}\n{USAGE}", 2)


def run(arguments: list[str]) -> int:
    """The subcommand; returns the exit status."""
    parser = _Parser(add_help=False)
    parser.add_argument("out", nargs="?", default=str(paths.OUT / "bench.json"))
    parser.add_argument("--renderer", choices=session.RENDERERS, default="mobile")
    parser.add_argument("--scale", action="store_true")
    chosen = parser.parse_args(arguments)
    out = Path(chosen.out).absolute()
    out.parent.mkdir(parents=True, exist_ok=True)
    out.unlink(missing_ok=True)
    godot = prepare.project(bench_parts.PACKAGES)
    say("Measuring the physics on one core")
    figures: dict[str, object] = {**bench_parts.core_figures()}
    say(f"Measuring the first frame ({chosen.renderer})")
    figures |= bench_parts.first_frame_figures(godot, chosen.renderer)
    say(f"Measuring the pictures ({chosen.renderer}); this takes some minutes without a graphics card")
    many_stars = [str(bench_parts.many_stars())] if chosen.scale else []
    session.run_script(godot, SCRIPT, chosen.renderer, [str(out), *many_stars])
    figures |= json.loads(out.read_text(encoding="utf-8"))
    bench_report.check(figures)
    held = bench_report.limits(figures)
    figures["limits"] = held
    out.write_text(json.dumps(figures, indent=2) + "\n", encoding="utf-8")
    del figures["limits"], figures[bench_report.TURNS]
    print("\n".join([*table(figures), "", *bench_report.lines(held), ""]))
    print(out)
    return 0


def table(figures: dict[str, object], prefix: str = "") -> list[str]:
    """The figures as lines of two columns; those that belong together under their common name."""
    lines: list[str] = []
    for key, value in figures.items():
        if isinstance(value, dict):
            lines += table(value, f"{prefix}{key}.")
        elif isinstance(value, list):
            lines.append(f"{prefix + key:<40}{' x '.join(_text(part) for part in value)}")
        else:
            lines.append(f"{prefix + key:<40}{_text(value)}")
    return lines


def _text(value: object) -> str:
    if isinstance(value, float):
        return f"{value:,.4g}" if abs(value) < 1e4 else f"{value:,.0f}"
    return str(value)
