# SPDX-License-Identifier: MIT
"""Gaussian blur of an equirectangular picture as it lies on the sphere, and brightness within a circle of sky."""

import numpy


def declinations(height: int) -> numpy.ndarray:
    """Of the texel centres of each row, radians, north pole first."""
    return (0.5 - (numpy.arange(height) + 0.5) / height) * numpy.pi


def blur(picture: numpy.ndarray, sigma: float) -> numpy.ndarray:
    """Blurs (height, width, channels) with a Gaussian of sigma texels of the equator, in every direction of the sky.

    Along a row the width grows as 1/cos(declination); along a column the picture goes on beyond the pole on the
    opposite meridian. Both ways are periodic, so the Fourier transform makes no seam. Means are kept.
    """
    height, width, _ = picture.shape
    row_sigma = numpy.minimum(sigma / numpy.cos(declinations(height)), width)
    row_kernel = numpy.exp(-2.0 * (numpy.pi * row_sigma[:, None] * numpy.fft.rfftfreq(width)[None]) ** 2)
    rows = numpy.fft.irfft(numpy.fft.rfft(picture, axis=1) * row_kernel[..., None], width, axis=1)
    great_circles = numpy.concatenate((rows, numpy.roll(rows[::-1], width // 2, axis=1)), axis=0)
    column_kernel = numpy.exp(-2.0 * (numpy.pi * sigma * numpy.fft.rfftfreq(2 * height)) ** 2)
    blurred = numpy.fft.irfft(numpy.fft.rfft(great_circles, axis=0) * column_kernel[:, None, None], 2 * height, axis=0)
    return blurred[:height]


def mean_within(values: numpy.ndarray, ra: float, dec: float, radius: float) -> float:
    """Mean over solid angle of (height, width) values within radius of ICRS (ra, dec); degrees.

    The picture has u = frac(0.25 - RA/360) and v = (90 - Dec)/180.
    """
    height, width = values.shape
    row = declinations(height)[:, None]
    column = (0.25 - (numpy.arange(width) + 0.5) / width)[None] * 2.0 * numpy.pi
    ra, dec = numpy.radians(ra), numpy.radians(dec)
    cosine = numpy.sin(row) * numpy.sin(dec) + numpy.cos(row) * numpy.cos(dec) * numpy.cos(column - ra)
    weight = numpy.where(cosine >= numpy.cos(numpy.radians(radius)), numpy.cos(row), 0.0)
    return float((values * weight).sum() / weight.sum())
