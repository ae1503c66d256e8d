# SPDX-License-Identifier: MIT
"""The address of a Debian archive, taken from what this machine's apt already uses."""

from __future__ import annotations

import os

from setup import process
from setup.console import Failure

_FORMAT = "$(ORIGIN)\t$(LABEL)\t$(CODENAME)\t$(REPO_URI)"


def candidates() -> list[str]:
    """Addresses of Debian archives, best first; a Failure when apt knows none.

    $DEBIAN_MIRROR overrides. apt knows whose archive an address is once it has fetched the lists; on a machine
    without lists every configured address is a candidate, and the archive's signature tells which one is Debian's.
    """
    override = os.environ.get("DEBIAN_MIRROR")
    if override:
        return [override.rstrip("/") + "/"]
    printed = process.capture(["apt-get", "indextargets", "--format", _FORMAT, "Created-By: Packages"])
    found = select(printed or "")
    if not found:
        raise Failure(
            "Godot 4.6 or newer was not found, and this machine's apt names no Debian archive to take it from.\n"
            "Please download Godot 4.6 for Linux from the Godot website, put it on PATH as 'godot' or name it in\n"
            "the variable GODOT, and start again.",
            3,
        )
    return found


def select(index_targets: str) -> list[str]:
    """The archive addresses in the output of `apt-get indextargets`, without repetition.

    Third-party archives and the security archive, which carry no Godot, are left out.
    """
    debian: list[str] = []
    unknown: list[str] = []
    for line in index_targets.splitlines():
        origin, label, codename, address = (line.split("\t") + [""] * 4)[:4]
        if not address or "security" in address or "security" in codename or label == "Debian-Security":
            continue
        if origin == "Debian":
            debian.append(address)
        elif not origin:
            unknown.append(address)
    return list(dict.fromkeys(debian or unknown))
