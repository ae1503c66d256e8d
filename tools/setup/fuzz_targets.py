# SPDX-License-Identifier: MIT
"""The fuzzers: which there are, how each is started, and what its output says."""

from __future__ import annotations

import re
import sys
from dataclasses import dataclass
from pathlib import Path

from setup import paths
from setup.godot import Godot

FOLDER = paths.OUT / "fuzz"
_SEEDS = paths.SOURCES / "fuzz" / "seeds"
_SCRIPT = "res://tests/fuzz/fuzz.gd"
_PYTHON = paths.ROOT / "tools" / "setup" / "fuzz_capture_list.py"
# More in one piece than any reader asks for, in MiB; and for all of a fuzzer.
_MOST_AT_ONCE, _MOST_MEMORY = 64, 2048


@dataclass(frozen=True)
class Target:
    """One parser. `longest` bounds the inputs of C++ fuzzers, bytes."""

    name: str
    summary: str
    kind: str  # cpp, script or python
    longest: int = 0

    @property
    def folder(self) -> Path:
        """What the fuzzer writes: log, corpus, findings."""
        return FOLDER / self.name


@dataclass(frozen=True)
class Report:
    """What a fuzzer did. `reached`: the edges of the program or the kinds of answers it saw."""

    executions: int
    reached: str
    findings: tuple[str, ...]


TARGETS = (
    Target("star_file", ".stars catalogues", "cpp", 2048),
    Target("star_csv", "star tables as CSV", "cpp", 4096),
    Target("table_file", "lensing tables", "cpp", 512),
    Target("eval_csv", "inputs of ./run lut eval", "cpp", 512),
    Target("shot", "shots of ./run capture", "script"),
    Target("kiosk", "settings of the exhibit", "script"),
    Target("settings", "the user's settings", "script"),
    Target("kept", "what the program keeps between two starts", "script"),
    Target("constellations", "constellation figures", "script"),
    Target("star_names", "star names", "script"),
    Target("picture", "sizes of background pictures", "script"),
    Target("formula", "formulas of the physics cards", "script"),
    Target("capture_list", "lists of ./run capture --batch", "python"),
)


def find(name: str) -> Target | None:
    """The target of this name."""
    return next((target for target in TARGETS if target.name == name), None)


def command(target: Target, seconds: float, seed: int, build: Path | None, godot: Godot | None) -> list[str]:
    """How it is started to run for so long."""
    if target.kind == "cpp":
        assert build is not None
        corpus, findings = target.folder / "corpus", target.folder / "findings"
        for folder in (corpus, findings):
            folder.mkdir(parents=True, exist_ok=True)
        return [
            str(build / "fuzz" / f"{target.name}_fuzz"), f"-max_total_time={max(1, round(seconds))}", f"-seed={seed}",
            f"-max_len={target.longest}", "-timeout=20", f"-rss_limit_mb={_MOST_MEMORY}",
            f"-malloc_limit_mb={_MOST_AT_ONCE}", "-print_final_stats=1", f"-artifact_prefix={findings}/",
            str(corpus), str(_SEEDS / target.name),
        ]
    own = [f"--seconds={seconds:g}", f"--seed={seed}", f"--folder={target.folder}"]
    if target.kind == "python":
        return [sys.executable, str(_PYTHON), *own]
    assert godot is not None
    engine = [str(godot.executable), "--headless", "--audio-driver", "Dummy", "--path", str(paths.ROOT)]
    return [*engine, "-s", _SCRIPT, "--", f"--target={target.name}", *own]


def report(target: Target, status: int, printed: str) -> Report:
    """What the output of a fuzzer says; that it ended badly without a reason is a finding too."""
    if target.kind == "cpp":
        executions = _last(r"stat::number_of_executed_units: (\d+)", printed)
        reached = f"{_last(r'cov: ([0-9]+)', printed) or 0} edges"
        wrong = re.findall(r"^(?:broken: .*|SUMMARY: .*|.*runtime error: .*)$", printed, re.MULTILINE)
        wrong += re.findall(r"Test unit written to (\S+)", printed)
    else:
        executions = _last(r"(\d+) executions", printed)
        reached = f"{_last(r'([0-9]+) kinds of answer', printed) or 0} kinds of answer"
        wrong = re.findall(r"^fuzz: finding .*\n.*$", printed, re.MULTILINE)
        wrong += re.findall(r"^(?:SCRIPT ERROR: .*|handle_crash: .*|Traceback .*)$", printed, re.MULTILINE)
    if executions is None and not wrong:
        wrong = [f"it did not tell what it did; exit status {status}"]
    elif status != 0 and not wrong:
        wrong = [f"exit status {status}"]
    return Report(executions or 0, reached, tuple(dict.fromkeys(wrong)))


def _last(pattern: str, printed: str) -> int | None:
    found = re.findall(pattern, printed)
    return int(found[-1]) if found else None
