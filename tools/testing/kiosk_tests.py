# SPDX-License-Identifier: MIT
"""The stage that keeps the exhibit running: simulated visitors and everything that can befall it."""

from __future__ import annotations

import shutil
from pathlib import Path

from kiosk import runtime_loss
from kiosk.soak import Soak
from setup import monado, paths
from setup.console import Failure, tail
from setup.simulated_headset import SimulatedHeadset
from testing.context import Context
from testing.junit import Case

_PLAIN_S, _LONG_S = 60.0, 1800.0
_LOSS = "the headset's runtime dies and comes back"


def stage(context: Context) -> list[Case]:
    """A minute of visitors and faults, or half an hour and the loss of the headset's runtime."""
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
    cases = [Case(f"{seconds:.0f} s of visitors and faults", "kiosk", failure=wrong)]
    return [*cases, _loss(context, folder)] if context.all_variants else cases


def _loss(context: Context, folder: Path) -> Case:
    try:
        runtime = monado.find(context.engine)
    except Failure as failure:
        return Case(_LOSS, "kiosk", skipped=str(failure))
    with SimulatedHeadset(runtime) as headset:
        wrong = runtime_loss.run(context.engine.executable, headset, folder, context.environment())
    return Case(_LOSS, "kiosk", failure=f"{wrong}. The end of the log:\n{tail(folder / 'headset.log')}" if wrong else None)
