#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the builder's steps without its packages: motion, the joins, the traps in the data, the file format."""

import math
import struct
import unittest
import zlib

import build_hipparcos
import colour_temperature
import star_file


def hip2_line(hip: int, colour: str, colour_error: str) -> str:
    """A line of hip2.dat with the columns the builder reads."""
    line = [" "] * 176
    for start, text in ((0, f"{hip:6d}"), (15, "1.0000000000"), (29, "0.5000000000"), (43, "  -2.50"),
                        (51, "   0.00"), (60, "   0.00"), (129, " 9.5000"), (152, colour), (159, colour_error)):
        line[start:start + len(text)] = text
    return "".join(line)


class Motion(unittest.TestCase):
    def test_along_the_equator(self):
        ra, dec = build_hipparcos.moved(1.0, 0.0, 1e-6, 0.0)
        self.assertAlmostEqual(ra, 1.0 + 8.75e-6, delta=1e-14)
        self.assertAlmostEqual(dec, 0.0, delta=1e-15)

    def test_right_ascension_runs_faster_near_the_pole(self):
        ra, _ = build_hipparcos.moved(1.0, 1.5, 1e-8, 0.0)
        self.assertAlmostEqual((ra - 1.0) * math.cos(1.5), 8.75e-8, delta=1e-13)

    def test_over_the_pole(self):
        ra, dec = build_hipparcos.moved(1.0, math.pi / 2 - 1e-7, 0.0, 1e-7)
        self.assertAlmostEqual(ra, 1.0 + math.pi, places=6)
        self.assertAlmostEqual(math.pi / 2 - dec, 7.75e-7, delta=1e-12)


class Joins(unittest.TestCase):
    def test_missing_colour_is_not_colour_zero(self):
        stars = build_hipparcos.read_hip2([hip2_line(1, " 0.000", "0.000"), hip2_line(2, " 0.000", "0.012")])
        self.assertIsNone(stars[1].b_minus_v)
        self.assertEqual(stars[2].b_minus_v, 0.0)

    def test_xhip_gives_v_and_the_stars_hip2_lacks(self):
        stars = build_hipparcos.read_hip2([hip2_line(1, " 0.650", "0.012"), hip2_line(2, " 0.650", "0.012")])
        build_hipparcos.join_xhip(stars, [
            {"id": 1, "properties": {"mag": 9.31, "bv": "1.234"}, "geometry": {"coordinates": [0.0, 0.0]}},
            {"id": 3, "properties": {"mag": 7.0, "bv": ""}, "geometry": {"coordinates": [-90.0, 45.0]}}])
        self.assertEqual((stars[1].v_magnitude, stars[1].b_minus_v, stars[1].ra), (9.31, 0.65, 1.0))
        self.assertEqual(stars[2].v_magnitude, 9.5)
        self.assertEqual(stars[2].parallax, -2.5)
        self.assertAlmostEqual(stars[3].ra, 1.5 * math.pi)
        self.assertIsNone(stars[3].b_minus_v)
        self.assertIsNone(stars[3].parallax)


class ColourTemperature(unittest.TestCase):
    def test_sirius_keeps_its_colour(self):
        self.assertAlmostEqual(colour_temperature.temperature_of(0.009), 12813, delta=1)

    def test_limits(self):
        self.assertEqual(colour_temperature.temperature_of(5.46), 1900)
        self.assertEqual(colour_temperature.temperature_of(-0.4), 40000)
        self.assertEqual(colour_temperature.temperature_of(None), 5772)


class Format(unittest.TestCase):
    def test_bytes(self):
        star = star_file.Star(7, math.pi, -math.pi / 4, 1.5, None, 5772.0, None, "Ö")
        data = star_file.encode([star])
        self.assertEqual(len(data), 36 + 28 + 4 + 3)
        self.assertEqual(struct.unpack_from("<8sIIIId", data), (b"BHSTARS\0", 1, 1, 1, 3, 2000.0))
        self.assertEqual(struct.unpack_from("<I", data, 32)[0], zlib.crc32(data[:32] + data[36:]))
        ra, dec, v, colour, temperature, parallax, hip, named = struct.unpack_from("<IiffffII", data, 36)
        self.assertEqual((ra, dec, v, temperature, hip, named), (2**31, -(2**29), 1.5, 5772.0, 7, 0))
        self.assertTrue(math.isnan(colour) and math.isnan(parallax))
        self.assertEqual(data[-3:], "Ö\0".encode())

    def test_reads_what_it_writes(self):
        written = [
            star_file.Star(7, 1.25, -0.5, 1.5, None, 5772.0, None, "Ö"),
            star_file.Star(8, 6.0, 1.5, 2.0, 0.25, 9000.0, -2.5),
            star_file.Star(9, 0.0, 0.0, 3.0, 0.5, 6000.0, 4.0, "third")]
        read = star_file.decode(star_file.encode(written))
        for before, after in zip(written, read, strict=True):
            self.assertAlmostEqual(after.ra, before.ra, delta=1e-9)
            self.assertAlmostEqual(after.dec, before.dec, delta=1e-9)
            after.ra, after.dec = before.ra, before.dec
            self.assertEqual(after, before)

    def test_damage_is_noticed(self):
        data = star_file.encode([star_file.Star(7, 1.25, -0.5, 1.5, None, 5772.0, None, "Ö")])
        for bad in (b"", data[:-1], b"X" + data[1:], data[:40] + b"?" + data[41:]):
            with self.assertRaises(ValueError):
                star_file.decode(bad)


if __name__ == "__main__":
    unittest.main()
