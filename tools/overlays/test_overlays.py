#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the shipped overlay data against the sky, and the builder's steps; what needs the package says so."""

import collections
import csv
import io
import json
import math
import unicodedata
import unittest

import build_overlays
import constellations
import packages
import star_file
import star_names

FIGURES = build_overlays.DATA / build_overlays.CONSTELLATIONS
NAMES = build_overlays.DATA / build_overlays.STAR_NAMES
CACHE = packages.default_cache()


def direction(ra: float, dec: float) -> tuple[float, float, float]:
    """Unit vector of a place in degrees."""
    ra, dec = math.radians(ra), math.radians(dec)
    return math.cos(dec) * math.cos(ra), math.cos(dec) * math.sin(ra), math.sin(dec)


def separation(one: list[float], other: list[float]) -> float:
    """Degrees between two places in degrees."""
    return math.degrees(2.0 * math.asin(0.5 * math.dist(direction(*one), direction(*other))))


class Figures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rows = json.loads(FIGURES.read_text(encoding="utf-8"))["constellations"]
        cls.by_id = {row["id"]: row for row in rows}
        cls.rows = rows
        cls.stars = {star.hip: star for star in star_file.decode(build_overlays.CATALOGUE.read_bytes())}

    def nearest_corner(self, figure: str, hip: int) -> float:
        """Degrees from a star to the nearest corner of a figure."""
        star = self.stars[hip]
        place = [math.degrees(star.ra), math.degrees(star.dec)]
        return min(separation(place, point) for line in self.by_id[figure]["lines"] for point in line)

    def joined(self, figure: str, one: int, other: int) -> bool:
        """Whether a line of the figure runs straight from one star to the other."""
        ends = [[math.degrees(self.stars[hip].ra), math.degrees(self.stars[hip].dec)] for hip in (one, other)]
        for line in self.by_id[figure]["lines"]:
            for pair in zip(line, line[1:]):
                for first, second in (pair, pair[::-1]):
                    if separation(first, ends[0]) < 0.1 and separation(second, ends[1]) < 0.1:
                        return True
        return False

    def test_the_88_constellations(self):
        self.assertEqual(len(self.rows), 88)
        self.assertEqual(len(self.by_id), 88)
        self.assertEqual([row["id"] for row in self.rows], sorted(self.by_id))
        self.assertEqual(len({row["la"] for row in self.rows}), 88)
        self.assertEqual(len({row["de"] for row in self.rows}), 88)
        for row in self.rows:
            self.assertRegex(row["id"], r"\A[A-Z][A-Za-z]{2}\Z")
            for name in (row["la"], row["de"]):
                self.assertRegex(name, r"\A[A-Za-zÄÖÜäöüß]+( [A-Za-zÄÖÜäöüß']+)*\Z")

    def test_names(self):
        known = {"Boo": ("Boötes", "Bärenhüter"), "UMa": ("Ursa Major", "Großer Bär"),
                 "Ser": ("Serpens", "Schlange"), "CrA": ("Corona Australis", "Südliche Krone"), "Cyg": ("Cygnus", "Schwan")}
        for abbreviation, names in known.items():
            self.assertEqual((self.by_id[abbreviation]["la"], self.by_id[abbreviation]["de"]), names)

    def test_every_place_is_one(self):
        for row in self.rows:
            for ra, dec in [*row["labels"], *(point for line in row["lines"] for point in line)]:
                self.assertTrue(0.0 <= ra < 360.0 and -90.0 <= dec <= 90.0, row["id"])
            self.assertTrue(row["lines"], row["id"])
            for line in row["lines"]:
                self.assertGreaterEqual(len(line), 2, row["id"])
                for one, other in zip(line, line[1:]):
                    self.assertTrue(0.01 < separation(one, other) < 45.0, row["id"])

    def test_serpens_has_its_head_and_its_tail(self):
        self.assertEqual(len(self.by_id["Ser"]["labels"]), 2)
        self.assertLess(self.nearest_corner("Ser", 77070), 0.1, "Unukalhai, in the head")
        self.assertLess(self.nearest_corner("Ser", 92946), 0.1, "Alya, in the tail")
        self.assertEqual({len(row["labels"]) for row in self.rows if row["id"] != "Ser"}, {1})

    def test_labels_lie_by_their_figures(self):
        for row in self.rows:
            for label in row["labels"]:
                nearest = min(separation(label, point) for line in row["lines"] for point in line)
                self.assertLess(nearest, 15.0, row["id"])

    def test_orion(self):
        self.assertTrue(self.joined("Ori", 26727, 26311), "Alnitak to Alnilam")
        self.assertTrue(self.joined("Ori", 26311, 25930), "Alnilam to Mintaka")
        for hip in (27989, 24436, 25336, 27366):
            self.assertLess(self.nearest_corner("Ori", hip), 0.1, "Betelgeuse, Rigel, Bellatrix, Saiph")

    def test_the_plough(self):
        dubhe, merak, phecda, megrez, alioth, mizar, alkaid = 54061, 53910, 58001, 59774, 62956, 65378, 67301
        for one, other in ((dubhe, merak), (merak, phecda), (phecda, megrez), (megrez, dubhe), (megrez, alioth),
                           (alioth, mizar), (mizar, alkaid)):
            self.assertTrue(self.joined("UMa", one, other), (one, other))

    def test_other_known_figures(self):
        for figure, hips in {"Cas": (746, 3179, 4427, 6686, 8886), "Cru": (60718, 62434, 61084, 59747),
                             "UMi": (11767, 72607, 75097), "Lyr": (91262,), "CMa": (32349,)}.items():
            for hip in hips:
                self.assertLess(self.nearest_corner(figure, hip), 0.1, (figure, hip))

    def test_corners_are_stars(self):
        """All but a few corners lie on a star that the eye can see."""
        cells = collections.defaultdict(list)
        for star in self.stars.values():
            if star.v_magnitude <= 6.5:
                place = [math.degrees(star.ra), math.degrees(star.dec)]
                cells[round(place[1])].append(place)
        corners = {(ra, dec) for row in self.rows for line in row["lines"] for ra, dec in line}
        alone = [corner for corner in corners if not any(
            separation(corner, star) < 0.1 for cell in (-1, 0, 1) for star in cells[round(corner[1]) + cell])]
        self.assertLess(len(alone), 0.02 * len(corners), alone)


