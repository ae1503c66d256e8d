# SPDX-License-Identifier: MIT
"""The stage that keeps the exhibit running: simulated visitors and everything that can befall it."""

from __future__ import annotations

import shutil

from kiosk.soak import Soak
from setup import paths
from testing.context import Context
from testing.junit import Case

_PLAIN_S, _LONG_S = 60.0, 1800.0


def stage(context: Context) -> list[Case]:
    """One case: a minute of it, or half an hour."""
    godot = context.project
    seconds = _LONG_S if context.all_variants else _PLAIN_S
    folder = paths.BUILD / "test-results" / "kiosk"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    soak = Soak(godot.executable, seconds, environment=context.environment())
    soak.run(folder)
    told = "; ".join(soak.told)
    print(f"  kiosk: {told}", flush=True)
    wrong = "\n".join([*soak.wrong, told, f"All of it lies in {folder}"]) if soak.wrong else None
    return [Case(f"{seconds:.0f} s of visitors and faults", "kiosk", failure=wrong)]
