# SPDX-License-Identifier: MIT
"""The system packages that building, drawing and testing need, and how they get onto the machine."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

from setup import paths, process, stamps
from setup.console import Failure, note, say

BUILD = [
    "g++", "cmake", "ninja-build", "ccache", "python3", "libglm-dev", "libboost-dev", "zlib1g-dev",
    "libcli11-dev", "nlohmann-json3-dev",
]
VIRTUAL_SCREEN = ["xvfb", "xauth"]
# The private copy of Godot brings drivers of its own; a Godot of the system's draws with these on a virtual screen.
SOFTWARE_DRIVERS = ["libgl1", "libgl1-mesa-dri", "libvulkan1", "mesa-vulkan-drivers"]
CHECKS = [
    "git", "libgtest-dev", "libbenchmark-dev", "clang-format", "clang-tidy", "shellcheck", "python3-venv", "python3-numpy",
    "python3-jsonschema",
]

# The fuzzers' compiler; the runtime that goes with it depends on its version.
FUZZERS = ["clang"]

_DPKG_STATUS = Path("/var/lib/dpkg/status")


def ensure(packages: list[str]) -> None:
    """Installs what is missing of `packages`; where that is not allowed, says which command does it."""
    if not shutil.which("dpkg-query"):
        return  # not a Debian system: CMake names what it misses
    wanted = stamps.digest(_DPKG_STATUS.stat().st_mtime_ns, *packages)
    stamp = paths.STAMPS / f"packages-{stamps.digest(*packages)[:8]}"
    if stamps.is_fresh(stamp, wanted):
        return
    missing = missing_packages(packages)
    if missing:
        _install(missing)
        still = missing_packages(packages)
        if still:
            raise Failure(f"These packages are still missing after the installation: {' '.join(still)}")
    stamps.write(stamp, stamps.digest(_DPKG_STATUS.stat().st_mtime_ns, *packages))


def missing_packages(packages: list[str]) -> list[str]:
    """Those of `packages` that are not installed."""
    done = subprocess.run(
        ["dpkg-query", "-W", "-f", "${Package} ${db:Status-Status}\n", *packages],
        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False,
    )
    there = {line.split()[0] for line in done.stdout.splitlines() if line.endswith(" installed")}
    return [package for package in packages if package not in there]


def may_install() -> list[str] | None:
    """What to put before apt-get: nothing for root, sudo where it asks no password; None: not allowed."""
    if os.geteuid() == 0:
        return []
    if process.capture(["sudo", "-n", "true"]) is not None:
        return ["sudo", "-n"]
    return None


def _install(missing: list[str]) -> None:
    say(f"Installing system packages: {' '.join(missing)}")
    prefix = may_install()
    if prefix is None:
        raise Failure(
            "These system packages are missing and only an administrator may install them. Please run\n"
            f"    sudo apt-get install {' '.join(missing)}\n"
            "and start again.",
            3,
        )
    log = paths.LOGS / "packages.log"
    install = [
        *prefix, "env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "-q", "-y",
        "-o", "DPkg::Lock::Timeout=300", "-o", "Acquire::Retries=3",
        "install", "--no-install-recommends", *missing,
    ]
    note(f"Details in {log}")
    if process.run_logged(install, log) == 0:
        return
    # Package lists that are absent or old are the usual reason.
    process.run_logged([*prefix, "apt-get", "-q", "-o", "Acquire::Retries=3", "update"], log, append=True)
    process.require(install, log, "Installing the system packages", append=True)
