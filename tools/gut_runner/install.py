#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Puts the small test runner into a project's addons/gut, unless GUT itself is there.

    python3 tools/gut_runner/install.py [--project DIR]

A marker file beside the runner holds the hash of its files and their names. A folder without the marker, or
with GUT's plugin.cfg, is somebody else's and stays as it is. Run `godot --headless --path DIR --import` after
an installation, so that the class names of the runner become known.
"""

import argparse
import hashlib
import json
import sys
from pathlib import Path

SOURCE = Path(__file__).resolve().parent / "addon"
REPOSITORY = Path(__file__).resolve().parents[2]
MARKER = ".blackhole_sky_runner"
# A file that GUT has and the runner has not.
SIGN_OF_GUT = "plugin.cfg"


def source_files() -> dict[str, bytes]:
    """The runner's files by their path below addons/gut."""
    files = sorted(path for path in SOURCE.rglob("*") if path.suffix in (".gd", ".txt"))
    return {path.relative_to(SOURCE).as_posix(): path.read_bytes() for path in files}


def hash_of(files: dict[str, bytes]) -> str:
    """One hash over names and contents."""
    digest = hashlib.sha256()
    for name, content in files.items():
        digest.update(f"{name}\0{len(content)}\0".encode())
        digest.update(content)
    return digest.hexdigest()


def read_marker(target: Path) -> dict:
    """What an earlier installation noted; empty when there was none or the note is damaged."""
    try:
        marker = json.loads((target / MARKER).read_text(encoding="utf-8"))
        return marker if isinstance(marker, dict) else {}
    except (OSError, ValueError):
        return {}


def write_marker(target: Path, digest: str, names: list[str]) -> None:
    text = json.dumps({"hash": digest, "files": names}, indent=1)
    (target / MARKER).write_text(text + "\n", encoding="utf-8")


def belongs_to_somebody_else(target: Path) -> bool:
    if not target.is_dir() or not any(target.iterdir()):
        return False
    return not (target / MARKER).exists() or (target / SIGN_OF_GUT).exists()


def is_up_to_date(target: Path, files: dict[str, bytes]) -> bool:
    try:
        there = {name: (target / name).read_bytes() for name in files}
    except OSError:
        return False
    return there == files and read_marker(target).get("hash") == hash_of(files)


def install(target: Path, files: dict[str, bytes]) -> None:
    """Writes the files and takes away those of an earlier version that are no longer part of it."""
    earlier = [name for name in read_marker(target).get("files", []) if isinstance(name, str)]
    target.mkdir(parents=True, exist_ok=True)
    # First the marker without a hash: an installation cut short is known as ours and done again.
    write_marker(target, "", sorted(set(earlier) | set(files)))
    for name, content in files.items():
        (target / name).parent.mkdir(parents=True, exist_ok=True)
        (target / name).write_bytes(content)
    for name in set(earlier) - set(files):
        if ".." not in Path(name).parts and not Path(name).is_absolute():
            (target / name).unlink(missing_ok=True)
            (target / (name + ".uid")).unlink(missing_ok=True)
    write_marker(target, hash_of(files), list(files))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--project", type=Path, default=REPOSITORY, help="folder with project.godot")
    project = parser.parse_args().project.resolve()
    if not (project / "project.godot").is_file():
        print(f"{project} has no project.godot: name the project's folder", file=sys.stderr)
        return 1
    target = project / "addons" / "gut"
    files = source_files()
    if belongs_to_somebody_else(target):
        print(f"{target}: GUT is there, left as it is")
    elif is_up_to_date(target, files):
        print(f"{target}: the runner is up to date")
    else:
        install(target, files)
        print(f"{target}: runner installed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
