# SPDX-License-Identifier: MIT
"""The address of a Debian archive, taken from what this machine's apt already uses."""

from __future__ import annotations

import os
import re

from setup import process
from setup.console import Failure

_FORMAT = "$(ORIGIN)\t$(LABEL)\t$(CODENAME)\t$(REPO_URI)"


def candidates() -> list[str]:
    """Addresses of Debian archives, best first; a Failure when apt knows none.

    $DEBIAN_MIRROR overrides. apt knows whose archive an address is once it has fetched the lists; on a machine
    without lists every configured address is a candidate, and only Debian's own passes the check of the signature.
    """
    override = os.environ.get("DEBIAN_MIRROR")
    if override:
        return [override.rstrip("/") + "/"]
    targets = process.capture(["apt-get", "indextargets", "--format", _FORMAT, "Created-By: Packages"])
    found = known(targets or "") or configured(process.capture(["apt-get", "--print-uris", "update"]) or "")
    if not found:
        raise Failure(
            "Godot 4.6 or newer was not found, and this machine's apt names no Debian archive to take it from.\n"
            "Please download Godot 4.6 for Linux from the Godot website, put it on PATH as 'godot' or name it in\n"
            "the variable GODOT, and start again.",
            3,
        )
    return found


def known(index_targets: str) -> list[str]:
    """Debian's addresses in the output of `apt-get indextargets`, without repetition.

    Third-party archives and the security archive, which carry no Godot, are left out.
    """
    found = []
    for line in index_targets.splitlines():
        origin, label, codename, address = (line.split("\t") + [""] * 4)[:4]
        if origin == "Debian" and label == "Debian" and "security" not in codename and address:
            found.append(address)
    return list(dict.fromkeys(found))


def configured(uris: str) -> list[str]:
    """The addresses in the output of `apt-get --print-uris update`: all that apt is told to use, except security."""
    releases = re.findall(r"^'(\S+/)dists/(\S+)/InRelease'", uris, re.MULTILINE)
    return list(dict.fromkeys(address for address, suite in releases if "security" not in suite))
