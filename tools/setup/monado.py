# SPDX-License-Identifier: MIT
"""Monado, the OpenXR runtime that needs no headset: the system's, or a private copy of Debian's in the user's cache.

It comes only when asked for; without it all but the simulated headset works. An OpenXR runtime has two halves: a
service, and a library that Godot loads into itself. So the private copy of Godot, which runs on its own C library,
takes the private copy of Monado.
"""

from __future__ import annotations

import json
import re
import shutil
import sys
from dataclasses import dataclass
from pathlib import Path

from setup import paths, private_packages, process, relocate, stamps
from setup.console import Failure, note, say
from setup.godot import Godot

PACKAGES = ["monado-service", "libopenxr1-monado", "mesa-vulkan-drivers", "patchelf"]
# Raise when the steps below change, so that copies made by older ones are made again.
RECIPE = 1
_LIBRARY = "libopenxr_monado.so"
_MANIFEST = "openxr_monado.json"
_SYSTEM_MANIFESTS = (Path("/usr/share/openxr/1"), Path("/etc/xdg/openxr/1"), Path("/etc/xdg"))


@dataclass(frozen=True)
class Monado:
    """The service, and the manifest that tells an OpenXR program which library to load."""

    service: Path
    manifest: Path


def find(godot: Godot) -> Monado:
    """The Monado that this Godot can use; brings the private copy when there is none. A Failure says why not."""
    found = None if godot.private else of_system()
    if found is None:
        found = bring()
        _require_loadable(found, godot)
    return found


def of_system() -> Monado | None:
    """The Monado that the system's packages have installed."""
    service = shutil.which("monado-service")
    for folder in _SYSTEM_MANIFESTS:
        if service and (folder / _MANIFEST).is_file():
            return Monado(Path(service), folder / _MANIFEST)
    return None


def bring() -> Monado:
    """The private copy, made now when there is none."""
    cache = paths.cache_dir()
    found = newest(cache)
    if found:
        return found
    with private_packages.locked(cache, "Monado"):
        return newest(cache) or _make(cache)


def newest(cache: Path) -> Monado | None:
    """The newest complete copy in the cache."""
    versions = []
    for text, folder in private_packages.complete(cache, "monado", _stamp):
        versions.append(([int(number) for number in re.findall(r"\d+", text)], folder))
    return _in_folder(max(versions)[1]) if versions else None


def upstream(version: str) -> str:
    """The numbers of a package's version: 25.1.0 of `1:25.1.0+dfsg1-2`; empty when there are none."""
    match = re.match(r"(?:\d+:)?(\d+(?:\.\d+)*)", version)
    return match.group(1) if match else ""


def _in_folder(folder: Path) -> Monado:
    return Monado(folder / "bin" / "monado-service", folder / _MANIFEST)


def _stamp(folder: Path) -> str:
    """The copy knows its own place, so it is complete only where it was made."""
    return stamps.digest(RECIPE, folder, *PACKAGES)


def _make(cache: Path) -> Monado:
    say("Monado was not found; bringing a private copy from Debian (about 90 MB, once)")
    log = cache / "monado-setup.log"
    note(f"It goes to {cache}; details in {log.name} there")
    cache.mkdir(parents=True, exist_ok=True)
    log.write_text("", encoding="utf-8")
    offer = private_packages.offer(
        "monado-service", lambda version: bool(upstream(version)), cache, log, "Monado was not found on this machine",
        "It is needed for the simulated headset only.",
    )
    version = upstream(offer.version)
    note(f"Monado {version} from Debian {offer.apt.suite}")
    files = offer.apt.download(PACKAGES, "Downloading Monado")
    folder = cache / f"monado-{version}"
    shutil.rmtree(folder, ignore_errors=True)
    private_packages.unpack(files, folder / "root", log)
    _install(folder, log)
    stamps.write(folder / "stamp", _stamp(folder))
    return _in_folder(folder)


def _install(folder: Path, log: Path) -> None:
    """Makes Monado run from folder/root."""
    root = relocate.find_root(folder / "root")
    root.gather(log)
    binary = folder / "bin" / "monado-service.bin"
    root.executable("monado-service", binary, log)
    root.starter(_in_folder(folder).service, binary)
    library = folder / "lib" / _LIBRARY
    root.library(root.libraries / _LIBRARY, library, log)
    manifest = {"file_format_version": "1.0.0", "runtime": {"name": "Monado", "library_path": str(library)}}
    _in_folder(folder).manifest.write_text(json.dumps(manifest) + "\n", encoding="utf-8")


def _require_loadable(monado: Monado, godot: Godot) -> None:
    """The library runs on the C library of the Godot that loads it, which must not be the older one."""
    library = json.loads(monado.manifest.read_text(encoding="utf-8"))["runtime"]["library_path"]
    command: list[object] = [sys.executable, "-c", "import ctypes, sys; ctypes.CDLL(sys.argv[1])", library]
    remedy = "Install the packages monado-service and libopenxr1-monado, or unset $GODOT."
    if godot.private:
        root = relocate.find_root(godot.executable.parent.parent / "root")
        command = [root.loader, "--library-path", root.libraries, "--list", library]
        remedy = "The copies are of different age: ./run clean --cache removes them, and the next start brings both."
    if process.capture(command) is None:
        raise Failure(f"{library} cannot be loaded by {godot.executable}. {remedy}", 3)
