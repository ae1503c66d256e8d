#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the panorama that is shipped, and the two modules it is made with. Skips itself where numpy is missing."""

import pathlib
import tempfile
import unittest

try:
    import numpy

    import exr
    import sphere
except ImportError:
    numpy = None

PANORAMA = pathlib.Path(__file__).resolve().parents[2] / "addons" / "blackhole_sky" / "data" / "milky_way.exr"


@unittest.skipIf(numpy is None, "numpy is not installed (Debian: python3-numpy)")
class Modules(unittest.TestCase):
    def test_exr_returns_what_was_written(self) -> None:
        noise = numpy.random.default_rng(1).random((37, 20, 3)).astype(numpy.float16)
        flat = numpy.full((37, 20, 3), 0.25, dtype=numpy.float16)
        with tempfile.TemporaryDirectory() as folder:
            for picture in (noise, flat):
                path = pathlib.Path(folder) / "picture.exr"
                exr.write(path, picture)
                numpy.testing.assert_array_equal(exr.read(path, 20, 37), picture)
            with self.assertRaises(exr.ExrError):
                exr.read(path, 21, 37)

    def test_blur_keeps_the_mean_and_knows_no_seam(self) -> None:
        picture = numpy.zeros((64, 128, 1))
        picture[32, 0] = 1.0
        blurred = sphere.blur(picture, 3.0)
        self.assertAlmostEqual(blurred.sum(), 1.0)
        self.assertAlmostEqual(blurred[32, 127, 0], blurred[32, 1, 0])
        self.assertGreater(blurred[32, 126, 0], 0.01)

    def test_blur_goes_over_the_pole(self) -> None:
        picture = numpy.zeros((64, 128, 1))
        picture[0, 10] = 1.0
        blurred = sphere.blur(picture, 2.0)
        self.assertGreater(blurred[0, 74, 0], 0.5 * blurred[0, 10, 0])


@unittest.skipIf(numpy is None, "numpy is not installed (Debian: python3-numpy)")
class Panorama(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.picture = exr.read(PANORAMA, 2048, 1024).astype(numpy.float64)
        cls.luminance = cls.picture @ (0.2126390, 0.7151687, 0.0721923)

    def mean(self, ra: float, dec: float, radius: float) -> float:
        return sphere.mean_within(self.luminance, ra, dec, radius)

    def test_size_of_the_file(self) -> None:
        self.assertLess(PANORAMA.stat().st_size, 4_000_000)

    def test_values(self) -> None:
        self.assertTrue(numpy.isfinite(self.picture).all())
        self.assertGreaterEqual(self.picture.min(), 0.0)
        self.assertLess(self.picture.max(), 1.0)

    def test_orientation(self) -> None:
        self.assertGreater(self.mean(270.9, -28.5, 1.5), 0.4, "Large Sagittarius cloud")
        self.assertGreater(self.mean(266.4, -28.9, 2.0), 0.1, "galactic centre")
        self.assertGreater(self.mean(80.9, -69.8, 1.0), 20.0 * self.mean(80.9, -60.0, 1.0), "LMC")
        self.assertGreater(self.mean(13.2, -72.8, 1.0), 5.0 * self.mean(346.8, -72.8, 1.0), "SMC, not mirrored")
        self.assertGreater(self.mean(10.68, 41.27, 0.2), 5.0 * self.mean(10.68, 38.0, 0.2), "M31")

    def test_the_dark_floor_is_neither_lifted_nor_crushed(self) -> None:
        # Means of the 8-bit source, decoded; where the galactic pole is all but black, a hundredth of a code.
        self.assertLess(self.mean(192.9, 27.1, 10.0), 3e-6)
        self.assertAlmostEqual(self.mean(40.0, -30.0, 5.0) / 3.70e-6, 1.0, delta=0.2)
        self.assertAlmostEqual(self.mean(200.0, 85.0, 3.0) / 1.466e-4, 1.0, delta=0.1)
        self.assertAlmostEqual(self.mean(30.0, 40.0, 5.0) / 1.826e-3, 1.0, delta=0.05)

    def test_no_contours(self) -> None:
        """The source has 71 values here, and one step in ten is above 9e-4."""
        dark = self.luminance[360:480, 560:720]
        self.assertLess(numpy.percentile(numpy.abs(numpy.diff(dark, axis=1)), 90), 5e-5)
        self.assertGreater(len(numpy.unique(dark)), 10000)

    def test_no_blocks(self) -> None:
        """Steps across the borders of the source's 8 x 8 blocks, which there exceed the next ones by 15 to 28 %."""
        dim = self.picture[:, 1200:1904]
        for axis in (0, 1):
            steps = numpy.abs(numpy.diff(dim, axis=axis)).mean(axis=(1 - axis, 2))
            place = numpy.arange(steps.size) % 8
            beside = steps[(place == 6) | (place == 0)].mean()
            self.assertLess(steps[place == 7].mean() / beside, 1.05)


if __name__ == "__main__":
    unittest.main()
