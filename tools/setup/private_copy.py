# SPDX-License-Identifier: MIT
"""A private copy of Debian's Godot in the user's cache: no root, nothing of the system is touched.

The packages of a newer Debian are downloaded by an apt of our own, unpacked into one folder and made to use the
libraries in that folder alone. The folder carries the version in its name and is shared by all clones.
"""

from __future__ import annotations

import shutil
from pathlib import Path

from setup import archive, godot_version, locks, paths, process, relocate, stamps
from setup.console import Failure, Progress, note, say
from setup.private_apt import PrivateApt

SUITES = ("forky", "sid")
PACKAGES = ["godot", "libgl1", "libegl1", "libgl1-mesa-dri", "mesa-vulkan-drivers", "patchelf"]
# Raise when the steps below change, so that copies made by older ones are made again.
RECIPE = 1


def bring() -> tuple[Path, str]:
    """(executable, version) of the private copy, made now when there is none."""
    cache = paths.cache_dir()
    found = newest(cache)
    if found:
        return found
    with locks.locked(cache / "godot.lock", "bringing Godot"):
        return newest(cache) or _make(cache)


def newest(cache: Path) -> tuple[Path, str] | None:
    """The newest complete copy in the cache."""
    complete = []
    for folder in cache.glob("godot-*"):
        version = godot_version.parse(folder.name.removeprefix("godot-"))
        if version and stamps.is_fresh(folder / "stamp", _stamp(folder)):
            complete.append((version, folder))
    if not complete:
        return None
    version, folder = max(complete)
    return folder / "bin" / "godot", ".".join(str(part) for part in version)


def _stamp(folder: Path) -> str:
    """The copy knows its own place, so it is complete only where it was made."""
    return stamps.digest(RECIPE, folder, *PACKAGES)


def _make(cache: Path) -> tuple[Path, str]:
    say("Godot 4.6 or newer was not found; bringing a private copy from Debian (about 180 MB, once)")
    log = cache / "godot-setup.log"
    note(f"It goes to {cache}; details in {log.name} there")
    cache.mkdir(parents=True, exist_ok=True)
    log.write_text("", encoding="utf-8")
    apt, version = _suite_with_godot(cache, log)
    text = ".".join(str(part) for part in version)
    note(f"Godot {text} from Debian {apt.suite}")
    files = apt.download(PACKAGES)
    folder = cache / f"godot-{text}"
    shutil.rmtree(folder, ignore_errors=True)
    root = folder / "root"
    root.mkdir(parents=True)
    progress = Progress("unpacked", len(files))
    for done, file in enumerate(files, 1):
        process.require(["dpkg-deb", "-x", file, root], log, f"Unpacking {file.name}", append=True)
        progress.update(done)
    progress.close()
    executable = relocate.relocate(folder, log)
    if godot_version.of_executable(executable) != version:
        raise Failure(f"The private copy of Godot in {folder} does not start. Details in {log}.")
    stamps.write(folder / "stamp", _stamp(folder))
    return executable, text


def _suite_with_godot(cache: Path, log: Path) -> tuple[PrivateApt, tuple[int, int, int]]:
    """The first archive and suite that offer a Godot that is new enough."""
    architecture = (process.capture(["dpkg", "--print-architecture"]) or "amd64").strip()
    seen = []
    for address in archive.candidates():
        for suite in SUITES:
            apt = PrivateApt(cache / "apt", address, suite, architecture, log)
            listed = apt.update()
            offered = apt.candidate("godot")
            version = godot_version.parse(offered or "")
            if version and godot_version.is_enough(version):
                return apt, version
            seen.append(f"{suite}: {offered or ('no Godot' if listed else 'its package lists could not be fetched')}")
    raise Failure(
        "Godot 4.6 or newer was not found on this machine, and Debian's archive gave none:\n    "
        + "\n    ".join(seen)
        + f"\nIs there a network? Details in {log}. Or download Godot 4.6 for Linux from the Godot website, put it\n"
        "on PATH as 'godot' or name it in the variable GODOT, and start again.",
        3,
    )
