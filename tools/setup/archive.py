# SPDX-License-Identifier: MIT
"""The address of a Debian archive, taken from what this machine's apt already uses."""

from __future__ import annotations

import os
import re

from setup import process

_FORMAT = "$(ORIGIN)\t$(LABEL)\t$(CODENAME)\t$(REPO_URI)"


def candidates() -> list[str]:
    """Addresses of Debian archives, best first; none when apt knows none.

    $DEBIAN_MIRROR overrides. apt knows whose archive an address is once it has fetched the lists; on a machine
    without lists every configured address is a candidate, and only Debian's own passes the check of the signature.
    """
    override = os.environ.get("DEBIAN_MIRROR")
    if override:
        return [override.rstrip("/") + "/"]
    targets = process.capture(["apt-get", "indextargets", "--format", _FORMAT, "Created-By: Packages"])
    return known(targets or "") or configured(process.capture(["apt-get", "--print-uris", "update"]) or "")


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
