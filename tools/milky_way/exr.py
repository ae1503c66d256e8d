# SPDX-License-Identifier: MIT
"""Writes and reads OpenEXR files of half-float RGB, ZIP compressed, with nothing but zlib and numpy."""

import pathlib
import struct
import zlib

import numpy

ROWS_PER_BLOCK = 16  # of EXR's ZIP compression
CHANNELS = "BGR"  # EXR stores them in alphabetical order


class ExrError(RuntimeError):
    """The file is not one that is read here."""


def _attribute(name: str, kind: str, value: bytes) -> bytes:
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value


def _header(width: int, height: int) -> bytes:
    channels = b"".join(name.encode() + b"\0" + struct.pack("<iiii", 1, 0, 1, 1) for name in CHANNELS) + b"\0"
    window = struct.pack("<iiii", 0, 0, width - 1, height - 1)
    return b"".join((
        struct.pack("<ii", 20000630, 2),
        _attribute("channels", "chlist", channels),
        _attribute("compression", "compression", b"\x03"),
        _attribute("dataWindow", "box2i", window),
        _attribute("displayWindow", "box2i", window),
        _attribute("lineOrder", "lineOrder", b"\0"),
        _attribute("pixelAspectRatio", "float", struct.pack("<f", 1.0)),
        _attribute("screenWindowCenter", "v2f", struct.pack("<ff", 0.0, 0.0)),
        _attribute("screenWindowWidth", "float", struct.pack("<f", 1.0)),
        b"\0",
    ))


def _pack(raw: bytes) -> bytes:
    """EXR's ZIP: even bytes before odd bytes, differences, deflate."""
    values = numpy.frombuffer(raw, dtype=numpy.uint8)
    parted = numpy.concatenate((values[0::2], values[1::2])).astype(numpy.int16)
    parted[1:] = parted[1:] - parted[:-1] + 128
    packed = zlib.compress((parted & 255).astype(numpy.uint8).tobytes(), 9)
    return packed if len(packed) < len(raw) else raw


def _unpack(packed: bytes, size: int) -> bytes:
    if len(packed) >= size:
        return packed
    values = numpy.frombuffer(zlib.decompress(packed), dtype=numpy.uint8).astype(numpy.int64)
    values[1:] -= 128
    parted = (numpy.cumsum(values) & 255).astype(numpy.uint8)
    joined = numpy.empty(size, dtype=numpy.uint8)
    joined[0::2], joined[1::2] = parted[:(size + 1) // 2], parted[(size + 1) // 2:]
    return joined.tobytes()


def write(path: pathlib.Path, picture: numpy.ndarray) -> None:
    """Writes (height, width, 3) of float16, linear RGB."""
    height, width, _ = picture.shape
    head = _header(width, height)
    blocks = []
    for y in range(0, height, ROWS_PER_BLOCK):
        rows = picture[y:y + ROWS_PER_BLOCK, :, ::-1].astype("<f2")
        packed = _pack(rows.transpose(0, 2, 1).tobytes())
        blocks.append(struct.pack("<ii", y, len(packed)) + packed)
    offset, table = len(head) + 8 * len(blocks), b""
    for block in blocks:
        table += struct.pack("<Q", offset)
        offset += len(block)
    path.write_bytes(head + table + b"".join(blocks))


def read(path: pathlib.Path, width: int, height: int) -> numpy.ndarray:
    """(height, width, 3) of float16 from a file of that size written by this module."""
    data = path.read_bytes() if path.is_file() else b""
    head = _header(width, height)
    if not data.startswith(head):
        raise ExrError(f"{path} is not an EXR of {width} x {height} as written by this tool")
    picture = numpy.empty((height, width, 3), dtype=numpy.float16)
    at = len(head) + 8 * -(-height // ROWS_PER_BLOCK)
    while at < len(data):
        y, size = struct.unpack_from("<ii", data, at)
        rows = min(ROWS_PER_BLOCK, height - y)
        raw = _unpack(data[at + 8:at + 8 + size], rows * width * 6)
        block = numpy.frombuffer(raw, dtype="<f2").reshape(rows, 3, width)
        picture[y:y + rows] = block.transpose(0, 2, 1)[..., ::-1]
        at += 8 + size
    return picture
