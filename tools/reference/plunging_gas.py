#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Reference vectors of the light of gas that plunges from the last stable orbit round a Schwarzschild hole.

Gas and light are followed by Hamilton's equations in Painleve-Gullstrand coordinates with Cartesian axes,
    ds^2 = -dT^2 + |dx - v dT|^2,  v = -x/r^(3/2),  H = (|p|^2 - (p_T + v.p)^2)/2     (r_s = c = 1),
which are regular at the horizon; no first integral of the motion is used on the way. Where both meet, the frequency is
their scalar product. The equations are integrated with 30 digits by extrapolation of order 16 (Gragg, Bulirsch and
Stoer), which takes about a minute; `--check` repeats all with half the steps' length and prints the largest relative
difference (1e-22).

    python3 tools/reference/plunging_gas.py gdextension/tests/data/plunging_gas.csv
"""

from __future__ import annotations

import argparse
import decimal
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from decimal import Decimal
from pathlib import Path

decimal.getcontext().prec = 30
_ENERGY = (Decimal(8) / 9).sqrt()
_MOMENTUM = Decimal(3).sqrt()
# Doubles, taken as exact.
_RADII = (0.2, 0.33, 0.5, 0.75, 0.95, 1.0, 1.05, 1.2, 1.4, 1.6, 1.9, 2.2, 2.5, 2.75, 2.9, 2.97, 2.99)
_INVERSE_IMPACTS = (0.02, 0.15, 0.27, 0.3, 0.34, 0.37, 0.384, 0.386, 0.42, 0.6, 1.0, 4.0)
_TILTS = (-1.0, 0.55, 0.0, -0.35, 1.0, 0.8, -0.75)
_CRITICAL = 2 / Decimal(27).sqrt()
_FAR = Decimal(12)  # where light that comes from afar or gets there is started
_DEEP = Decimal("0.15")  # the same for light that never was far away
_STEP = Decimal("0.05")
_HEADER = (
    "# gas on its plunge from the last stable orbit (E=sqrt(8/9), L=sqrt(3) r_s c, right-handed about N, in the plane "
    "normal to N), from an integration of both geodesics, good to all digits: r [r_s] of the emission; a = inverse impact "
    "parameter [1/r_s] of the light; tilt = share of its angular momentum along -N; outgoing = 1 where it leaves on its "
    "way out; redshift = nu_infinity/nu_emitted"
)

State = list[Decimal]  # place and momentum, three components each


@dataclass(frozen=True)
class Particle:
    """Somewhere on its way: place, covariant momentum, and p_T, which stays."""

    state: State
    p_time: Decimal

    @property
    def radius(self) -> Decimal:
        return _length(self.state[:3])


def slope(state: State, p_time: Decimal) -> State:
    """Hamilton's equations."""
    x, y, z, px, py, pz = state
    r2 = x * x + y * y + z * z
    fall = 1 / (r2 * r2.sqrt()).sqrt()  # v = -fall x
    along = x * px + y * py + z * pz
    local = p_time - fall * along  # minus the energy that an observer in free fall from rest at infinity measures
    turn = local * fall
    outward = Decimal("1.5") * turn * along / r2  # grad(fall) = -(3/2) fall x/r^2
    return [
        px + turn * x, py + turn * y, pz + turn * z,
        outward * x - turn * px, outward * y - turn * py, outward * z - turn * pz,
    ]


def moved(particle: Particle, step: Decimal) -> Particle:
    """One step of the affine parameter."""
    last: list[State] = []
    start = particle.state
    first = slope(start, particle.p_time)
    counts = range(2, 18, 2)
    for row, count in enumerate(counts):
        h = step / count
        before, now = start, [a + h * b for a, b in zip(start, first)]
        for _ in range(count - 1):
            rate = slope(now, particle.p_time)
            before, now = now, [a + 2 * h * b for a, b in zip(before, rate)]
        rate = slope(now, particle.p_time)
        entries = [[(a + b + h * c) / 2 for a, b, c in zip(now, before, rate)]]
        for column in range(row):
            weight = 1 / ((Decimal(count) / counts[row - column - 1]) ** 2 - 1)
            entries.append([a + weight * (a - b) for a, b in zip(entries[column], last[column])])
        last = entries
    return Particle(last[-1], particle.p_time)


def radial_speed(particle: Particle) -> Decimal:
    """dr/ds."""
    rate = slope(particle.state, particle.p_time)
    return _dot(particle.state[:3], rate[:3]) / particle.radius


def followed(particle: Particle, radius: Decimal, sense: int, rising: bool, fineness: Decimal) -> Particle:
    """The particle where it passes this radius: `sense` 1 forwards or -1 backwards; `rising`: while r grows on that way."""
    for _ in range(100000):
        rate = slope(particle.state, particle.p_time)
        speed = sense * radial_speed(particle)
        quickest = max(
            _length(rate[:3]) / particle.radius, _length(rate[3:]) / _length(particle.state[3:]))
        length = fineness / quickest
        if (speed > 0) == rising and abs(particle.radius - radius) < abs(speed) * length:
            return _landed(particle, radius)
        particle = moved(particle, sense * length)
    raise ArithmeticError("the particle does not come there")


