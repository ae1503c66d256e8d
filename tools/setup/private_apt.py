# SPDX-License-Identifier: MIT
"""An apt of our own: separate lists and downloads, so that newer Debian packages can be fetched without
root and without touching the system."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from setup import process
from setup.console import Failure, Progress

_KEYRING = "/usr/share/keyrings/debian-archive-keyring.gpg"


@dataclass(frozen=True)
class PrivateApt:
    """apt with its state in `folder`, reading one suite of one archive."""

    folder: Path
    archive: str
    suite: str
    architecture: str
    log: Path

    @property
    def archives(self) -> Path:
        """Where the downloaded packages lie; kept, since the archive drops old versions."""
        return self.folder / "archives"

    @property
    def _lists(self) -> Path:
        return self.folder / f"lists-{self.suite}"

    def update(self) -> bool:
        """Fetches the package lists; true when there are any, be it those kept from before."""
        for folder in (self.archives / "partial", self._lists / "partial"):
            folder.mkdir(parents=True, exist_ok=True)
        (self.folder / "status").touch()
        line = f"deb [arch={self.architecture} signed-by={_KEYRING}] {self.archive} {self.suite} main\n"
        (self.folder / "sources.list").write_text(line, encoding="utf-8")
        process.run_logged([*self._apt("apt-get"), "-q", "update"], self.log, append=True)
        return any(self._lists.glob("*_Packages*"))

    def candidate(self, package: str) -> str | None:
        """The version of a package that the suite offers."""
        shown = process.capture([*self._apt("apt-cache"), "show", "--no-all-versions", package]) or ""
        match = re.search(r"^Version: (\S+)$", shown, re.MULTILINE)
        return match.group(1) if match else None

    def download(self, packages: list[str], what: str) -> list[Path]:
        """Fetches packages with all they depend on; returns the files, each after what it depends on.

        `what` names the step should it fail.
        """
        simulated = process.capture([*self._apt("apt-get"), "-s", "install", *packages])
        if simulated is None:
            raise Failure(f"The packages {' '.join(packages)} do not fit together in Debian {self.suite} today.")
        names = installed_names(simulated)
        progress = Progress("package", len(names))

        def watch(line: str) -> None:
            match = re.match(r"Get:(\d+) ", line)
            if match:
                progress.update(int(match.group(1)))

        command = [*self._apt("apt-get"), "-q", "-y", "--download-only", "install", *packages]
        try:
            process.require(command, self.log, what, append=True, on_line=watch)
        finally:
            progress.close()
        return [self._file(name) for name in names]

    def _file(self, name: str) -> Path:
        found = sorted(self.archives.glob(f"{name}_*.deb"))
        if not found:
            raise Failure(f"The package {name} was not downloaded to {self.archives}.")
        return found[0]

    def _apt(self, tool: str) -> list[str]:
        own = self.folder
        options = {
            "Dir::Etc::SourceList": own / "sources.list",
            "Dir::Etc::SourceParts": "/dev/null",
            "Dir::Etc::Preferences": "/dev/null",
            "Dir::Etc::PreferencesParts": "/dev/null",
            "Dir::State": own,
            "Dir::State::Lists": self._lists,
            "Dir::State::status": own / "status",
            "Dir::Cache": own,
            "Dir::Cache::archives": self.archives,
            "Dir::Cache::pkgcache": "",
            "Dir::Cache::srcpkgcache": "",
            "Debug::NoLocking": "true",  # the caller holds a lock of its own
            "APT::Sandbox::User": "",
            "APT::Architecture": self.architecture,
            "APT::Architectures": self.architecture,
            "APT::Install-Recommends": "false",
            "APT::Keep-Downloaded-Packages": "true",
            "Acquire::Languages": "none",
            "Acquire::IndexTargets::deb::DEP-11::DefaultEnabled": "false",
            "Acquire::Retries": "3",
        }
        return [tool, *(part for key, value in options.items() for part in ("-o", f"{key}={value}"))]


def installed_names(simulated: str) -> list[str]:
    """`name_version` of each package that a simulated installation would unpack, in order, as file names have it."""
    names = []
    for line in simulated.splitlines():
        match = re.match(r"Inst (\S+) \((\S+) ", line)
        if match:
            names.append(f"{match.group(1).split(':')[0]}_{match.group(2).replace(':', '%3a')}")
    return names
