# SPDX-License-Identifier: MIT
"""Writes the .stars format; gdextension/core/catalogue/README.md describes it."""

import array
import dataclasses
import math
import struct
import sys
import zlib

MAGIC = b"BHSTARS\0"
VERSION = 1
EPOCH = 2000.0
TURN = 2.0**32


@dataclasses.dataclass
class Star:
    """One star; angles in radians, ICRS at epoch J2000.0; parallax in milliarcseconds; None where unknown."""

    hip: int
    ra: float
    dec: float
    v_magnitude: float
    b_minus_v: float | None
    temperature: float
    parallax: float | None
    name: str = ""


def _column(code: str, values: list) -> bytes:
    packed = array.array(code, values)
    if packed.itemsize != 4:
        raise RuntimeError(f"array type {code} is not four bytes wide on this machine")
    if sys.byteorder == "big":
        packed.byteswap()
    return packed.tobytes()


def _floats(values: list[float | None]) -> bytes:
    return _column("f", [math.nan if value is None else value for value in values])


def encode(stars: list[Star]) -> bytes:
    """The whole file. The stars must come brightest first."""
    named = [index for index, star in enumerate(stars) if star.name]
    text = b"".join(stars[index].name.encode("utf-8") + b"\0" for index in named)
    payload = b"".join((
        _column("I", [round(star.ra / math.tau * TURN) % 2**32 for star in stars]),
        _column("i", [round(star.dec / math.tau * TURN) for star in stars]),
        _floats([star.v_magnitude for star in stars]),
        _floats([star.b_minus_v for star in stars]),
        _floats([star.temperature for star in stars]),
        _floats([star.parallax for star in stars]),
        _column("I", [star.hip for star in stars]),
        _column("I", named),
        text,
    ))
    head = MAGIC + struct.pack("<IIIId", VERSION, len(stars), len(named), len(text), EPOCH)
    return head + struct.pack("<I", zlib.crc32(payload, zlib.crc32(head))) + payload
