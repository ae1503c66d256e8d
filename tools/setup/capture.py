# SPDX-License-Identifier: MIT
"""./run capture: one still picture, or a list of them, drawn without a visible window."""

from __future__ import annotations

import json
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from setup import prepare, session
from setup.console import Failure

SCRIPT = "res://scenes/capture/capture.gd"
USAGE = "usage: ./run capture SHOT.json OUT.png|OUT.exr\n       ./run capture --batch LIST.json"


@dataclass(frozen=True)
class Job:
    """One picture: the file that describes it and the file to write, both absolute."""

    shot: Path
    out: Path


def run(arguments: list[str]) -> int:
    """The subcommand; returns the exit status."""
    jobs = _jobs(arguments)
    if not jobs:
        raise Failure("capture: the list names no picture", 1)
    grouped: dict[str, list[Job]] = {}
    for job in jobs:
        grouped.setdefault(renderer_of(job), []).append(job)
    godot = prepare.project()
    failures = []
    for renderer, group in grouped.items():
        try:
            _draw(godot, renderer, group)
        except Failure as failure:
            failures.append(failure)
    if failures:
        raise Failure("\n".join(str(failure) for failure in failures), failures[0].code)
    for job in jobs:
        print(job.out)
    return 0


def renderer_of(job: Job) -> str:
    """The renderer a shot asks for. Without one: the only one that writes .exr for an .exr, else mobile.

    A name that does not exist is left to the capture scene, which refuses it by name.
    """
    shot = _read_json(job.shot)
    named = shot.get("renderer") if isinstance(shot, dict) else None
    if named in session.RENDERERS:
        return str(named)
    return "forward_plus" if named is None and job.out.suffix == ".exr" else "mobile"


def _jobs(arguments: list[str]) -> list[Job]:
    if len(arguments) == 2 and arguments[0] == "--batch":
        return _batch(Path(arguments[1]))
    if len(arguments) == 2 and not arguments[0].startswith("-"):
        return [Job(Path(arguments[0]).absolute(), Path(arguments[1]).absolute())]
    raise Failure(USAGE, 2)


def _batch(path: Path) -> list[Job]:
    """The pictures of a list; relative paths count from the current folder, as on the command line."""
    listed = _read_json(path)
    if not isinstance(listed, list):
        raise Failure(f'capture: {path} must hold a list of {{"shot": ..., "out": ...}}')
    jobs = []
    for number, entry in enumerate(listed, 1):
        if not isinstance(entry, dict) or set(entry) != {"shot", "out"}:
            raise Failure(f'capture: entry {number} of {path} must have exactly the keys "shot" and "out"')
        if not all(isinstance(value, str) for value in entry.values()):
            raise Failure(f'capture: entry {number} of {path}: "shot" and "out" must be paths')
        jobs.append(Job(Path(entry["shot"]).absolute(), Path(entry["out"]).absolute()))
    return jobs


def _read_json(path: Path) -> object:
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise Failure(f"capture: cannot read {path}: {error.strerror}") from error
    except ValueError as error:
        raise Failure(f"capture: {path} is not JSON: {error}") from error


def _draw(godot: prepare.Godot, renderer: str, group: list[Job]) -> None:
    started = time.time() - 1.0
    for job in group:
        job.out.parent.mkdir(parents=True, exist_ok=True)
    if len(group) == 1:
        session.run_script(godot, SCRIPT, renderer, [str(group[0].shot), str(group[0].out)])
    else:
        with tempfile.NamedTemporaryFile("w", suffix=".json", encoding="utf-8") as listed:
            json.dump([{"shot": str(job.shot), "out": str(job.out)} for job in group], listed)
            listed.flush()
            session.run_script(godot, SCRIPT, renderer, ["--batch", listed.name])
    for job in group:
        if not job.out.is_file() or job.out.stat().st_mtime < started:
            raise Failure(f"capture: Godot ended without an error but did not write {job.out}")