def _landed(particle: Particle, radius: Decimal) -> Particle:
    """The last step, by Newton's method."""
    for _ in range(20):
        off = radius - particle.radius
        if abs(off) < Decimal("1e-26"):
            return particle
        particle = moved(particle, off / radial_speed(particle))
    raise ArithmeticError("the particle turns before it comes there")


def launched(radius: Decimal, p_time: Decimal, momentum: Decimal, mass: int, outgoing: bool) -> Particle:
    """A particle at (r, 0, 0) with this angular momentum about z, from the condition on its mass alone."""
    flow = 1 / radius.sqrt()
    across = momentum / radius
    # p_r^2 + across^2 + mass^2 = (p_T - flow p_r)^2 for its own p_r = p.x/r: a p_r^2 + 2 half p_r + c = 0
    a = 1 - flow * flow
    half = flow * p_time
    c = across * across + mass - p_time * p_time
    root = (half * half - a * c).sqrt()
    p_radial = (root - half) / a if outgoing else c / (root - half)
    return Particle([radius, Decimal(0), Decimal(0), p_radial, across, Decimal(0)], p_time)


def gas_at(radius: Decimal, fineness: Decimal) -> Particle:
    """Gas of the last stable orbit's energy and momentum, followed from the horizon: back up to it, or down."""
    start = launched(Decimal(1), -_ENERGY, _MOMENTUM, 1, False)
    above = radius > 1
    return followed(start, radius, -1 if above else 1, above, fineness)


def light_at(radius: Decimal, a: Decimal, outgoing: bool, fineness: Decimal) -> Particle:
    """Light of energy 1 where it leaves the gas."""
    energy = Decimal(1)
    if a < _CRITICAL and radius < Decimal("1.5"):
        # Turns below the photon sphere: back from where it falls to.
        return followed(launched(_DEEP, -energy, 1 / a, 0, False), radius, -1, not outgoing, fineness)
    return followed(launched(_FAR, -energy, 1 / a, 0, outgoing), radius, -1 if outgoing else 1, False, fineness)


def frequency(light: Particle, gas: Particle, tilt: Decimal) -> Decimal:
    """-k.U with the gas's orbit turned so that it meets the light under this tilt."""
    place, k = light.state[:3], light.state[3:]
    outward = [c / light.radius for c in place]
    pole = _cross(place, k)
    size = _length(pole)
    upright = (1 - tilt * tilt).sqrt()
    normal = [(-tilt * a + upright * b) / size for a, b in zip(pole, _cross(outward, pole))]
    onward = _cross(normal, outward)
    gas_outward = [c / gas.radius for c in gas.state[:3]]
    gas_onward = [-gas_outward[1], gas_outward[0], Decimal(0)]
    u_radial = _dot(gas.state[3:], gas_outward)
    u_onward = _dot(gas.state[3:], gas_onward)
    flow = -1 / light.radius.sqrt()
    local_energies = (light.p_time + flow * _dot(k, outward)) * (gas.p_time + flow * u_radial)
    return local_energies - _dot(k, outward) * u_radial - _dot(k, onward) * u_onward


def _cross(a: Sequence[Decimal], b: Sequence[Decimal]) -> State:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def _dot(a: Sequence[Decimal], b: Sequence[Decimal]) -> Decimal:
    return sum((x * y for x, y in zip(a, b)), Decimal(0))


def _length(a: Sequence[Decimal]) -> Decimal:
    return _dot(a, a).sqrt()


def cases() -> Iterator[tuple[float, float, float, bool]]:
    """r, a, tilt and direction: all light that there is, away from its turning points."""
    number = 0
    for radius in _RADII:
        u = 1 / Decimal(radius)
        for a in _INVERSE_IMPACTS:
            if 1 - u * u * (1 - u) / Decimal(a) ** 2 < Decimal("1e-3"):
                continue
            for outgoing in (False, True) if u < 1 else (False,):
                yield radius, a, _TILTS[number % len(_TILTS)], outgoing
                number += 1


def redshifts(chosen: Sequence[tuple[float, float, float, bool]], fineness: Decimal = _STEP) -> list[Decimal]:
    """nu_infinity/nu_emitted of these cases."""
    gas = {radius: gas_at(Decimal(radius), fineness) for radius, _, _, _ in chosen}
    return [
        1 / frequency(light_at(Decimal(radius), Decimal(a), outgoing, fineness), gas[radius], Decimal(tilt))
        for radius, a, tilt, outgoing in chosen
    ]


def main(arguments: list[str]) -> int:
    parser = argparse.ArgumentParser(description="Integrates the reference vectors of plunging gas.")
    parser.add_argument("--check", action="store_true", help="integrate twice and print the largest difference")
    parser.add_argument("out", type=Path, nargs="?", help="the CSV file to write")
    chosen = parser.parse_args(arguments)
    every = list(cases())
    found = redshifts(every)
    if chosen.check:
        again = redshifts(every, _STEP / 2)
        print(f"{max(abs(a / b - 1) for a, b in zip(found, again)):.1e}")
    if chosen.out:
        lines = [_HEADER, "r,a,tilt,outgoing,redshift"]
        for (radius, a, tilt, outgoing), redshift in zip(every, found):
            lines.append(f"{radius!r},{a!r},{tilt!r},{int(outgoing)},{redshift:.17g}")
        chosen.out.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
