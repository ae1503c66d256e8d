# SPDX-License-Identifier: MIT
"""./run capture: stills and sequences, one or a list of them, drawn without a visible window."""

from __future__ import annotations

import json
import re
import tempfile
from collections.abc import Callable
from contextlib import nullcontext
from dataclasses import dataclass
from pathlib import Path

from setup import frames, monado, movie, prepare, session
from setup.console import Failure, Pace, Progress, note
from setup.godot import Godot
from setup.simulated_headset import SimulatedHeadset

SCRIPT = "res://scenes/capture/capture.gd"
USAGE = """usage: ./run capture SHOT.json OUT.png|OUT.exr
       ./run capture SEQUENCE.json OUT/|OUT_%04d.png|OUT_%04d.exr|OUT.mp4|OUT.webm|OUT.avi
       ./run capture --batch LIST.json"""
# ShotSpec.MOST_BYTES
MOST_BYTES = 4 << 20
_FRAME = re.compile(r"capture frame (\d+)/(\d+)")


@dataclass(frozen=True)
class Job:
    """One still or sequence: its description, a file or the object itself, and the file, the frames (a pattern) or
    the movie to write; paths are absolute."""

    shot: Path | dict[str, object]
    out: Path


def run(arguments: list[str]) -> int:
    """The subcommand; returns the exit status."""
    jobs, base = read_jobs(arguments)
    for job in jobs:
        _check_movie(job)
    grouped: dict[tuple[str, bool], list[Job]] = {}
    for job in jobs:
        grouped.setdefault((renderer_of(job), is_for_headset(job)), []).append(job)
    godot = prepare.project()
    failures = []
    for (renderer, in_headset), group in grouped.items():
        try:
            with SimulatedHeadset(monado.find(godot)) if in_headset else nullcontext() as headset:
                _draw(godot, renderer, group, base, headset)
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
    named = _shot(job).get("renderer")
    if named in session.RENDERERS:
        return str(named)
    return "forward_plus" if named is None and job.out.suffix == ".exr" else "mobile"


def is_for_headset(job: Job) -> bool:
    """Whether a headset takes the picture: a simulated one, whose head keeps still."""
    return bool(_shot(job).get("xr", False))


def _shot(job: Job) -> dict[str, object]:
    """What the shot says; empty when it is no object, which the capture scene refuses by name."""
    shot = _read_json(job.shot) if isinstance(job.shot, Path) else job.shot
    return shot if isinstance(shot, dict) else {}


def _check_movie(job: Job) -> None:
    """A movie that cannot be written is refused before anything is drawn."""
    if not frames.is_movie(job.out):
        return
    if "path" not in _shot(job):
        raise Failure(f"capture: {job.out.name}: a movie takes a sequence, and the shot has no path")
    movie.encoders(job.out)


def read_jobs(arguments: list[str]) -> tuple[list[Job], Path]:
    """The pictures, and the folder from which paths inside a description may count."""
    if len(arguments) == 2 and arguments[0] == "--batch":
        return _batch(Path(arguments[1]))
    if len(arguments) == 2 and not arguments[0].startswith("-"):
        return [Job(Path(arguments[0]).absolute(), frames.named(Path.cwd(), arguments[1]))], Path.cwd()
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
        jobs.append(Job(folder / shot if isinstance(shot, str) else shot, frames.named(folder, out)))
    inline = any(isinstance(job.shot, dict) for job in jobs)
    return jobs, folder if inline else Path.cwd()


def _read_json(path: Path) -> object:
    try:
        size = path.stat().st_size
        if size > MOST_BYTES:
            raise Failure(f"capture: {path} has {size} bytes; a shot or a list of shots may have {MOST_BYTES}")
        return json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise Failure(f"capture: cannot read {path}: {error.strerror}") from error
    except RecursionError as error:
        raise Failure(f"capture: {path} has too many lists and objects in each other") from error
    except ValueError as error:
        raise Failure(f"capture: {path} is not JSON: {error}") from error


def _written(path: Path) -> int | None:
    """When a file was written, in ns; an old picture must not pass for the new one."""
    return path.stat().st_mtime_ns if path.is_file() else None


def _draw(godot: Godot, renderer: str, group: list[Job], base: Path, headset: SimulatedHeadset | None) -> None:
    for job in group:
        if frames.is_movie(job.out):
            frames.remove(frames.drawn(job.out))
    before = [_written(frames.first(job.out)) for job in group]
    progress, pace = Progress("frame"), Pace("frames")

    def show(line: str) -> None:
        found = _FRAME.fullmatch(line)
        if found:
            done, total = int(found[1]), int(found[2])
            progress.update(done, total, pace.words(done, total))

    watch = show if any("path" in _shot(job) for job in group) else None
    try:
        _run_scene(godot, renderer, group, base, watch, headset)
    except KeyboardInterrupt:
        progress.close()
        for job in group:
            _say_what_is_left(job)
        raise
    finally:
        progress.close()
    for job, old in zip(group, before):
        first = frames.first(job.out)
        if _written(first) in (None, old):
            raise Failure(f"capture: Godot ended without an error but did not write {first}")
        if frames.is_movie(job.out):
            path = _shot(job)["path"]
            movie.write(frames.drawn(job.out), float(path["fps"]), job.out)  # type: ignore[index]
            frames.remove(frames.drawn(job.out))


def _run_scene(
    godot: Godot, renderer: str, group: list[Job], base: Path, watch: Callable[[str], None] | None,
    headset: SimulatedHeadset | None,
) -> None:
    listed = [{"shot": job.shot, "out": frames.drawn(job.out)} for job in group]
    if len(group) == 1 and isinstance(group[0].shot, Path):
        arguments = [str(listed[0]["shot"]), str(listed[0]["out"])]
        session.run_script(godot, SCRIPT, renderer, arguments, base, watch, headset)
        return
    with tempfile.NamedTemporaryFile("w", suffix=".json", encoding="utf-8") as file:
        json.dump(listed, file, default=str)
        file.flush()
        session.run_script(godot, SCRIPT, renderer, ["--batch", file.name], base, watch, headset)


def _say_what_is_left(job: Job) -> None:
    """After an interruption: the frames that are complete stay."""
    if "path" not in _shot(job):
        return
    pattern = frames.drawn(job.out)
    frames.remove_half_written(pattern)
    note(f"stopped: {len(frames.written(pattern))} complete frames are in {pattern.parent}")
