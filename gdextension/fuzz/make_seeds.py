# SPDX-License-Identifier: MIT
"""Makes the seeds of the fuzzers again that are no plain text: python3 gdextension/fuzz/make_seeds.py"""

from __future__ import annotations

import math
import struct
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "tools" / "catalogue"))

import star_file  # noqa: E402

SEEDS = HERE / "seeds"
SUN = star_file.Star(0, 0.0, 0.0, -26.7, 0.65, 5772.0, None)
STARS = [
    star_file.Star(32349, 1.7678, -0.2917, -1.44, 0.009, 12800.0, 379.21, "Sirius"),
    star_file.Star(91262, 4.8736, 0.6769, 0.03, -0.001, 13000.0, 128.93, "Wéga"),
    star_file.Star(4294967295, 6.2831853, -math.pi / 2, 13.5, None, 5772.0, -3.0),
]
COMMITTED = HERE.parent.parent / "lut" / "schwarzschild.lut"
WHOLE_FILE, HEADER, PATCHES, LOOKED_UP = b"\0", b"\1", b"\2", b"\x80"


def star_files() -> dict[str, bytes]:
    """Small catalogues, and such whose header lies."""
    good = star_file.encode(STARS)
    lying = bytearray(good)
    lying[12:24] = b"\xff" * 12
    return {
        "one.stars": star_file.encode([SUN]),
        "three.stars": good,
        "cut.stars": good[:100],
        "lying.stars": bytes(lying),
    }


def table_files() -> dict[str, bytes]:
    """Inputs of the kinds that README.md describes."""
    header = COMMITTED.read_bytes()[:72]
    huge = bytearray(header)
    huge[16:24] = struct.pack("<2I", 4096, 4096)
    patches = struct.pack("<4I", 0, 0x3F000000, 70000, 0xBF800000)
    not_finite = struct.pack("<2I", 5, 0x7F800000)
    return {
        "header": HEADER + header,
        "huge_header": HEADER + bytes(huge),
        "start_of_file": WHOLE_FILE + header,
        "no_patch": PATCHES,
        "patches": PATCHES + patches,
        "looked_up": LOOKED_UP + patches,
        "not_finite": PATCHES + not_finite,
    }


def write(folder: str, files: dict[str, bytes]) -> None:
    """Writes one fuzzer's seeds."""
    for name, content in files.items():
        (SEEDS / folder / name).write_bytes(content)


if __name__ == "__main__":
    write("star_file", star_files())
    write("table_file", table_files())
