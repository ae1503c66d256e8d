# SPDX-License-Identifier: MIT
"""Names of what ./run capture writes: one picture, the numbered frames of a sequence, or a movie."""

from __future__ import annotations

import re
from pathlib import Path

FRAME_NAME = "frame_%04d.png"
MOVIES = (".avi", ".mp4", ".webm")
_NUMBER = re.compile(r"%0?(\d*)d")


def named(folder: Path, text: str) -> Path:
    """What a word of the visitor means, from a folder: one that ends in a slash is a folder for frames."""
    return folder / text / FRAME_NAME if text.endswith("/") else folder / text


def is_movie(out: Path) -> bool:
    """Whether the frames are to become a movie."""
    return out.suffix.lower() in MOVIES


def drawn(out: Path) -> Path:
    """What Godot is to write: of a movie its frames, in a folder beside it."""
    return out.with_name(out.name + ".frames") / FRAME_NAME if is_movie(out) else out


def first(out: Path) -> Path:
    """The first picture that Godot writes."""
    return file(drawn(out), 0)


def file(pattern: Path, frame: int) -> Path:
    """The file of a frame; of a still there is one."""
    return pattern.with_name(_NUMBER.sub(lambda found: str(frame).zfill(int(found[1] or 0)), pattern.name, count=1))


def written(pattern: Path) -> list[Path]:
    """The frames that are there, in order."""
    found = []
    while (path := file(pattern, len(found))).is_file() and path not in found[-1:]:
        found.append(path)
    return found


def remove(pattern: Path) -> None:
    """Removes the frames that are there, whole and half, and their folder when nothing else is in it."""
    remove_half_written(pattern)
    for path in _numbered(pattern):
        path.unlink()
    if pattern.parent.is_dir() and not any(pattern.parent.iterdir()):
        pattern.parent.rmdir()


def remove_half_written(pattern: Path) -> None:
    """Removes what a stopped Godot left under the provisional name."""
    for path in _numbered(pattern.with_name(pattern.name + ".part")):
        path.unlink()


def _numbered(pattern: Path) -> list[Path]:
    """The files whose names are the pattern's with any number; without a place for one there are none."""
    number = _NUMBER.search(pattern.name)
    if number is None or not pattern.parent.is_dir():
        return []
    name = re.compile(re.escape(pattern.name[:number.start()]) + r"\d+" + re.escape(pattern.name[number.end():]))
    return [path for path in pattern.parent.iterdir() if name.fullmatch(path.name)]
