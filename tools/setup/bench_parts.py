# SPDX-License-Identifier: MIT
"""The figures of ./run bench that are measured outside of the bench scene: the physics on one core, and how long
the first frame takes."""

from __future__ import annotations

import json
import re
import sys
import tempfile
from pathlib import Path

from setup import build, display, paths, process
from setup.console import Failure, tail
from setup.godot import Godot

PACKAGES = ["libgtest-dev", "libbenchmark-dev"]
_SYNTHETIC_STARS = paths.ROOT / "tools" / "synthetic_stars" / "build_synthetic.py"
_FIRST_FRAME = Path(__file__).parent / "first_frame.gd"
_ROUNDS = 5
_EMPTY_PROJECT = """config_version=5

[display]

window/size/viewport_width=1280
window/size/viewport_height=720
"""


def core_figures() -> dict[str, float]:
    """exact_phi_per_s and bake_tables_s, on one core."""
    program = build.build("test", None, "lensing_bench") / "bench" / "lensing_bench"
    log = paths.LOGS / "bench-core.log"
    result = paths.BUILD / "bench-core.json"
    command = [
        program, "--benchmark_filter=^(exact_phi|bake_tables)$", "--benchmark_format=json",
        f"--benchmark_out={result}", "--benchmark_out_format=json",
    ]
    process.require(command, log, "Measuring the physics", timeout_s=300)
    return read_core_figures(result.read_text(encoding="utf-8"))


def read_core_figures(text: str) -> dict[str, float]:
    """The two figures in the JSON of Google Benchmark."""
    runs = {run["name"]: run for run in json.loads(text)["benchmarks"]}
    units = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
    baking = runs["bake_tables"]
    return {
        "exact_phi_per_s": float(runs["exact_phi"]["items_per_second"]),
        "bake_tables_s": float(baking["cpu_time"]) * units[baking["time_unit"]],
    }


def many_stars() -> Path:
    """A catalogue of 2.5 million invented stars; made once, and anew when its builder changed."""
    path = paths.BUILD / "synthetic-2500k.stars"
    if not path.exists() or path.stat().st_mtime < _SYNTHETIC_STARS.stat().st_mtime:
        command = [sys.executable, _SYNTHETIC_STARS, path]
        process.require(command, paths.LOGS / "synthetic-stars.log", "Making the synthetic stars", timeout_s=300)
    return path


def first_frame_figures(godot: Godot, renderer: str) -> dict[str, float]:
    """first_frame_ms and first_sky_ms of the demo and first_frame_empty_project_ms, taken in turns: the least of several starts."""
    with tempfile.TemporaryDirectory() as empty:
        (Path(empty) / "project.godot").write_text(_EMPTY_PROJECT, encoding="utf-8")
        projects = {"first_frame_ms": paths.ROOT, "first_frame_empty_project_ms": Path(empty)}
        least = dict.fromkeys([*projects, "first_sky_ms"], float("inf"))
        for _ in range(_ROUNDS):
            for key, project in projects.items():
                found = _first_frames(godot, renderer, project)
                least[key] = min(least[key], found["first frame"])
                least["first_sky_ms"] = min(least["first_sky_ms"], found.get("sky", float("inf")))
    return least


def _first_frames(godot: Godot, renderer: str, project: Path) -> dict[str, float]:
    """What one start prints, in milliseconds."""
    log = paths.LOGS / "first-frame.log"
    command = display.on_screen([
        str(godot.executable), "--path", str(project), "--rendering-method", renderer, "--audio-driver", "Dummy",
        "-s", str(_FIRST_FRAME),
    ])
    status = process.run_logged(command, log, timeout_s=120)
    printed = log.read_text(encoding="utf-8", errors="replace")
    found = {name: float(ms) for name, ms in re.findall(r"^(first frame|sky) after ([\d.]+) ms", printed, re.MULTILINE)}
    if status != 0 or "first frame" not in found:
        raise Failure(f"bench: no first frame (exit status {status}). The end of {log}:\n{tail(log)}")
    return found
