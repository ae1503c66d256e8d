#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the invented stars: the file, the law of their numbers, where they lie, and that a seed always means the same."""

import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

import build_synthetic

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "catalogue"))

import star_file  # noqa: E402

COUNT = 20000
# ICRS of the galactic pole and centre, degrees (IAU 1958 system, precessed to J2000).
POLE = (192.85948, 27.12825)
CENTRE = (266.40510, -28.93617)


def unit(ra: float, dec: float) -> tuple[float, float, float]:
    return math.cos(dec) * math.cos(ra), math.cos(dec) * math.sin(ra), math.sin(dec)


def dot(a: tuple[float, ...], b: tuple[float, ...]) -> float:
    return sum(x * y for x, y in zip(a, b))


class Stars(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.data = star_file.encode_columns(build_synthetic.columns(COUNT, 5))
        cls.stars = star_file.decode(cls.data)

    def test_brightest_first_and_nothing_invented_beyond_what_is_drawn(self) -> None:
        magnitudes = [star.v_magnitude for star in self.stars]
        self.assertEqual(len(magnitudes), COUNT)
        self.assertEqual(magnitudes, sorted(magnitudes))
        for star in self.stars:
            self.assertEqual((star.hip, star.name, star.b_minus_v, star.parallax), (0, "", None, None))
            self.assertTrue(2500.0 <= star.temperature <= 30000.0)

    def test_numbers_grow_by_the_law(self) -> None:
        limit = self.stars[-1].v_magnitude
        for brighter in (1.0, 2.0, 4.0):
            count = sum(star.v_magnitude <= limit - brighter for star in self.stars)
            self.assertAlmostEqual(count / (COUNT * 10 ** (-0.45 * brighter)), 1.0, delta=0.02)
        self.assertAlmostEqual(build_synthetic.faintest(118_218), 8.5)

    def test_lie_about_the_galactic_plane(self) -> None:
        pole = unit(*(math.radians(angle) for angle in POLE))
        heights = [dot(pole, unit(star.ra, star.dec)) for star in self.stars]
        self.assertAlmostEqual(sum(heights) / COUNT, 0.0, delta=0.02)
        self.assertGreater(sum(abs(height) < 0.5 for height in heights) / COUNT, 0.7, "within 30 degrees: half the sky")
        self.assertGreater(sum(abs(height) > 0.9 for height in heights), 0, "some at the poles")

    def test_the_axes_are_the_galactic_ones(self) -> None:
        for place, column in ((CENTRE, 0), (POLE, 2)):
            axis = tuple(row[column] for row in build_synthetic.TO_ICRS)
            self.assertGreater(dot(axis, unit(*(math.radians(angle) for angle in place))), 1.0 - 1e-9)

    def test_a_seed_means_the_same_bytes(self) -> None:
        tool = pathlib.Path(build_synthetic.__file__)
        with tempfile.TemporaryDirectory() as folder:
            made = {}
            for name, seed in (("first", 5), ("again", 5), ("other", 6)):
                out = pathlib.Path(folder) / name
                subprocess.run([sys.executable, tool, out, "--stars", str(COUNT), "--seed", str(seed)], check=True)
                made[name] = out.read_bytes()
        self.assertEqual(made["first"], self.data)
        self.assertEqual(made["again"], self.data)
        self.assertNotEqual(made["other"], self.data)

    def test_refuses_what_makes_no_sense(self) -> None:
        tool = pathlib.Path(build_synthetic.__file__)
        for arguments in (["x.stars", "--stars", "0"], ["/no/such/folder/x.stars", "--stars", "10"], []):
            done = subprocess.run([sys.executable, tool, *arguments], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 2)
            self.assertIn("usage:", done.stderr)


if __name__ == "__main__":
    unittest.main()
