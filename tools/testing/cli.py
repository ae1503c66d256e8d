# SPDX-License-Identifier: MIT
"""./test: runs the stages one after the other and counts."""

from __future__ import annotations

import argparse
import contextlib
import itertools
import json
import os
import time
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial

from setup import session
from setup.console import Failure
from testing import (
    editor_tests, fuzz_tests, junit, kiosk_tests, package_tests, programs, sanitized, scripts, style, xr_tests,
)
from testing.context import RESULTS, Context
from testing.junit import Case

_SHOWN_FIRST, _SHOWN_LAST = 6, 14
# Each that draws takes a gigabyte.
_MOST_SIDE_BY_SIDE = 4


@dataclass(frozen=True)
class Stage:
    """A part of ./test that can be run alone."""

    name: str
    summary: str
    run: Callable[[Context], list[Case]]
    long: bool = False  # only where it is named, and with --all
    beside: bool = False  # may run at the same time as its neighbours of this kind, on a machine made ready
    waits: bool = False  # leaves the processors to others most of the time, so it takes the place of none


def _set_up(context: Context) -> list[Case]:
    _ = context.project
    return [Case("packages, Godot, build and import")]


STAGES = [
    Stage("set-up", "the machine, the build and the import", _set_up),
    Stage("rules", "rules of the house: lengths, licence lines, directions", style.rules_stage),
    Stage("format", "clang-format and gdformat", style.format_stage),
    Stage("lint", "clang-tidy, gdlint, shellcheck", style.lint_stage),
    Stage("cpp", "GoogleTest on the physics", programs.cpp_stage),
    # Not beside others: its build takes all processors, and the headset keeps time.
    Stage("fuzz", "a moment of each fuzzer", fuzz_tests.stage),
    Stage("scripts", "scripts, scenes and shaders load without a warning", scripts.scripts_stage),
    # First of those beside each other: it takes long and leaves the processors idle between its pictures.
    Stage("xr", "the headset scene on a simulated headset", xr_tests.stage, beside=True),
    Stage(
        "kiosk", "the exhibit with simulated visitors, killed, hung, its disk full", kiosk_tests.stage,
        beside=True, waits=True,
    ),
    Stage("editor", "the addon in the editor itself, and the class reference", editor_tests.stage, beside=True),
    Stage("provider", "the binding provider under the address sanitizer", programs.provider_stage, beside=True),
    Stage("python", "unit tests of the tools", programs.python_stage, beside=True),
    Stage("gut", "GUT tests of the Godot classes", programs.gut_stage, beside=True),
    *(
        Stage(
            f"render-{renderer}", f"pictures measured, {renderer}", partial(programs.render_stage, renderer=renderer),
            beside=True,
        )
        for renderer in session.RENDERERS
    ),
    Stage("commands", "./run as a visitor uses it", programs.commands_stage, beside=True),
    Stage("package", "the addon's zip in a new project, the demo exported", package_tests.stage, beside=True),
    Stage(
        "sanitized", "core, threads and the extension under the sanitizers (with --all)", sanitized.stage,
        long=True, beside=True,
    ),
]


