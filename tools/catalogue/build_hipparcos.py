#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes addons/blackhole_sky/data/hipparcos.stars, bit for bit. README.md in this folder says how and why."""

import argparse
import json
import math
import pathlib
import sys

import colour_temperature
import packages
import star_file

YEARS = 2000.0 - 1991.25
MAS = math.radians(1.0 / 3.6e6)
STAR_COUNT = 118_217
TARGET = pathlib.Path(__file__).resolve().parents[2] / "addons" / "blackhole_sky" / "data" / "hipparcos.stars"


def moved(ra: float, dec: float, pm_ra: float, pm_dec: float) -> tuple[float, float]:
    """(ra, dec) at J2000.0 from J1991.25 by straight motion; radians, and radians a year (pm_ra times cos dec)."""
    sin_ra, cos_ra, sin_dec, cos_dec = math.sin(ra), math.cos(ra), math.sin(dec), math.cos(dec)
    east, north = pm_ra * YEARS, pm_dec * YEARS
    x = cos_dec * cos_ra - east * sin_ra - north * sin_dec * cos_ra
    y = cos_dec * sin_ra + east * cos_ra - north * sin_dec * sin_ra
    z = sin_dec + north * cos_dec
    return math.atan2(y, x) % math.tau, math.atan2(z, math.hypot(x, y))


def read_hip2(lines: list[str]) -> dict[int, star_file.Star]:
    """The stars of hip2.dat by HIP number, their Hp standing in for V."""
    stars = {}
    for line in lines:
        hip = int(line[0:6])
        ra, dec = moved(float(line[15:28]), float(line[29:42]), float(line[51:59]) * MAS, float(line[60:68]) * MAS)
        colour = None if float(line[152:158]) == 0.0 and float(line[159:164]) == 0.0 else float(line[152:158])
        stars[hip] = star_file.Star(hip, ra, dec, float(line[129:136]), colour, 0.0, float(line[43:50]))
    return stars


def join_xhip(stars: dict[int, star_file.Star], features: list[dict]) -> None:
    """Puts XHIP's V on the stars, and adds those that hip2.dat lacks, with XHIP's own place and colour."""
    for feature in features:
        hip, properties = feature["id"], feature["properties"]
        if hip in stars:
            stars[hip].v_magnitude = float(properties["mag"])
            continue
        ra, dec = (math.radians(degrees) for degrees in feature["geometry"]["coordinates"])
        colour = float(properties["bv"]) if properties["bv"] else None
        stars[hip] = star_file.Star(hip, ra % math.tau, dec, float(properties["mag"]), colour, 0.0, None)


def build(cache: pathlib.Path) -> bytes:
    """The bytes of hipparcos.stars."""
    stars = read_hip2(packages.hipparcos_lines(cache))
    # V, B-V and places of XHIP (CDS V/137D), and proper names.
    xhip, names = packages.celestial_files(cache, "stars.14.json", "starnames.json")
    join_xhip(stars, json.loads(xhip)["features"])
    if len(stars) != STAR_COUNT:
        raise packages.PackageError(f"{len(stars)} stars instead of {STAR_COUNT}: the packages are not the known ones")
    for hip, entry in json.loads(names).items():
        if int(hip) in stars:
            stars[int(hip)].name = entry["name"]
    for star in stars.values():
        star.temperature = colour_temperature.temperature_of(star.b_minus_v)
    return star_file.encode(sorted(stars.values(), key=lambda star: (star.v_magnitude, star.hip)))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", nargs="?", type=pathlib.Path, default=TARGET, help="default: %(default)s")
    parser.add_argument("--check", action="store_true", help="write nothing; compare with the file that is there")
    parser.add_argument("--cache", type=pathlib.Path, default=packages.default_cache(), help="default: %(default)s")
    options = parser.parse_args()
    try:
        data = build(options.cache)
    except packages.PackageError as error:
        print(f"build_hipparcos: {error}", file=sys.stderr)
        return 1
    if options.check:
        same = options.output.is_file() and options.output.read_bytes() == data
        print(f"{options.output}: {'as built' if same else 'DIFFERS from what the packages give'}")
        return 0 if same else 1
    options.output.write_bytes(data)
    print(f"{options.output}: {STAR_COUNT} stars, {len(data)} bytes")
    return 0


if __name__ == "__main__":
    sys.exit(main())
