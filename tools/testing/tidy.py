# SPDX-License-Identifier: MIT
"""clang-tidy over the C++ sources, in parallel and as the build compiles them: many at a time, since it spends most of its
time on their headers. What is as it was is not read again."""

from __future__ import annotations

import hashlib
import json
import re
import subprocess
from pathlib import Path

from setup import paths, process, stamps
from testing.context import complaint, each_file, relative, sources
from testing.junit import Case

FOLDERS = ("core", "src", "lut_cli")
GCC_ONLY = ("-fno-gnu-unique",)


def cases(build_folder: Path, with_analyzer: bool) -> list[Case]:
    """One case per file that the compiler is given for the folders above, and one that these are all sources.

    with_analyzer: with the checks that follow the program's paths, which take a third of the time.
    """
    entries = _entries(build_folder)
    if not entries:
        return [Case("sources", "clang-tidy", failure="the build names no source file to check")]
    depends = _dependencies(build_folder)
    version = process.capture(["clang-tidy", "--version"]) or ""
    rules_file = paths.ROOT / ".clang-tidy"
    rules = rules_file.read_text(encoding="utf-8")
    known = paths.cache_dir() / "clang-tidy"
    known.mkdir(parents=True, exist_ok=True)
    database = _database_for_clang(build_folder)
    restriction = [] if with_analyzer else ["--checks=-clang-analyzer-*"]

    inputs = {path: [path, *depends.get(_object_file(entry), [])] for path, entry in entries.items()}

    def check(path: Path) -> str:
        command = str(entries[path]["command"])
        key = fingerprint(version, rules + "".join(restriction), command, inputs[path], build_folder)
        if (known / key).exists():
            return ""
        wrong = complaint(["clang-tidy", "-p", database, f"--config-file={rules_file}", *restriction, "--quiet", path])
        if not wrong:
            (known / key).touch()
        return wrong

    compiled = set().union(*inputs.values())
    left_out = [relative(path) for path in _sources() if path not in compiled]
    whole = Case("all sources", "clang-tidy", failure="not compiled: " + ", ".join(left_out) if left_out else None)
    return [whole, *each_file(sorted(entries), "clang-tidy", check)]


def fingerprint(version: str, rules: str, command: str, inputs: list[Path], build_folder: Path) -> str:
    """Changes with the tool, its rules, the compile command and each project file that is read.

    Places of the clone are left out, so that another clone of the same sources profits.
    """
    content = hashlib.sha256()
    for path in sorted(set(inputs)):
        try:
            text = path.read_bytes().replace(str(paths.ROOT).encode(), b"ROOT")  # one that includes others names them
            content.update(path.name.encode() + b"\0" + text)
        except FileNotFoundError:
            content.update(b"gone")
    placeless = command.replace(str(build_folder), "BUILD").replace(str(paths.ROOT), "ROOT")
    return stamps.digest(version, rules, placeless, content.hexdigest())


def _database_for_clang(build_folder: Path) -> Path:
    """A folder with the compile commands less the options that only GCC knows."""
    folder = build_folder / "clang-tidy"
    folder.mkdir(exist_ok=True)
    commands = (build_folder / "compile_commands.json").read_text(encoding="utf-8")
    for option in GCC_ONLY:
        commands = commands.replace(f" {option} ", " ")
    (folder / "compile_commands.json").write_text(commands, encoding="utf-8")
    return folder


def _entries(build_folder: Path) -> dict[Path, dict[str, object]]:
    listed = json.loads((build_folder / "compile_commands.json").read_text(encoding="utf-8"))
    wanted = [folder / name for folder in (paths.SOURCES, build_folder) for name in FOLDERS]
    found = {Path(entry["file"]): entry for entry in listed}
    return {path: entry for path, entry in found.items() if any(path.is_relative_to(folder) for folder in wanted)}


def _object_file(entry: dict[str, object]) -> str:
    """What a compile command makes, as Ninja names it."""
    made = re.search(r" -o (\S+)", str(entry["command"]))
    return made.group(1) if made else ""


def _sources() -> list[Path]:
    return [path for name in FOLDERS for path in sources(".cpp", under=f"gdextension/{name}")]


def _dependencies(build_folder: Path) -> dict[str, list[Path]]:
    """For each object file the files of this project that it was compiled from, as Ninja recorded them."""
    printed = subprocess.run(
        ["ninja", "-C", str(build_folder), "-t", "deps"],
        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False,
    ).stdout
    found: dict[str, list[Path]] = {}
    current: list[Path] = []
    for line in printed.splitlines():
        if line and not line[0].isspace() and ": #deps" in line:
            current = found.setdefault(line.split(": #deps")[0], [])
        elif line.strip():
            path = (build_folder / line.strip()).resolve()
            if path.is_relative_to(paths.ROOT):
                current.append(path)
    return found