def main(arguments: list[str]) -> int:
    """Runs the chosen stages; 0 when at least one test ran and none failed, 2 for a wrong command line."""
    listed = "\n".join(f"  {stage.name:<24}{stage.summary}" for stage in STAGES)
    parser = argparse.ArgumentParser(
        prog="./test", description="Builds what is missing and proves it.",
        epilog=f"stages:\n{listed}\n'render' stands for all render stages. Results: out/test/*.xml",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("stages", nargs="*", metavar="STAGE", help="run these stages only")
    parser.add_argument("--all", action="store_true", help="the long variants as well")
    chosen = parser.parse_args(arguments)
    try:
        stages = [stage for stage in select(chosen.stages) if chosen.all or chosen.stages or not stage.long]
    except ValueError as error:
        parser.error(str(error))
    context = Context(all_variants=chosen.all, with_headset=any(stage.name == "xr" for stage in stages))
    started = time.monotonic()
    results = _run_all(stages, context)
    _report(results, time.monotonic() - started)
    cases = [case for _, of_stage in results.values() for case in of_stage]
    failed = sum(case.failure is not None for case in cases)
    print(verdict(cases), flush=True)
    return 1 if failed or not cases else 0


def select(names: list[str]) -> list[Stage]:
    """The stages of these names, in their order; none named: all. ValueError names an unknown one."""
    for name in names:
        if not any(stage.name == name or stage.name.startswith(f"{name}-") for stage in STAGES):
            raise ValueError(f"there is no stage '{name}'")
    return [
        stage for stage in STAGES
        if not names or any(stage.name == name or stage.name.startswith(f"{name}-") for name in names)
    ]


def verdict(cases: list[Case]) -> str:
    """`N passed, N failed`, and how many were skipped when any were."""
    failed = sum(case.failure is not None for case in cases)
    skipped = sum(case.failure is None and case.skipped is not None for case in cases)
    line = f"{len(cases) - failed - skipped} passed, {failed} failed"
    return f"{line}, {skipped} skipped" if skipped else line


def shortened(text: str, whole: str) -> str:
    """The first and the last lines of a long failure, indented; `whole` says where the rest is."""
    lines = text.splitlines()
    hidden = len(lines) - _SHOWN_FIRST - _SHOWN_LAST
    if hidden > 0:
        lines[_SHOWN_FIRST:-_SHOWN_LAST] = [f"... {hidden} more lines in {whole} ..."]
    return "\n".join(f"    {line}" for line in lines)


def _run_all(stages: Iterable[Stage], context: Context) -> dict[str, tuple[float, list[Case]]]:
    """One stage after the other, neighbours that may be run side by side on all processors."""
    results: dict[str, tuple[float, list[Case]]] = {}
    for beside, group in itertools.groupby(stages, lambda stage: stage.beside):
        neighbours = list(group)
        if beside and len(neighbours) > 1:
            _prepare(context)
            workers = min(os.cpu_count() or 1, _MOST_SIDE_BY_SIDE)
            with ThreadPoolExecutor(workers) as busy, ThreadPoolExecutor(1) as waiting:
                done = [(waiting if stage.waits else busy).submit(_run, stage, context) for stage in neighbours]
                results.update((stage.name, one.result()) for stage, one in zip(neighbours, done, strict=True))
        else:
            results.update((stage.name, _run(stage, context)) for stage in neighbours)
    return results


def _prepare(context: Context) -> None:
    """The machine made ready before threads would ask for it. What fails here fails in each stage, with its reason."""
    with contextlib.suppress(Failure, OSError):
        _ = context.project


def _run(stage: Stage, context: Context) -> tuple[float, list[Case]]:
    print(f"[{stage.name}]", flush=True)
    started = time.monotonic()
    try:
        cases = stage.run(context) or [Case("runs", stage.name, failure="the stage found nothing to test")]
    except Failure as failure:
        cases = [Case("runs", stage.name, failure=str(failure))]
    except OSError as error:
        cases = [Case("runs", stage.name, failure=f"cannot run: {error}")]
    seconds = time.monotonic() - started
    junit.write(RESULTS / f"{stage.name}.xml", stage.name, cases)
    lines = []
    for case in cases:
        if case.failure is not None:
            lines.append(f"  FAILED {case.group}: {case.name}\n{shortened(case.failure, f'{RESULTS / stage.name}.xml')}")
        elif case.skipped is not None:
            lines.append(f"  skipped {case.group}: {case.name}: {case.skipped}")
    print("\n".join([*lines, f"  {stage.name}: {verdict(cases)} in {seconds:.1f} s"]), flush=True)
    return seconds, cases


def _report(results: dict[str, tuple[float, list[Case]]], total: float) -> None:
    """The time of each stage and of all of them, for the reader and as out/test/times.json."""
    print("\nstage                     seconds  result")
    for name, (seconds, cases) in results.items():
        print(f"{name:<24}{seconds:>9.1f}  {verdict(cases)}")
    print(f"{'total':<24}{total:>9.1f}\n")
    times = {name: round(seconds, 2) for name, (seconds, _) in results.items()}
    (RESULTS / "times.json").write_text(json.dumps(times, indent=2) + "\n", encoding="utf-8")
