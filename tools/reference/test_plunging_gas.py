#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The committed vectors are what the integration gives: some of them are integrated again."""

import csv
import unittest
from pathlib import Path

import plunging_gas

VECTORS = Path(__file__).resolve().parents[2] / "gdextension" / "tests" / "data" / "plunging_gas.csv"


class Vectors(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with VECTORS.open(encoding="utf-8", newline="") as file:
            cls.head = file.readline()
            cls.rows = list(csv.DictReader(file))

    def test_the_file_says_what_it_holds(self):
        self.assertTrue(self.head.startswith("# "))
        self.assertIn("nu_infinity/nu_emitted", self.head)

    def test_it_has_every_case(self):
        cases = [(float(row["r"]), float(row["a"]), float(row["tilt"]), row["outgoing"] == "1") for row in self.rows]
        self.assertEqual(cases, list(plunging_gas.cases()))

    def test_some_of_them_again(self):
        some = slice(5, None, 40)
        cases = list(plunging_gas.cases())[some]
        for case, row, found in zip(cases, self.rows[some], plunging_gas.redshifts(cases)):
            with self.subTest(case):
                self.assertAlmostEqual(float(found) / float(row["redshift"]), 1.0, delta=1e-15)


if __name__ == "__main__":
    unittest.main()