class Names(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rows = list(csv.DictReader(io.StringIO(NAMES.read_text(encoding="utf-8"))))
        cls.by_hip = {int(row["hip"]): row for row in cls.rows}

    def test_known_stars(self):
        # Johnson V and places at J2000.0 as any almanac has them.
        known = ((32349, "Sirius", 101.287, -16.716, -1.46), (91262, "Vega", 279.234, 38.784, 0.03),
                 (11767, "Polaris", 37.955, 89.264, 2.0), (24436, "Rigel", 78.634, -8.202, 0.13),
                 (60718, "Acrux", 186.650, -63.099, 0.8))
        for hip, name, ra, dec, magnitude in known:
            row = self.by_hip[hip]
            self.assertEqual(row["name"], name)
            self.assertLess(separation([float(row["ra_deg"]), float(row["dec_deg"])], [ra, dec]), 0.002, name)
            self.assertAlmostEqual(float(row["vmag"]), magnitude, delta=0.1)

    def test_the_table(self):
        self.assertEqual(tuple(self.rows[0]), star_names.COLUMNS)
        self.assertEqual(len(self.by_hip), len(self.rows), "no star twice")
        magnitudes = [float(row["vmag"]) for row in self.rows]
        self.assertEqual(magnitudes, sorted(magnitudes))
        self.assertLessEqual(magnitudes[-1], star_names.FAINTEST)
        self.assertEqual([row["name"] for row in self.rows[:3]], ["Sirius", "Canopus", "Arcturus"])
        for row in self.rows:
            self.assertTrue(0.0 <= float(row["ra_deg"]) < 360.0 and abs(float(row["dec_deg"])) <= 90.0)
            self.assertEqual(row["name"], unicodedata.normalize("NFC", row["name"]).strip())
            self.assertTrue(row["name"])

    def test_godot_keeps_the_table(self):
        """Godot would take a .csv for translations, and leave it out of exports."""
        settings = NAMES.with_name(NAMES.name + ".import").read_text(encoding="utf-8")
        self.assertIn('importer="keep"', settings)


class Builder(unittest.TestCase):
    def test_right_ascension_is_counted_from_zero(self):
        text = constellations.encode(
            [{"id": "Xyz", "properties": {"desig": "Xyz", "name": "Nova", "de": "Bo\u0308se\u2005Drei"},
              "geometry": {"coordinates": [-90.0, 1.0]}}],
            [{"id": "Xyz", "geometry": {"coordinates": [[[-0.00001, -5.0], [179.5, 0.25]]]}}])
        self.assertEqual(json.loads(text)["constellations"], [
            {"id": "Xyz", "la": "Nova", "de": "Böse Drei", "labels": [[270.0, 1.0]],
             "lines": [[[0.0, -5.0], [179.5, 0.25]]]}])

    def test_faint_and_nameless_stars_are_left_out(self):
        stars = [star_file.Star(hip, 0.5, 0.0, magnitude, None, 5772.0, None, name)
                 for hip, magnitude, name in ((1, 4.0, "A"), (2, 4.0, ""), (3, 4.5, "C, c"), (4, 4.51, "D"))]
        rows = list(csv.reader(io.StringIO(star_names.encode(stars).decode("utf-8"))))
        self.assertEqual([row[:2] for row in rows[1:]], [["1", "A"], ["3", "C, c"]])

    def test_the_shipped_names_are_as_built(self):
        self.assertEqual(NAMES.read_bytes(), build_overlays.build_star_names())

    @unittest.skipUnless(packages.celestial_is_at_hand(CACHE), f"{packages.CELESTIAL_ARCHIVE} is not in {CACHE}")
    def test_the_shipped_figures_are_as_built(self):
        self.assertEqual(FIGURES.read_bytes(), build_overlays.build_constellations(CACHE))


if __name__ == "__main__":
    unittest.main()
