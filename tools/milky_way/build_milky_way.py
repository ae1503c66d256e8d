#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes addons/blackhole_sky/data/milky_way.exr from the 8-bit panorama. README.md in this folder says how and why."""

import argparse
import pathlib
import sys

import numpy
from PIL import Image

import exr
from sphere import blur

TARGET = pathlib.Path(__file__).resolve().parents[2] / "addons" / "blackhole_sky" / "data" / "milky_way.exr"
SIZE = (2048, 1024)

# Widths of the blurs that are chosen from, texels of the equator (0.18 degrees). The first is never undercut: it
# band-limits the picture, so that bilinear magnification shows no texel grid.
SIGMAS = (0.6, 1.0, 1.7, 2.8, 4.6, 7.7, 12.8, 21.0, 35.0)
# Root mean square by which two neighbouring blurs differ where there is nothing but grain, quantisation (steps of
# two codes) and compression blocks; in codes of the source, one for each step. Brightness, then colour.
GRAIN = (1.1, 0.70, 0.55, 0.48, 0.45, 0.45, 0.50, 0.60)
COLOUR_GRAIN = (1.1, 0.80, 0.65, 0.55, 0.50, 0.50, 0.50, 0.60)
FLOOR_SIGMA = 24.0  # the mean brightness over this many texels is that of the source


def decode(code: numpy.ndarray) -> numpy.ndarray:
    """Linear light of sRGB codes 0 to 255."""
    value = code / 255.0
    return numpy.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4)


def to_opponent(rgb: numpy.ndarray) -> numpy.ndarray:
    """(mean, red - green, blue - green)."""
    red, green, blue = numpy.moveaxis(rgb, -1, 0)
    return numpy.stack(((red + green + blue) / 3.0, red - green, blue - green), axis=-1)


def to_rgb(opponent: numpy.ndarray) -> numpy.ndarray:
    """Back to RGB; the colour is held within what the brightness allows, so that no channel is negative."""
    mean, red, blue = numpy.moveaxis(opponent, -1, 0)
    green = -(red + blue) / 3.0
    offset = numpy.stack((green + red, green, green + blue), axis=-1)
    least = numpy.minimum(offset.min(axis=-1), -1e-12)
    share = numpy.minimum(1.0, mean / -least)
    return numpy.maximum(mean[..., None] + offset * share[..., None], 0.0)


def smooth(code: numpy.ndarray) -> numpy.ndarray:
    """Linear RGB without steps and blocks, from (height, width, 3) of sRGB codes.

    Every texel becomes a weighted mean of blurs, all taken in linear light; it goes on to a wider one as long as that
    differs from the last by no more than grain does. So the flat dark sky is averaged over several degrees,
    while stars, dust lanes and clouds keep their edges, and no value can over- or undershoot.
    """
    judged = blur(to_opponent(code), SIGMAS[0])
    source = to_opponent(decode(code))
    light = blur(source, SIGMAS[0])
    # Near black the colour is made of the three channels' separate steps: take it from farther around.
    caution = 1.0 + 2.5 * numpy.exp(-blur(to_opponent(code)[..., :1], 4.6) / 5.0)
    result = numpy.zeros_like(light)
    open_share = numpy.ones_like(light)
    for sigma, grain, colour_grain in zip(SIGMAS[1:], GRAIN, COLOUR_GRAIN):
        judged_wider = blur(to_opponent(code), sigma)
        differ = numpy.maximum(blur((judged - judged_wider) ** 2, 1.5 * sigma), 0.0)
        limit = numpy.concatenate((numpy.full_like(caution, grain), colour_grain * caution, colour_grain * caution), -1)
        wider_share = open_share / (1.0 + (differ / limit**2) ** 2)
        result += (open_share - wider_share) * light
        open_share, judged, light = wider_share, judged_wider, blur(source, sigma)
    result += open_share * light
    for _ in range(3):
        missing = blur(source[..., :1] - result[..., :1], FLOOR_SIGMA)
        result[..., :1] = numpy.maximum(result[..., :1] + missing, 0.0)
    return to_rgb(result)


def to_half(light: numpy.ndarray) -> numpy.ndarray:
    """Half floats with the last bit of the fraction rounded away: steps of 0.2 %, and a sixth off the file's size."""
    bits = light.astype(numpy.float16).view(numpy.uint16)
    return ((bits + 1) & 0xFFFE).astype(numpy.uint16).view(numpy.float16)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("source", type=pathlib.Path, help="milkyway.png of Debian's stellarium-data")
    parser.add_argument("output", nargs="?", type=pathlib.Path, default=TARGET, help="default: %(default)s")
    parser.add_argument("--check", action="store_true", help="write nothing; compare with the file that is there")
    options = parser.parse_args()
    with Image.open(options.source) as image:
        if image.mode != "RGB" or image.size != SIZE:
            print(f"{options.source}: an RGB picture of {SIZE[0]} x {SIZE[1]} is wanted", file=sys.stderr)
            return 1
        code = numpy.asarray(image).astype(numpy.float64)
    picture = to_half(smooth(code))
    if options.check:
        committed = exr.read(options.output, *SIZE).astype(numpy.float64)
        # Fourier transforms differ in the last digit from machine to machine: allow for one step of rounding.
        same = numpy.allclose(committed, picture.astype(numpy.float64), rtol=2.1e-3, atol=2.5e-7)
        print(f"{options.output}: {'as built' if same else 'DIFFERS from what the source gives'}")
        return 0 if same else 1
    exr.write(options.output, picture)
    print(f"{options.output}: {SIZE[0]} x {SIZE[1]}, {options.output.stat().st_size} bytes")
    return 0


if __name__ == "__main__":
    sys.exit(main())
