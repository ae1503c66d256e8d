# SPDX-License-Identifier: MIT
"""Makes unpacked packages run from their folder: own loader, own libraries, own data files."""

from __future__ import annotations

import shlex
import shutil
from pathlib import Path

from setup import process
from setup.console import Failure

# Some packages keep libraries outside the folder that the loader is told of.
_SIDE_FOLDERS = ("pulseaudio", "openxr", "lapack", "blas")


def relocate(folder: Path, log: Path) -> Path:
    """Prepares folder/root (unpacked packages) and returns the executable folder/bin/godot."""
    root = folder / "root"
    libraries = _library_folder(root)
    loader = next(iter(sorted(libraries.glob("ld-linux*.so.*"))), None)
    if loader is None:
        raise Failure(f"No program loader in {libraries}: the packages are incomplete. Details in {log}.")
    _link_side_folders(root, libraries)
    patch = [loader, "--library-path", libraries, root / "usr/bin/patchelf"]
    # These two lead to the system's folders by themselves.
    for pattern in ("libpulse*.so.*", "libLLVM*.so.*"):
        for library in libraries.glob(pattern):
            if not library.is_symlink():
                process.require([*patch, "--remove-rpath", library], log, f"Patching {library.name}", append=True)
    binary = folder / "bin" / "godot.bin"
    binary.parent.mkdir(exist_ok=True)
    shutil.copy2(root / "usr/bin/godot", binary)
    process.require(
        [*patch, "--set-interpreter", loader, "--force-rpath", "--set-rpath", libraries, binary],
        log, "Patching Godot", append=True,
    )
    template = (Path(__file__).parent / "godot_env.sh").read_text(encoding="utf-8")
    values = f"root={shlex.quote(str(root))}\nlibraries={shlex.quote(str(libraries))}\n"
    (folder / "env.sh").write_text(values + template, encoding="utf-8")
    return _starter(folder, binary)


def _library_folder(root: Path) -> Path:
    for folder in sorted((root / "usr/lib").glob("*-linux-gnu*")):
        if (folder / "libc.so.6").exists():
            return folder
    raise Failure(f"No C library under {root}: the packages are incomplete.")


def _link_side_folders(root: Path, libraries: Path) -> None:
    for folder in (*(libraries / name for name in _SIDE_FOLDERS), root / "usr/lib"):
        for library in folder.glob("*.so*") if folder.is_dir() else ():
            link = libraries / library.name
            if not link.exists():
                link.unlink(missing_ok=True)
                link.symlink_to(library)


def _starter(folder: Path, binary: Path) -> Path:
    starter = folder / "bin" / "godot"
    starter.write_text(
        "#!/bin/sh\n"
        f". {shlex.quote(str(folder / 'env.sh'))}\n"
        f'exec {shlex.quote(str(binary))} "$@"\n',
        encoding="utf-8",
    )
    starter.chmod(0o755)
    return starter
