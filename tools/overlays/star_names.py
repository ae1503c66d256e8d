# SPDX-License-Identifier: MIT
"""The bright stars' proper names as text, with place and magnitude."""

import csv
import io
import math
import unicodedata

from star_file import Star

FAINTEST = 4.5
COLUMNS = ("hip", "name", "ra_deg", "dec_deg", "vmag")


def encode(stars: list[Star]) -> bytes:
    """The table of those stars that have a name and V <= 4.5, in the order given (brightest first)."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(COLUMNS)
    for star in stars:
        # V is stored in single precision: 4.5 itself is exact there.
        if star.name and star.v_magnitude <= FAINTEST:
            writer.writerow((
                star.hip, unicodedata.normalize("NFC", star.name), f"{math.degrees(star.ra):.6f}",
                f"{math.degrees(star.dec):.6f}", f"{star.v_magnitude:.2f}"))
    return text.getvalue().encode("utf-8")
