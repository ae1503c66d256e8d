# SPDX-License-Identifier: MIT
import math
import unittest

from setup import bench_report
from setup.console import Failure


def _figures() -> dict[str, object]:
    times = {
        "empty": 1.0, "plain_stars": 40.0, "lensed_stars_1": 50.0, "lensed_stars_2": 90.0, "plain_panorama": 20.0,
        "lensed_panorama": 40.0, "hidden_disk": 40.0, "disk": 70.0, "march_1000": 4000.0,
    }
    # Every round is slower than the one before, for all pictures alike.
    turns = {name: [slow * (time + (0.0 if name == "empty" else 1.0)) for slow in (1.0, 2.0, 3.0)] for name, time in times.items()}
    return {
        "exact_phi_per_s": 3e6, "bake_tables_s": 0.1, "node_update_ms": 0.05, "catalogue_load_ms": 12.0,
        "first_frame_ms": 700.0, "first_frame_empty_project_ms": 500.0, "first_sky_ms": 2500.0,
        "renderer": "mobile", "device": "a device", "godot": "4.6.3",
        "gpu_ms": times, "gpu_turns_ms": turns,
    }


class Report(unittest.TestCase):
    def test_complete_figures_pass(self) -> None:
        bench_report.check(_figures())

    def test_what_is_missing_or_no_number_is_named(self) -> None:
        figures = _figures()
        del figures["node_update_ms"]
        figures["bake_tables_s"] = math.nan
        times = figures["gpu_ms"]
        assert isinstance(times, dict)
        times["empty"] = math.inf
        del times["march_1000"]
        with self.assertRaises(Failure) as caught:
            bench_report.check(figures)
        for name in ("node_update_ms", "bake_tables_s", "gpu_ms.empty", "gpu_ms.march_1000"):
            self.assertIn(name, str(caught.exception))
        self.assertNotIn("gpu_ms.plain_stars", str(caught.exception))

    def test_no_pictures_at_all(self) -> None:
        figures = _figures()
        figures["gpu_ms"] = None
        with self.assertRaisesRegex(Failure, "gpu_ms.plain_stars"):
            bench_report.check(figures)

    def test_limits(self) -> None:
        held = bench_report.limits(_figures())
        self.assertEqual(held["lensed_stars_2_to_plain"], {"value": 2.25, "at_most": 2.0, "met": False})
        self.assertEqual(held["march_1000_to_lensed_panorama"], {"value": 100.0, "at_least": 30.0, "met": True})
        self.assertEqual(held["node_update_ms"], {"value": 0.05, "at_most": 0.1, "met": True})
        self.assertEqual(held["first_frame_to_empty_project"], {"value": 1.4, "at_most": 1.5, "met": True})
        self.assertNotIn("march_picture_difference", held)

    def test_quotients_are_of_turns_in_the_same_round(self) -> None:
        figures = _figures()
        turns = figures["gpu_turns_ms"]
        assert isinstance(turns, dict)
        turns["disk"][1] *= 5.0  # the machine was busy in one turn
        self.assertAlmostEqual(bench_report.limits(figures)["disk_to_lensed_panorama"]["value"], 1.75)

    def test_turns_that_were_not_kept_are_named(self) -> None:
        figures = _figures()
        turns = figures["gpu_turns_ms"]
        assert isinstance(turns, dict)
        turns["disk"] = []
        with self.assertRaisesRegex(Failure, "gpu_turns_ms"):
            bench_report.check(figures)

    def test_many_stars_are_held_against_limits_when_measured(self) -> None:
        self.assertNotIn("stars_2500k_to_linear", bench_report.limits(_figures()))
        held = bench_report.limits({
            **_figures(), "stars_2500k_load_ms": 1600.0, "stars_2500k_bytes_per_star": 64.0, "stars_2500k_to_linear": 1.2,
        })
        met = {name: entry["met"] for name, entry in held.items() if name.startswith("stars_2500k")}
        self.assertEqual(met, {
            "stars_2500k_load_ms": False, "stars_2500k_bytes_per_star": True, "stars_2500k_to_linear": False,
        })

    def test_a_wrong_marched_picture_is_told(self) -> None:
        held = bench_report.limits({**_figures(), "march_picture": {"median_difference": 0.0, "p99_difference": 0.5}})
        self.assertFalse(held["march_picture_difference"]["met"])

    def test_the_table_shows_what_is_not_met(self) -> None:
        printed = bench_report.lines(bench_report.limits(_figures()))
        missed = [line.split()[0] for line in printed if line.endswith("NOT MET")]
        self.assertEqual(missed, ["lensed_stars_2_to_plain"])
