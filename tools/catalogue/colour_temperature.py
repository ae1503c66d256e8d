# SPDX-License-Identifier: MIT
"""The temperature of the black body that has a star's observed B-V.

The same definition as gdextension/core/photometry/colour_index.h, written a second time so that each checks the
other: energy-weighted mean of the Planck spectrum through the B and V passbands of Bessell (1990, PASP 102, 1181),
zero point from Bessell, Castelli & Plez (1998, A&A 333, 231, table A2).
"""

import functools
import math

SECOND_RADIATION_CONSTANT = 1.438776877e-2  # m K
BAND_B = (360, (0.0, 0.030, 0.134, 0.567, 0.920, 0.978, 1.000, 0.978, 0.935, 0.853, 0.740, 0.640, 0.536, 0.424,
                0.325, 0.235, 0.150, 0.095, 0.043, 0.009, 0.0))
BAND_V = (470, (0.0, 0.030, 0.163, 0.458, 0.780, 0.967, 1.000, 0.973, 0.898, 0.792, 0.684, 0.574, 0.461, 0.359,
                0.270, 0.197, 0.135, 0.081, 0.045, 0.025, 0.017, 0.013, 0.009, 0.0))
ZERO_POINT = 2.5 * math.log10(632.0 / 363.1)
COOLEST, HOTTEST = 1900.0, 40000.0
WITHOUT_COLOUR = 5772.0


def _mean_radiance(band: tuple[int, tuple[float, ...]], temperature: float) -> float:
    start, response = band
    total = 0.0
    for index, weight in enumerate(response):
        wavelength = (start + 10 * index) * 1e-9
        x = SECOND_RADIATION_CONSTANT / (wavelength * temperature)
        total += weight * (wavelength / 550e-9) ** -5 * math.exp(-x) / -math.expm1(-x)
    return total / sum(response)


def black_body_colour(temperature: float) -> float:
    """B-V of a black body, magnitudes."""
    ratio = _mean_radiance(BAND_B, temperature) / _mean_radiance(BAND_V, temperature)
    return ZERO_POINT - 2.5 * math.log10(ratio)


@functools.cache
def temperature_of(b_minus_v: float | None) -> float:
    """Kelvin, rounded to a whole one, within [1900, 40000]; 5772 for a star without a colour."""
    if b_minus_v is None:
        return WITHOUT_COLOUR
    low, high = math.log(COOLEST), math.log(HOTTEST)
    for _ in range(50):
        middle = 0.5 * (low + high)
        if black_body_colour(math.exp(middle)) > b_minus_v:
            low = middle
        else:
            high = middle
    return float(round(math.exp(0.5 * (low + high))))
