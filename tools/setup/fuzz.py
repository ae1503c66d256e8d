# SPDX-License-Identifier: MIT
"""./run fuzz: tries the parsers with broken files, each for so long, and tells what was found."""

from __future__ import annotations

import random
import time
from dataclasses import dataclass, field
from pathlib import Path

from setup import build, fuzz_targets, packages, paths, prepare, process
from setup.console import Failure, note, say
from setup.fuzz_targets import FOLDER, TARGETS, Report, Target
from setup.godot import Godot

USAGE = "usage: ./run fuzz [TARGET ...] [--minutes N] [--seed N]\ntargets:\n" + "\n".join(
    f"  {target.name:<16}{target.summary}" for target in TARGETS
)
# An engine starts, seeds are read; beyond it a fuzzer hangs.
_GRACE_S = 120.0


@dataclass
class Wish:
    """What the command line asks for."""

    targets: list[Target] = field(default_factory=list)
    minutes: float = 10.0
    seed: int = 0


def run(arguments: list[str]) -> int:
    """The subcommand: one fuzzer after the other; 1 when something was found."""
    if arguments in (["--help"], ["-h"]):
        print(USAGE)
        return 0
    wish = parse(arguments)
    folder, godot = ready(wish.targets)
    found = False
    for target in wish.targets:
        say(f"Trying {target.name}: {target.summary}, {wish.minutes:g} min")
        line, report = tell(target, wish.minutes * 60.0, wish.seed, folder, godot)
        print(line, flush=True)
        for finding in report.findings:
            found = True
            print("    " + finding.replace("\n", "\n    "), flush=True)
    note(f"Logs and what was found are in {FOLDER}")
    return 1 if found else 0


def parse(arguments: list[str]) -> Wish:
    """The command line, taken apart; a Failure for a wrong one."""
    wish, rest = Wish(seed=random.randrange(1, 2**31)), list(arguments)
    while rest:
        word = rest.pop(0)
        target = fuzz_targets.find(word)
        if target is not None:
            wish.targets.append(target)
        elif word in ("--minutes", "--seed") and rest:
            try:
                if word == "--minutes":
                    wish.minutes = float(rest.pop(0))
                else:
                    wish.seed = int(rest.pop(0))
            except ValueError:
                raise Failure(USAGE, 2) from None
        else:
            raise Failure(USAGE, 2)
    if not 0.0 < wish.minutes <= 10000.0 or wish.seed < 1:
        raise Failure(USAGE, 2)
    wish.targets = wish.targets or list(TARGETS)
    return wish


def ready(targets: list[Target]) -> tuple[Path | None, Godot | None]:
    """The build folder of the C++ fuzzers and the project, as far as these targets need them."""
    kinds = {target.kind for target in targets}
    godot = prepare.project() if "script" in kinds else None
    return (compiled() if "cpp" in kinds else None), godot


def compiled() -> Path:
    """The C++ fuzzers, built with clang and what goes with it."""
    packages.ensure([*packages.BUILD, *packages.FUZZERS])
    version = process.capture(["clang++", "-dumpversion"])
    if version is not None:
        packages.ensure([f"libclang-rt-{version.split('.')[0]}-dev"])
    return build.build("fuzz", None, "blackhole_fuzzers")


def tell(
    target: Target, seconds: float, seed: int, folder: Path | None, godot: Godot | None
) -> tuple[str, Report]:
    """Runs one fuzzer; returns a line about it and the report. Its output is in out/fuzz/NAME/log.txt."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    log = target.folder / "log.txt"
    command = fuzz_targets.command(target, seconds, seed, folder, godot)
    begun = time.monotonic()
    status = process.run_logged(command, log, cwd=paths.ROOT, timeout_s=seconds + _GRACE_S)
    report = fuzz_targets.report(target, status, log.read_text(encoding="utf-8", errors="replace"))
    line = (
        f"{target.name}: {report.executions} executions in {time.monotonic() - begun:.0f} s, {report.reached}, "
        f"{len(report.findings)} findings, seed {seed}"
    )
    with (FOLDER / "log.txt").open("a", encoding="utf-8") as whole:
        whole.write(f"{time.strftime('%Y-%m-%d %H:%M:%S')} {line}\n")
    return line, report
