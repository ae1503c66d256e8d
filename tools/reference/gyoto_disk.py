#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A thin disk ray-traced by GYOTO, compared with this project's solution.

GYOTO (Vincent, Paumard, Gourgoulhon and Perrin 2011, Class. Quantum Grav. 28, 225011; Debian: gyoto-bin, tried with
1.4.4) integrates the light's geodesics step by step. Per pixel it says at which radius the line of sight meets the disk
and how the light is shifted; `blackhole-lut eval disk_static` says the same from the exact solution, or from the tables
that the shaders read. The largest differences are printed; the exit status is 1 where they exceed the limits, and 0
with a word about it where there is no GYOTO.

    python3 tools/reference/gyoto_disk.py --lut build/release/lut_cli/blackhole-lut
    python3 tools/reference/gyoto_disk.py --lut ... --table lut/schwarzschild.lut

How GYOTO's scene becomes ours:
* Units. GYOTO's length is G M/c^2, half a Schwarzschild radius.
* Metric. KerrBL of spin 0.
* Observer. ZAMO, "zero angular momentum": at spin 0 the observer at rest in the static frame, at any radius above the
  horizon (GYOTO's default, ObserverAtInfinity, has another frequency at a finite distance). Its axes in KerrBL are
  e1 = -phi (left, where N is up), e2 = -theta (towards N), e3 = -r (to the hole).
* Disk. ThinDisk in the equatorial plane, Keplerian, corotating: N = +z. GYOTO's Inclination is pi minus the angle between
  the observer's place and N.
* Picture. Rectilinear; pixel (i, j) from 1 looks at -x e1 + y e2 + e3 with x = d (i - (n + 1)/2), y = d (j - (n + 1)/2) and
  d = 2 tan(fov/2)/n, if PALN = pi: a ZAMO's picture is turned by pi - PALN. So xi = atan |(x, y)|, psi = atan2(x, y).
* Redshift is nu_observed/nu_emitted in both.
* GYOTO shows the first meeting between the disk's edges, of whatever order; so does the comparison. It finds the time of
  the meeting to 1e-4 G M/c^3, and so the radius, which is up to 2e-5 of it.
"""

from __future__ import annotations

import argparse
import csv
import math
import shutil
import struct
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

_INNER_RS, _OUTER_RS = 3.0, 30.0
_NOTHING = sys.float_info.max  # GYOTO's value of a pixel without light
_MASS_PER_RS = 2.0
# Relative limits of radius and redshift by order; what goes round the hole magnifies the errors of its direction.
_EXACT_LIMITS = ((5e-5, 5e-5),) * 3
_TABLE_LIMITS = ((5e-4, 1e-3), (5e-3, 5e-3), (3e-2, 3e-2))


@dataclass(frozen=True)
class View:
    """A static observer: distance [r_s], angle to N and field of view [rad]."""

    distance: float
    inclination: float
    field: float


VIEWS = (
    View(100.0, math.radians(30.0), math.radians(30.0)),
    View(20.0, math.radians(82.0), math.radians(100.0)),
    View(12.0, math.radians(125.0), math.radians(110.0)),
    View(5.0, math.radians(75.0), math.radians(140.0)),
    View(1.8, math.radians(60.0), math.radians(150.0)),
)


@dataclass(frozen=True)
class Sight:
    """A pixel's viewing direction, and GYOTO's radius [r_s] and redshift there; NaN where it sees no disk."""

    xi: float
    psi: float
    radius: float
    redshift: float


def scene(view: View, pixels: int) -> str:
    """GYOTO's description."""
    return f"""<?xml version="1.0" encoding="UTF-8" standalone="no"?>
<Scenery>
<Metric kind="KerrBL"><Spin>0</Spin></Metric>
<Screen>
<ObserverKind>ZAMO</ObserverKind>
<Time unit="geometrical_time">0</Time>
<Distance unit="geometrical">{_MASS_PER_RS * view.distance!r}</Distance>
<PALN>{math.pi!r}</PALN>
<Inclination>{math.pi - view.inclination!r}</Inclination>
<Argument>0</Argument>
<AngleKind>Rectilinear</AngleKind>
<FieldOfView>{view.field!r}</FieldOfView>
<Resolution>{pixels}</Resolution>
</Screen>
<Astrobj kind="ThinDisk">
<InnerRadius>{_MASS_PER_RS * _INNER_RS!r}</InnerRadius>
<OuterRadius>{_MASS_PER_RS * _OUTER_RS!r}</OuterRadius>
<RMax unit="geometrical">{1.2 * _MASS_PER_RS * _OUTER_RS!r}</RMax>
</Astrobj>
<RelTol>1e-11</RelTol>
<AbsTol>1e-11</AbsTol>
<MaxIter>20000</MaxIter>
<Quantities>Redshift ImpactCoords</Quantities>
</Scenery>
"""


def traced(gyoto: str, view: View, pixels: int, folder: Path) -> list[Sight]:
    """What GYOTO sees."""
    described, picture = folder / "scene.xml", folder / "picture.fits"
    described.write_text(scene(view, pixels), encoding="utf-8")
    picture.unlink(missing_ok=True)
    done = subprocess.run(
        [gyoto, "--nthreads=1", described, picture], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
    if done.returncode != 0 or not picture.is_file():
        raise RuntimeError(f"gyoto failed:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    (redshifts, coordinates) = fits_images(picture.read_bytes())
    pitch = 2.0 * math.tan(0.5 * view.field) / pixels
    sights = []
    for row in range(pixels):
        for column in range(pixels):
            at = row * pixels + column
            x, y = pitch * (column - 0.5 * (pixels - 1)), pitch * (row - 0.5 * (pixels - 1))
            seen = redshifts[at] != _NOTHING and coordinates[16 * at] != _NOTHING
            radius = coordinates[16 * at + 1] / _MASS_PER_RS if seen else math.nan
            sights.append(Sight(math.atan(math.hypot(x, y)), math.atan2(x, y), radius, redshifts[at] if seen else math.nan))
    return sights


def fits_images(data: bytes) -> Iterator[tuple[float, ...]]:
    """The numbers of each image in a FITS file of doubles."""
    block, card = 2880, 80
    place = 0
    while place < len(data):
        words: dict[str, str] = {}
        while "END" not in words:
            for start in range(place, place + block, card):
                line = data[start:start + card].decode("ascii")
                words[line[:8].strip()] = line[10:].split("/")[0].strip()
            place += block
        if words["BITPIX"] != "-64":
            raise ValueError("this FITS image does not hold doubles")
        count = math.prod(int(words[f"NAXIS{axis + 1}"]) for axis in range(int(words["NAXIS"])))
        yield struct.unpack_from(f">{count}d", data, place)
        place += -(-8 * count // block) * block


def solved(lut: Path, table: Path | None, view: View, sights: Sequence[Sight], folder: Path) -> list[list[float]]:
    """r0, g0, r1, g1, r2, g2 of each line of sight from the project's own tool."""
    asked, answered = folder / "in.csv", folder / "out.csv"
    lines = ["u_o,inc,xi,psi"]
    lines += [f"{1.0 / view.distance!r},{view.inclination!r},{sight.xi!r},{sight.psi!r}" for sight in sights]
    asked.write_text("\n".join(lines) + "\n", encoding="utf-8")
    options = ["--table", str(table)] if table else []
    subprocess.run([str(lut), "eval", "disk_static", str(asked), str(answered), *options], check=True)
    with answered.open(encoding="utf-8", newline="") as file:
        return [[float(word) for word in row[4:]] for row in list(csv.reader(file))[1:]]


class Comparison:
    """The largest differences so far, by order."""

    def __init__(self, limits: Sequence[tuple[float, float]]) -> None:
        self.limits = limits
        self.worst = [[0.0, 0.0] for _ in limits]
        self.counts = [0 for _ in limits]
        self.dark = 0
        self.on_edges = 0
        self.torn = 0

    def add(self, sight: Sight, solution: Sequence[float]) -> None:
        """One pixel."""
        radii, shifts = solution[0::2], solution[1::2]
        order = next((n for n, radius in enumerate(radii) if _INNER_RS <= radius <= _OUTER_RS), None)
        if order is None and math.isnan(sight.radius):
            self.dark += 1
            return
        if order is not None and abs(sight.radius / radii[order] - 1.0) < 0.1:
            self.counts[order] += 1
            off = abs(sight.radius / radii[order] - 1.0), abs(sight.redshift / shifts[order] - 1.0)
            self.worst[order] = [max(pair) for pair in zip(self.worst[order], off)]
        elif any(abs(radius / edge - 1.0) < limit[0] for radius, limit in zip((*radii, sight.radius), (
                *self.limits, self.limits[-1])) for edge in (_INNER_RS, _OUTER_RS)):
            self.on_edges += 1  # the disk begins here for the one and not for the other
        else:
            self.torn += 1

    def passed(self) -> bool:
        """Whether all is within the limits, and there was something to compare."""
        return self.torn == 0 and self.counts[0] > 0 and all(
            off <= most for worst, limit in zip(self.worst, self.limits) for off, most in zip(worst, limit))

    def __str__(self) -> str:
        lines = [
            f"order {order}: {count} pixels, radius within {worst[0]:.1e} (limit {limit[0]:.0e}), "
            f"redshift within {worst[1]:.1e} (limit {limit[1]:.0e})"
            for order, (count, worst, limit) in enumerate(zip(self.counts, self.worst, self.limits))
        ]
        lines.append(f"dark in both: {self.dark}; on the disk's edges: {self.on_edges}; light in one only: {self.torn}")
        return "\n".join(lines)


def main(arguments: Sequence[str]) -> int:
    parser = argparse.ArgumentParser(description="Compares a disk that GYOTO traces with the exact solution.")
    parser.add_argument("--lut", type=Path, required=True, help="the built blackhole-lut")
    parser.add_argument("--table", type=Path, help="compare the tables in this file rather than the exact solution")
    parser.add_argument("--pixels", type=int, default=40, help="rows and columns, an even number (40)")
    parser.add_argument("--out", type=Path, help="write every pixel's numbers to this CSV file")
    chosen = parser.parse_args(arguments)
    if chosen.pixels < 2 or chosen.pixels % 2:
        parser.error("--pixels must be even, so that no pixel looks straight at the hole")
    gyoto = shutil.which("gyoto")
    if gyoto is None:
        print("skipped: gyoto is not installed")
        return 0
    comparison = Comparison(_TABLE_LIMITS if chosen.table else _EXACT_LIMITS)
    lines = ["u_o,inc,xi,psi,r_gyoto,g_gyoto,r0,g0,r1,g1,r2,g2"]
    with tempfile.TemporaryDirectory() as name:
        for view in VIEWS:
            sights = traced(gyoto, view, chosen.pixels, Path(name))
            for sight, solution in zip(sights, solved(chosen.lut, chosen.table, view, sights, Path(name))):
                comparison.add(sight, solution)
                numbers = (
                    1.0 / view.distance, view.inclination, sight.xi, sight.psi, sight.radius, sight.redshift, *solution)
                lines.append(",".join(f"{number:.17g}" for number in numbers))
    if chosen.out:
        chosen.out.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(comparison)
    return 0 if comparison.passed() else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
