#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the comparison with GYOTO, and makes it where GYOTO and the built blackhole-lut are at hand."""

import contextlib
import io
import math
import shutil
import struct
import unittest
from pathlib import Path
from unittest import mock

import gyoto_disk

ROOT = Path(__file__).resolve().parents[2]
LUT = next(
    (path for path in (ROOT / "build" / kind / "lut_cli" / "blackhole-lut" for kind in ("release", "test"))
     if path.is_file()), None)
SIGHT = gyoto_disk.Sight(0.3, 0.1, 7.0, 0.9)
NAN = math.nan


def compare(*arguments):
    """Exit status and what is printed."""
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        status = gyoto_disk.main(arguments)
    return status, printed.getvalue()


class Parts(unittest.TestCase):
    def test_the_scene_is_in_gyotos_units(self):
        text = gyoto_disk.scene(gyoto_disk.View(20.0, math.radians(80.0), 1.0), 8)
        self.assertIn('<Distance unit="geometrical">40.0<', text)
        self.assertIn("<InnerRadius>6.0<", text)
        inclination = float(text.split("<Inclination>")[1].split("<")[0])
        self.assertAlmostEqual(math.degrees(inclination), 100.0, delta=1e-9)

    def test_a_fits_file_is_read(self):
        def image(first, *axes):
            cards = [first, "BITPIX  = -64 / doubles", f"NAXIS   = {len(axes)}"]
            cards += [f"NAXIS{number}  = {size}" for number, size in enumerate(axes, 1)] + ["END"]
            head = "".join(card.ljust(80) for card in cards).ljust(2880).encode("ascii")
            count = math.prod(axes)
            return head + struct.pack(f">{count}d", *range(count)) + bytes(-8 * count % 2880)

        images = list(gyoto_disk.fits_images(image("SIMPLE  = T", 3, 2) + image("XTENSION= 'IMAGE'", 500)))
        self.assertEqual([len(numbers) for numbers in images], [6, 500])
        self.assertEqual(images[0], (0.0, 1.0, 2.0, 3.0, 4.0, 5.0))

    def test_a_difference_is_found(self):
        for solution, passes in (
            ([7.0001, 0.9, NAN, NAN, NAN, NAN], True),  # the same
            ([2.0, 0.5, 7.0001, 0.9, NAN, NAN], True),  # behind the inner edge
            ([7.01, 0.9, NAN, NAN, NAN, NAN], False),  # another radius
            ([7.0001, 0.905, NAN, NAN, NAN, NAN], False),  # another colour
            ([NAN] * 6, False),  # no light
            ([29.0, 0.9, NAN, NAN, NAN, NAN], False),  # elsewhere
        ):
            with self.subTest(solution):
                comparison = gyoto_disk.Comparison(((5e-4, 1e-3),) * 3)
                comparison.counts[0] = 1
                comparison.add(SIGHT, solution)
                self.assertEqual(comparison.passed(), passes)

    def test_without_gyoto_it_says_so(self):
        with mock.patch.object(shutil, "which", return_value=None):
            self.assertEqual(compare("--lut", "nowhere"), (0, "skipped: gyoto is not installed\n"))


@unittest.skipUnless(shutil.which("gyoto"), "gyoto is not installed (Debian: gyoto-bin)")
@unittest.skipUnless(LUT, "blackhole-lut is not built (./run lut)")
class Gyoto(unittest.TestCase):
    def test_the_exact_solution_agrees(self):
        status, printed = compare("--lut", str(LUT), "--pixels", "24")
        self.assertEqual(status, 0, printed)

    def test_the_shaders_tables_agree(self):
        status, printed = compare(
            "--lut", str(LUT), "--pixels", "24", "--table", str(ROOT / "lut" / "schwarzschild.lut"))
        self.assertEqual(status, 0, printed)


if __name__ == "__main__":
    unittest.main()
