# SPDX-License-Identifier: MIT
"""./run capture: one still picture, or a list of them, drawn without a visible window."""

from __future__ import annotations

import json
import tempfile
from dataclasses import dataclass
from pathlib import Path

from setup import prepare, session
from setup.console import Failure
from setup.godot import Godot

SCRIPT = "res://scenes/capture/capture.gd"
USAGE = "usage: ./run capture SHOT.json OUT.png|OUT.exr\n       ./run capture --batch LIST.json"


@dataclass(frozen=True)
class Job:
    """One picture: its description, a file or the object itself, and the file to write; paths are absolute."""

    shot: Path | dict[str, object]
    out: Path


def run(arguments: list[str]) -> int:
    """The subcommand; returns the exit status."""
    jobs, base = _jobs(arguments)
    grouped: dict[str, list[Job]] = {}
    for job in jobs:
        grouped.setdefault(renderer_of(job), []).append(job)
    godot = prepare.project()
    failures = []
    for renderer, group in grouped.items():
        try:
            _draw(godot, renderer, group, base)
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
    shot = _read_json(job.shot) if isinstance(job.shot, Path) else job.shot
    named = shot.get("renderer") if isinstance(shot, dict) else None
    if named in session.RENDERERS:
        return str(named)
    return "forward_plus" if named is None and job.out.suffix == ".exr" else "mobile"


def _jobs(arguments: list[str]) -> tuple[list[Job], Path]:
    """The pictures, and the folder from which paths inside a description may count."""
    if len(arguments) == 2 and arguments[0] == "--batch":
        return _batch(Path(arguments[1]))
    if len(arguments) == 2 and not arguments[0].startswith("-"):
        return [Job(Path(arguments[0]).absolute(), Path(arguments[1]).absolute())], Path.cwd()
    raise Failure(USAGE, 2)


def _batch(path: Path) -> tuple[list[Job], Path]:
    """The pictures of a list; relative paths in it count from the list's folder."""
    listed = _read_json(path)
    if not isinstance(listed, list) or not listed:
        raise Failure(f'capture: {path} must hold a list of {{"shot": ..., "out": ...}}')
    folder = path.absolute().parent
    jobs = []
    for number, entry in enumerate(listed, 1):
        if not isinstance(entry, dict) or set(entry) != {"shot", "out"}:
            raise Failure(f'capture: entry {number} of {path} must have exactly the keys "shot" and "out"')
        shot, out = entry["shot"], entry["out"]
        if not isinstance(shot, (str, dict)) or not isinstance(out, str):
            raise Failure(f'capture: entry {number} of {path}: "shot" must be a path or an object, "out" a path')
        jobs.append(Job(folder / shot if isinstance(shot, str) else shot, folder / out))
    inline = any(isinstance(job.shot, dict) for job in jobs)
    return jobs, folder if inline else Path.cwd()


def _read_json(path: Path) -> object:
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise Failure(f"capture: cannot read {path}: {error.strerror}") from error
    except ValueError as error:
        raise Failure(f"capture: {path} is not JSON: {error}") from error


def _written(path: Path) -> int | None:
    """When a file was written, in ns; an old picture must not pass for the new one."""
    return path.stat().st_mtime_ns if path.is_file() else None


def _draw(godot: Godot, renderer: str, group: list[Job], base: Path) -> None:
    before = [_written(job.out) for job in group]
    if len(group) == 1 and isinstance(group[0].shot, Path):
        session.run_script(godot, SCRIPT, renderer, [str(group[0].shot), str(group[0].out)], base)
    else:
        with tempfile.NamedTemporaryFile("w", suffix=".json", encoding="utf-8") as listed:
            json.dump([{"shot": job.shot, "out": job.out} for job in group], listed, default=str)
            listed.flush()
            session.run_script(godot, SCRIPT, renderer, ["--batch", listed.name], base)
    for job, old in zip(group, before):
        if _written(job.out) in (None, old):
            raise Failure(f"capture: Godot ended without an error but did not write {job.out}")
