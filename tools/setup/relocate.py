# SPDX-License-Identifier: MIT
"""Makes unpacked packages run from their folder: own loader, own libraries, own data files."""

from __future__ import annotations

import shlex
import shutil
from dataclasses import dataclass
from pathlib import Path

from setup import process
from setup.console import Failure

# Some packages keep libraries outside the folder that the loader is told of.
_SIDE_FOLDERS = ("pulseaudio", "openxr", "lapack", "blas")


@dataclass(frozen=True)
class Root:
    """A folder of unpacked packages, patchelf among them, and where its libraries and its program loader are."""

    path: Path
    libraries: Path
    loader: Path

    def gather(self, log: Path) -> None:
        """Makes the libraries find each other here and nowhere else."""
        _link_side_folders(self.path, self.libraries)
        # These two lead to the system's folders by themselves.
        for pattern in ("libpulse*.so.*", "libLLVM*.so.*"):
            for library in self.libraries.glob(pattern):
                if not library.is_symlink():
                    self._patch(["--remove-rpath", library], library.name, log)

    def executable(self, name: str, target: Path, log: Path) -> None:
        """Copies a program to `target`, to run with the loader and the libraries of this root alone."""
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(self.path / "usr" / "bin" / name, target)
        self._patch(["--set-interpreter", self.loader, *self._search_here(), target], name, log)

    def library(self, library: Path, target: Path, log: Path) -> None:
        """Copies a library to `target`, for a program from elsewhere to load; what it needs it finds in this root."""
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(library, target)
        self._patch([*self._search_here(), target], library.name, log)

    def starter(self, target: Path, binary: Path) -> None:
        """Writes the script `target`, which starts a program with this root's data files; env.sh goes beside `path`."""
        env = self.path.parent / "env.sh"
        template = (Path(__file__).parent / "godot_env.sh").read_text(encoding="utf-8")
        values = f"root={shlex.quote(str(self.path))}\nlibraries={shlex.quote(str(self.libraries))}\n"
        env.write_text(values + template, encoding="utf-8")
        target.write_text(
            "#!/bin/sh\n"
            f". {shlex.quote(str(env))}\n"
            f'exec {shlex.quote(str(binary))} "$@"\n',
            encoding="utf-8",
        )
        target.chmod(0o755)

    def _search_here(self) -> list[object]:
        return ["--force-rpath", "--set-rpath", self.libraries]

    def _patch(self, arguments: list[object], name: str, log: Path) -> None:
        patchelf = [self.loader, "--library-path", self.libraries, self.path / "usr" / "bin" / "patchelf"]
        process.require([*patchelf, *arguments], log, f"Patching {name}", append=True)


def find_root(path: Path) -> Root:
    """The root at `path`; a Failure when C library or loader are not there."""
    for libraries in sorted((path / "usr" / "lib").glob("*-linux-gnu*")):
        if (libraries / "libc.so.6").exists():
            loader = next(iter(sorted(libraries.glob("ld-linux*.so.*"))), None)
            if loader is None:
                raise Failure(f"No program loader in {libraries}: the packages are incomplete.")
            return Root(path, libraries, loader)
    raise Failure(f"No C library under {path}: the packages are incomplete.")


def _link_side_folders(root: Path, libraries: Path) -> None:
    for folder in (*(libraries / name for name in _SIDE_FOLDERS), root / "usr" / "lib"):
        for library in folder.glob("*.so*") if folder.is_dir() else ():
            link = libraries / library.name
            if not link.exists():
                link.unlink(missing_ok=True)
                link.symlink_to(library)
