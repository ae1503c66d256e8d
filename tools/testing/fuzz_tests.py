# SPDX-License-Identifier: MIT
"""The stage that lets each fuzzer run for a moment; longer runs are ./run fuzz."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

from setup import fuzz
from setup.fuzz_targets import TARGETS, Target
from testing.context import Context
from testing.junit import Case

_SECONDS, _LONG_SECONDS = 2.0, 30.0
# So that a test that passed passes again.
_SEED = 1


def stage(context: Context) -> list[Case]:
    """One case per fuzzer: it tried something, something was accepted on the way, and nothing was found."""
    godot = context.project
    folder = fuzz.compiled()
    seconds = _LONG_SECONDS if context.all_variants else _SECONDS

    def case(target: Target) -> Case:
        line, report = fuzz.tell(target, seconds, _SEED, folder, godot)
        wrong = list(report.findings)
        if not wrong and report.executions == 0:
            wrong = [line]
        return Case(target.name, "fuzz", failure="\n".join(wrong) or None)

    with ThreadPoolExecutor(2) as pool:
        return list(pool.map(case, TARGETS))
