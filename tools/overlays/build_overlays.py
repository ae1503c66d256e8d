#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes constellations.json and star_names.csv of the addon's data, bit for bit. README.md in this folder says how."""

import argparse
import json
import pathlib
import sys

TOOLS = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(TOOLS / "catalogue"))

import constellations  # noqa: E402
import packages  # noqa: E402
import star_file  # noqa: E402
import star_names  # noqa: E402

DATA = TOOLS.parent / "addons" / "blackhole_sky" / "data"
CATALOGUE = DATA / "hipparcos.stars"
CONSTELLATIONS = "constellations.json"
STAR_NAMES = "star_names.csv"


def build_constellations(cache: pathlib.Path) -> bytes:
    """The bytes of constellations.json."""
    files = packages.celestial_files(cache, "constellations.json", "constellations.lines.json")
    labels, lines = (json.loads(text)["features"] for text in files)
    return constellations.encode(labels, lines)


def build_star_names() -> bytes:
    """The bytes of star_names.csv. The built-in catalogue has the names of the same package already."""
    return star_names.encode(star_file.decode(CATALOGUE.read_bytes()))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", nargs="?", type=pathlib.Path, default=DATA, help="folder; default: %(default)s")
    parser.add_argument("--check", action="store_true", help="write nothing; compare with the files that are there")
    parser.add_argument("--cache", type=pathlib.Path, default=packages.default_cache(), help="default: %(default)s")
    options = parser.parse_args()
    try:
        built = {CONSTELLATIONS: build_constellations(options.cache), STAR_NAMES: build_star_names()}
    except (packages.PackageError, ValueError, OSError) as error:
        print(f"build_overlays: {error}", file=sys.stderr)
        return 1
    same = True
    for name, data in built.items():
        path = options.output / name
        if options.check:
            as_built = path.is_file() and path.read_bytes() == data
            print(f"{path}: {'as built' if as_built else 'DIFFERS from what the packages give'}")
            same = same and as_built
        else:
            path.write_bytes(data)
            print(f"{path}: {len(data)} bytes")
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main())
