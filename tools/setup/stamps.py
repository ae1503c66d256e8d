# SPDX-License-Identifier: MIT
"""Stamps: small files that remember with what inputs a step was last done, so that it is done once."""

from __future__ import annotations

import hashlib
from pathlib import Path


def digest(*parts: object) -> str:
    """A short fingerprint of the inputs of a step."""
    text = "\0".join(str(part) for part in parts)
    return hashlib.sha256(text.encode()).hexdigest()[:32]


def is_fresh(stamp: Path, wanted: str) -> bool:
    """True when the step behind `stamp` was last done with exactly these inputs."""
    try:
        return stamp.read_text(encoding="utf-8").strip() == wanted
    except OSError:
        return False


def write(stamp: Path, wanted: str) -> None:
    """Marks the step as done; in one rename, so that no reader sees half a stamp."""
    stamp.parent.mkdir(parents=True, exist_ok=True)
    fresh = stamp.with_suffix(".new")
    fresh.write_text(wanted + "\n", encoding="utf-8")
    fresh.replace(stamp)
