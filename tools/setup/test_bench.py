# SPDX-License-Identifier: MIT
import json
import unittest

from setup import bench, bench_parts

_PRINTED = json.dumps({
    "benchmarks": [
        {"name": "exact_phi", "cpu_time": 400.0, "time_unit": "ns", "items_per_second": 2.5e6},
        {"name": "bake_tables", "cpu_time": 30.0, "time_unit": "ms"},
    ]
})


class Bench(unittest.TestCase):
    def test_figures_of_the_physics(self) -> None:
        figures = bench_parts.read_core_figures(_PRINTED)
        self.assertEqual(figures, {"exact_phi_per_s": 2.5e6, "bake_tables_s": 0.03})

    def test_the_table_names_each_figure(self) -> None:
        lines = bench.table({"renderer": "mobile", "resolution": [1280, 720], "gpu_ms": {"empty": 1.23456, "march": 2e4}})
        self.assertEqual([line.split(maxsplit=1) for line in lines], [
            ["renderer", "mobile"], ["resolution", "1280 x 720"], ["gpu_ms.empty", "1.235"], ["gpu_ms.march", "20,000"],
        ])
