#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes a catalogue of invented stars, as many as wanted, to try the program with. README.md in this folder says how."""

import argparse
import array
import math
import pathlib
import random
import sys

TOOLS = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(TOOLS / "catalogue"))

import star_file  # noqa: E402

DEFAULT_STARS = 2_500_000
# The sky's own counts, roughly: 118,218 stars to V = 8.5, and log N = 0.45 V + constant.
COUNT_SLOPE = 0.45
COUNT_AT_8_5 = 118_218
# Stars lie about the galactic plane as exp(-|sin b| / SCALE): three in four within 30 degrees of it.
SCALE = 0.36
# The temperatures below which 0, 1/12, 2/12 ... of the stars lie, kelvin: a bump of red giants, one of F and G dwarfs.
TEMPERATURES = (2700.0, 3650.0, 4050.0, 4350.0, 4650.0, 5150.0, 5750.0, 6200.0, 6700.0, 7600.0, 9200.0, 11500.0, 26000.0)
# From galactic to ICRS axes, by rows (ESA 1997, The Hipparcos and Tycho Catalogues, vol. 1, section 1.5.3).
TO_ICRS = (
    (-0.0548755604, 0.4941094279, -0.8676661490),
    (-0.8734370902, -0.4448296300, -0.1980763734),
    (-0.4838350155, 0.7469822445, 0.4559837762),
)


def faintest(stars: int) -> float:
    """V to which the sky has so many stars."""
    return 8.5 + math.log10(stars / COUNT_AT_8_5) / COUNT_SLOPE


def columns(stars: int, seed: int) -> list[array.array]:
    """The columns of the file: right ascension, declination, V, B-V, temperature, parallax, Hipparcos number."""
    draw = random.Random(seed).random
    sin, cos, log, asin, atan2, root = math.sin, math.cos, math.log, math.asin, math.atan2, math.sqrt
    units = star_file.TURN / math.tau
    whole = int(star_file.TURN)
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = TO_ICRS
    reach = 1.0 - math.exp(-1.0 / SCALE)
    steps = len(TEMPERATURES) - 1
    ra, dec, kelvins = array.array("I"), array.array("i"), array.array("f")
    for _ in range(stars):
        height = -SCALE * log(1.0 - reach * draw())
        if draw() < 0.5:
            height = -height
        across = root(max(1.0 - height * height, 0.0))
        longitude = math.tau * draw()
        x, y = across * cos(longitude), across * sin(longitude)
        place = steps * draw()
        step = int(place)
        cooler = TEMPERATURES[step]
        kelvins.append(round(cooler + (place - step) * (TEMPERATURES[step + 1] - cooler)))
        ra.append(round(units * atan2(yx * x + yy * y + yz * height, xx * x + xy * y + xz * height)) % whole)
        dec.append(round(units * asin(min(max(zx * x + zy * y + zz * height, -1.0), 1.0))))
    # The magnitudes that the law itself gives the first, second, third star: in order, and in a thousandth.
    limit, per_e_fold = faintest(stars), 1.0 / (COUNT_SLOPE * math.log(10.0))
    magnitudes = array.array("f", (round(limit + per_e_fold * log((i + 0.5) / stars), 3) for i in range(stars)))
    unknown = array.array("f", [math.nan]) * stars
    return [ra, dec, magnitudes, unknown, kelvins, unknown, array.array("I", [0]) * stars]


def main() -> int:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=pathlib.Path, help="the .stars file to write")
    parser.add_argument("--stars", type=int, default=DEFAULT_STARS, help=f"how many ({DEFAULT_STARS:,})")
    parser.add_argument("--seed", type=int, default=1, help="another number makes another sky (1)")
    chosen = parser.parse_args()
    if not 1 <= chosen.stars <= 50_000_000:
        parser.error(f"--stars {chosen.stars}: give a number from 1 to 50,000,000")
    data = star_file.encode_columns(columns(chosen.stars, chosen.seed))
    try:
        chosen.out.write_bytes(data)
    except OSError as error:
        parser.error(f"{chosen.out} cannot be written: {error.strerror}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
