# SPDX-License-Identifier: MIT
"""The addon as a zip, as Godot's asset library wants it: one root folder with `addons/blackhole_sky` in it.

The same files give the same zip, byte by byte: sorted, with one time and one set of permissions.
"""

from __future__ import annotations

import os
import zipfile
from collections.abc import Iterable, Mapping
from pathlib import Path

from package.libraries import Library
from setup import paths
from setup.console import Failure

ADDON = paths.ROOT / "addons" / "blackhole_sky"
DESCRIPTION = "blackhole_sky.gdextension"
# What whoever gets the zip must find in it.
REQUIRED = (
    "LICENSE", "README.md", "CHANGELOG.md", "THIRDPARTY.md", "plugin.cfg", DESCRIPTION, "data/CREDITS.md",
    "data/schwarzschild.lut", "data/hipparcos.stars", "data/milky_way.exr", "data/milky_way.exr.import",
)
_EARLIEST = (1980, 1, 1, 0, 0, 0)  # of all times that a zip can hold
_PERMISSIONS = 0o100644


def content(addon: Path, libraries: Iterable[Library]) -> dict[str, bytes]:
    """What belongs into the addon's folder, by its path there: all files, of those in bin these libraries alone."""
    chosen = list(libraries)
    found = {path.relative_to(addon).as_posix(): path for path in _files(addon) if path.parent != addon / "bin"}
    found |= {f"bin/{library.file}": addon / "bin" / library.file for library in chosen}
    missing = [name for name in REQUIRED if name not in found]
    if missing:
        raise Failure(f"These files are missing in {addon}: {', '.join(missing)}.")
    files = {name: path.read_bytes() for name, path in found.items()}
    files[DESCRIPTION] = with_libraries(files[DESCRIPTION].decode(), chosen).encode()
    return files


def with_libraries(description: str, libraries: Iterable[Library]) -> str:
    """The text of the .gdextension with a line for each library: those that only a package has are put in."""
    lines = description.splitlines()
    at = lines.index("[libraries]") + 1
    for library in libraries:
        line = f'{library.features} = "bin/{library.file}"'
        if line in lines:
            continue
        if any(other.startswith(f"{library.features} =") for other in lines):
            raise Failure(f"{DESCRIPTION} has another file for {library.features} than {library.file}.")
        lines.insert(at + 1, line)
    return "\n".join(lines) + "\n"


def write(zip_file: Path, root: str, files: Mapping[str, bytes]) -> None:
    """Writes the zip; `root` is the name of its root folder."""
    zip_file.parent.mkdir(parents=True, exist_ok=True)
    fresh = zip_file.with_name(zip_file.name + ".new")
    with zipfile.ZipFile(fresh, "w") as archive:
        for name in sorted(files):
            entry = zipfile.ZipInfo(f"{root}/addons/blackhole_sky/{name}", _EARLIEST)
            entry.create_system = 3  # Unix, wherever it is made
            entry.external_attr = _PERMISSIONS << 16
            archive.writestr(entry, files[name], zipfile.ZIP_DEFLATED, 9)
    fresh.replace(zip_file)


def _files(addon: Path) -> Iterable[Path]:
    for folder, names, files in os.walk(addon):
        names[:] = [name for name in names if not name.startswith(".")]
        yield from (Path(folder) / name for name in files if not name.startswith(".") and not name.endswith((".tmp", ".new")))
