# SPDX-License-Identifier: MIT
"""Debian's export templates in a private copy, in the user's cache: programs exported with them run on this machine.

They need the libraries of a newer Debian, which lie beside them; so they prove an export, and are none to hand on.
"""

from __future__ import annotations

import shutil
from dataclasses import dataclass
from pathlib import Path

from setup import godot_version, paths, private_packages, process, relocate, stamps
from setup.console import Failure, note, say

PACKAGES = [
    "godot-template-release", "godot-template-debug", "libgl1", "libegl1", "libgl1-mesa-dri", "mesa-vulkan-drivers",
    "patchelf",
]
# Raise when the steps below change, so that copies made by older ones are made again.
RECIPE = 1
NAMES = {"release": "godot-template-release", "debug": "godot-template-debug"}


@dataclass(frozen=True)
class Templates:
    """The folder of a copy."""

    folder: Path

    def program(self, kind: str) -> Path:
        """The template of a kind, release or debug."""
        return self.folder / "bin" / NAMES[kind]

    def environment_script(self) -> Path:
        """What a shell sources before it starts a program made with these templates."""
        return self.folder / "env.sh"


def bring(version: str) -> Templates:
    """The copy for an engine of this version, made now when there is none. A Failure says what else helps."""
    cache = paths.cache_dir()
    found = of_cache(cache, version)
    if found:
        return found
    with private_packages.locked(cache, "export templates"):
        return of_cache(cache, version) or _make(cache, version)


def of_cache(cache: Path, version: str) -> Templates | None:
    """The complete copy in the cache that fits an engine of this version; the same one if there is."""
    fitting = []
    for text, folder in private_packages.complete(cache, "templates", _stamp):
        if fits(text, version):
            fitting.append((godot_version.parse(text) == godot_version.parse(version), godot_version.parse(text), folder))
    return Templates(max(fitting)[2]) if fitting else None


def fits(template: str, engine: str) -> bool:
    """Whether a template runs what an engine exports: both of one minor version."""
    of_template, of_engine = godot_version.parse(template), godot_version.parse(engine)
    return bool(of_template and of_engine) and of_template[:2] == of_engine[:2]  # type: ignore[index]


def _stamp(folder: Path) -> str:
    """The copy knows its own place, so it is complete only where it was made."""
    return stamps.digest(RECIPE, folder, *PACKAGES)


def _make(cache: Path, engine: str) -> Templates:
    say(f"Bringing export templates for Godot {engine} from Debian (some 60 MB beside the engine's own packages, once)")
    log = cache / "templates-setup.log"
    note(f"They go to {cache}; details in {log.name} there")
    cache.mkdir(parents=True, exist_ok=True)
    log.write_text("", encoding="utf-8")
    offer = private_packages.offer(
        "godot-template-release", lambda version: fits(version, engine), cache, log,
        f"Export templates for Godot {engine} were not found on this machine",
        "Or install the official ones in the editor: Editor, Manage Export Templates.",
    )
    version = godot_version.parse(offer.version)
    assert version is not None
    text = ".".join(str(part) for part in version)
    note(f"Export templates {text} from Debian {offer.apt.suite}")
    files = offer.apt.download(PACKAGES, "Downloading the export templates")
    folder = cache / f"templates-{text}"
    shutil.rmtree(folder, ignore_errors=True)
    private_packages.unpack(files, folder / "root", log)
    templates = Templates(folder)
    _install(templates, log)
    stamps.write(folder / "stamp", _stamp(folder))
    return templates


def _install(templates: Templates, log: Path) -> None:
    root = relocate.find_root(templates.folder / "root")
    root.gather(log)
    for kind, name in NAMES.items():
        root.executable(name, templates.program(kind), log)
    root.starter(templates.folder / "bin" / "start", templates.program("release"))
    printed = process.capture([templates.folder / "bin" / "start", "--headless", "--version"])
    if not printed:
        raise Failure(f"The export templates in {templates.folder} do not start. Details in {log}.")
