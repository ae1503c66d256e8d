# SPDX-License-Identifier: MIT
"""What the private copies of Debian's programs have in common: where they come from, unpacking, which are complete."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager
from dataclasses import dataclass
from pathlib import Path

from setup import archive, locks, process, stamps
from setup.console import Failure, Progress
from setup.private_apt import PrivateApt

SUITES = ("forky", "sid")


@dataclass(frozen=True)
class Offer:
    """A suite of an archive, and the version that it has of a package."""

    apt: PrivateApt
    version: str


def locked(cache: Path, what: str) -> AbstractContextManager[None]:
    """One copy is made at a time, since all share one apt."""
    return locks.locked(cache / "packages.lock", f"bringing {what}")


def offer(package: str, is_enough: Callable[[str], bool], cache: Path, log: Path, missing: str, remedy: str) -> Offer:
    """The first archive and suite with a version that is enough; else a Failure: what is missing, and the remedy."""
    architecture = (process.capture(["dpkg", "--print-architecture"]) or "amd64").strip()
    seen = []
    for address in archive.candidates():
        for suite in SUITES:
            apt = PrivateApt(cache / "apt", address, suite, architecture, log)
            listed = apt.update()
            version = apt.candidate(package)
            if version and is_enough(version):
                return Offer(apt, version)
            nothing = f"no {package}" if listed else "its package lists could not be fetched"
            seen.append(f"{suite}: {version or nothing}")
    if not seen:
        raise Failure(f"{missing}, and this machine's apt names no Debian archive to take it from.\n{remedy}", 3)
    lines = "\n    ".join(seen)
    raise Failure(
        f"{missing}, and Debian's archive gave none:\n    {lines}\nIs there a network? Details in {log}. {remedy}", 3
    )


def unpack(files: list[Path], root: Path, log: Path) -> None:
    """Unpacks packages into `root`, which is emptied first."""
    shutil.rmtree(root, ignore_errors=True)
    root.mkdir(parents=True)
    progress = Progress("unpacked", len(files))
    for done, file in enumerate(files, 1):
        process.require(["dpkg-deb", "-x", file, root], log, f"Unpacking {file.name}", append=True)
        progress.update(done)
    progress.close()


def complete(cache: Path, name: str, stamp: Callable[[Path], str]) -> Iterator[tuple[str, Path]]:
    """(version, folder) of each copy in the cache whose making came to its end."""
    for folder in cache.glob(f"{name}-*"):
        if stamps.is_fresh(folder / "stamp", stamp(folder)):
            yield folder.name.removeprefix(f"{name}-"), folder
