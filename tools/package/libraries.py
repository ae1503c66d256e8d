# SPDX-License-Identifier: MIT
"""The libraries that the addon's zip holds, each built by its CMake preset."""

from __future__ import annotations

import platform
import re
from dataclasses import dataclass
from pathlib import Path

from package import import_table
from setup import build, packages, paths, process
from setup.console import Failure, note
from setup.godot import Godot

BIN = paths.ROOT / "addons" / "blackhole_sky" / "bin"
WINDOWS_PACKAGES = ["g++-mingw-w64-x86-64-posix", "libz-mingw-w64-dev"]
# Godot's words for what this machine may be.
_ARCHITECTURES = {"x86_64": "x86_64", "amd64": "x86_64", "aarch64": "arm64"}


@dataclass(frozen=True)
class Library:
    """A library: the preset that builds it, its file, and under which features Godot finds it."""

    preset: str
    file: str
    features: str


def known(machine: str = platform.machine()) -> dict[str, Library]:
    """The libraries that this machine can build, by the word for them on the command line."""
    own = _ARCHITECTURES.get(machine.lower(), machine)
    return {
        "release": Library("release", f"libblackhole_sky.linux.{own}.so", f"linux.{own}"),
        "debug": Library("debug", f"libblackhole_sky.linux.{own}.debug.so", f"linux.debug.{own}"),
        "windows": Library("windows", "blackhole_sky.windows.x86_64.dll", "windows.x86_64"),
    }


def make(word: str, godot: Godot) -> Library:
    """Builds and checks one; its file then lies in BIN."""
    library = known()[word]
    if word == "windows":
        packages.ensure(WINDOWS_PACKAGES)
    build.build(library.preset, godot, "blackhole_sky")
    file = BIN / library.file
    if not file.is_file():
        raise Failure(f"The preset {library.preset} built no {file}.")
    if word == "windows":
        _check_windows(file)
    else:
        note(f"{file.name} needs glibc {glibc(file)} or newer")
    return library


def glibc(library: Path) -> str:
    """The least C library that a Linux library runs with, as objdump tells it."""
    printed = process.capture(["objdump", "-T", library]) or ""
    versions = {tuple(map(int, text.split("."))) for text in re.findall(r"\bGLIBC_([0-9.]+)", printed)}
    return ".".join(map(str, max(versions))) if versions else "of any version"


def _check_windows(file: Path) -> None:
    import_table.check(file)
    if import_table.wine():
        import_table.load_under_wine(file)
        note(f"{file.name} needs nothing but Windows, and loads under Wine")
    else:
        note(f"{file.name} needs nothing but Windows; it was not loaded: there is no Wine here")
