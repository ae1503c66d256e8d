# SPDX-License-Identifier: MIT
"""Writes and reads the .stars format; gdextension/core/catalogue/README.md describes it."""

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


def _bytes(column: array.array) -> bytes:
    if column.itemsize != 4:
        raise RuntimeError(f"array type {column.typecode} is not four bytes wide on this machine")
    if sys.byteorder == "big":
        column = column[:]
        column.byteswap()
    return column.tobytes()


def _floats(values: list[float | None]) -> array.array:
    return array.array("f", [math.nan if value is None else value for value in values])


def encode(stars: list[Star]) -> bytes:
    """The whole file. The stars must come brightest first."""
    named = [index for index, star in enumerate(stars) if star.name]
    text = b"".join(stars[index].name.encode("utf-8") + b"\0" for index in named)
    return encode_columns([
        array.array("I", [round(star.ra / math.tau * TURN) % 2**32 for star in stars]),
        array.array("i", [round(star.dec / math.tau * TURN) for star in stars]),
        _floats([star.v_magnitude for star in stars]),
        _floats([star.b_minus_v for star in stars]),
        _floats([star.temperature for star in stars]),
        _floats([star.parallax for star in stars]),
        array.array("I", [star.hip for star in stars]),
    ], array.array("I", named), text)


def encode_columns(columns: list[array.array], named: array.array | None = None, text: bytes = b"") -> bytes:
    """The whole file from its columns in their order; `named` are the places of stars with a name, `text` these."""
    payload = b"".join((*(_bytes(column) for column in columns), _bytes(named or array.array("I")), text))
    head = MAGIC + struct.pack("<IIIId", VERSION, len(columns[0]), len(named or ()), len(text), EPOCH)
    return head + struct.pack("<I", zlib.crc32(payload, zlib.crc32(head))) + payload


def _unpack(code: str, data: bytes, offset: int, count: int) -> tuple:
    return struct.unpack_from(f"<{count}{code}", data, offset)


def decode(data: bytes) -> list[Star]:
    """The stars of a whole file. ValueError says what is wrong with it."""
    if len(data) < 36 or data[:8] != MAGIC:
        raise ValueError("not a .stars file")
    version, count, named_count, text_size, _ = struct.unpack_from("<IIIId", data, 8)
    if version != VERSION or len(data) != 36 + 28 * count + 4 * named_count + text_size:
        raise ValueError("another version of the format, or not complete")
    if struct.unpack_from("<I", data, 32)[0] != zlib.crc32(data[36:], zlib.crc32(data[:32])):
        raise ValueError("damaged: the checksum differs")
    columns = [_unpack(code, data, 36 + 4 * count * place, count) for place, code in enumerate("IiffffI")]
    stars = [
        Star(hip, ra / TURN * math.tau, dec / TURN * math.tau, v, None if math.isnan(colour) else colour, temperature,
             None if math.isnan(parallax) else parallax)
        for ra, dec, v, colour, temperature, parallax, hip in zip(*columns)
    ]
    named = _unpack("I", data, 36 + 28 * count, named_count)
    names = data[len(data) - text_size:].decode("utf-8").split("\0")
    for index, name in zip(named, names):
        stars[index].name = name
    return stars
