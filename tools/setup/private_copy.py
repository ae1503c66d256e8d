# SPDX-License-Identifier: MIT
"""A private copy of Debian's Godot in the user's cache: no root, nothing of the system is touched.

The packages of a newer Debian are downloaded by an apt of our own, unpacked into one folder and made to use the
libraries in that folder alone. The folder carries the version in its name and is shared by all clones.
"""

from __future__ import annotations

import shutil
from pathlib import Path

from setup import godot_version, paths, private_packages, relocate, stamps
from setup.console import Failure, note, say

PACKAGES = ["godot", "libgl1", "libegl1", "libgl1-mesa-dri", "mesa-vulkan-drivers", "patchelf"]
# Raise when the steps below change, so that copies made by older ones are made again.
RECIPE = 1
_REMEDY = (
    "Or download Godot 4.6 for Linux from the Godot website, put it\n"
    "on PATH as 'godot' or name it in the variable GODOT, and start again."
)


def bring() -> tuple[Path, str]:
    """(executable, version) of the private copy, made now when there is none."""
    cache = paths.cache_dir()
    found = newest(cache)
    if found:
        return found
    with private_packages.locked(cache, "Godot"):
        return newest(cache) or _make(cache)


def newest(cache: Path) -> tuple[Path, str] | None:
    """The newest complete copy in the cache."""
    versions = []
    for text, folder in private_packages.complete(cache, "godot", _stamp):
        version = godot_version.parse(text)
        if version:
            versions.append((version, folder))
    if not versions:
        return None
    version, folder = max(versions)
    return folder / "bin" / "godot", _text(version)


def _stamp(folder: Path) -> str:
    """The copy knows its own place, so it is complete only where it was made."""
    return stamps.digest(RECIPE, folder, *PACKAGES)


def _text(version: tuple[int, int, int]) -> str:
    return ".".join(str(part) for part in version)


def _make(cache: Path) -> tuple[Path, str]:
    say("Godot 4.6 or newer was not found; bringing a private copy from Debian (about 180 MB, once)")
    log = cache / "godot-setup.log"
    note(f"It goes to {cache}; details in {log.name} there")
    cache.mkdir(parents=True, exist_ok=True)
    log.write_text("", encoding="utf-8")
    missing = "Godot 4.6 or newer was not found on this machine"
    offer = private_packages.offer("godot", _is_enough, cache, log, missing, _REMEDY)
    version = godot_version.parse(offer.version)
    assert version is not None
    note(f"Godot {_text(version)} from Debian {offer.apt.suite}")
    files = offer.apt.download(PACKAGES, "Downloading Godot")
    folder = cache / f"godot-{_text(version)}"
    shutil.rmtree(folder, ignore_errors=True)
    private_packages.unpack(files, folder / "root", log)
    executable = _install(folder, log)
    if godot_version.of_executable(executable) != version:
        raise Failure(f"The private copy of Godot in {folder} does not start. Details in {log}.")
    stamps.write(folder / "stamp", _stamp(folder))
    return executable, _text(version)


def _is_enough(text: str) -> bool:
    return godot_version.is_enough(godot_version.parse(text))


def _install(folder: Path, log: Path) -> Path:
    """Makes Godot run from folder/root; the executable."""
    root = relocate.find_root(folder / "root")
    root.gather(log)
    executable = folder / "bin" / "godot"
    root.executable("godot", folder / "bin" / "godot.bin", log)
    root.starter(executable, folder / "bin" / "godot.bin")
    return executable
