# SPDX-License-Identifier: MIT
"""Reads what an exhibit wrote down over a long time, and says what is wrong with it."""

from __future__ import annotations

import csv
import re
import statistics
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

_BEGINS = re.compile(r" visit (\d+) begins")
_ENDS = re.compile(r" visit ends: (\d+),")
_ATTRACT, _START = " state attract", " start, version "
# What is lost when a program is killed in the midst of a visit.
CUT = "cut"


@dataclass(frozen=True)
class Visit:
    """A line of visits.csv."""

    number: int
    reached: str
    end: str


def read_lines(log: Path) -> list[str]:
    """All lines of a log with its older ones, the oldest first."""
    older = sorted(log.parent.glob(log.name + ".*"), key=lambda path: -int(path.suffix[1:]))
    files = [path for path in (*older, log) if path.exists()]
    return [line for path in files for line in path.read_text(encoding="utf-8", errors="replace").splitlines()]


def read_visits(log: Path) -> list[Visit]:
    """The visits of visits.csv and its older ones."""
    lines = [line for line in read_lines(log) if not line.startswith("number,")]
    head = log.read_text(encoding="utf-8").splitlines()[0].split(",") if log.exists() else []
    rows = csv.DictReader(lines, fieldnames=head)
    return [Visit(int(row["number"]), row["reached"], row["end"]) for row in rows]


def wrong_visits(visits: Sequence[Visit], least: int, most_cut: int) -> list[str]:
    """Gaps, doubles, too few, more of them cut than there were faults."""
    wrong = []
    numbers = [visit.number for visit in visits]
    if numbers != list(range(1, len(numbers) + 1)):
        odd = next(i for i, number in enumerate(numbers) if number != i + 1)
        wrong.append(f"visits are not numbered one after the other: {numbers[max(odd - 3, 0):odd + 3]}")
    if len(visits) < least:
        wrong.append(f"only {len(visits)} visits; {least} were expected")
    cut = sum(visit.end == CUT for visit in visits)
    if cut > most_cut:
        wrong.append(f"{cut} visits were cut, and the program was ended {most_cut} times")
    return wrong


def wrong_order(lines: Iterable[str]) -> list[str]:
    """Visits after whose end the exhibit did not come back to calling visitors."""
    wrong: list[str] = []
    state, number = "attract", "0"
    for line in lines:
        if _START in line:
            state = "attract"
        elif _ATTRACT in line:
            if state == "visit":
                wrong.append(f"visit {number}: calls visitors although it has not ended")
            state = "attract"
        elif found := _BEGINS.search(line):
            if state != "attract":
                wrong.append(f"visit {found.group(1)} begins although visit {number} did not lead back to the start")
            state, number = "visit", found.group(1)
        elif found := _ENDS.search(line):
            if state != "visit" or found.group(1) != number:
                wrong.append(f"visit {found.group(1)} ends although it was not on")
            state = "ended"
    return wrong


def slope(samples: Sequence[tuple[float, float]]) -> float:
    """The slope of the straight line that fits best through (seconds, megabytes), in megabytes a minute."""
    if len(samples) < 2:
        return 0.0
    mean_t = sum(t for t, _ in samples) / len(samples)
    mean_m = sum(m for _, m in samples) / len(samples)
    spread = sum((t - mean_t) ** 2 for t, _ in samples)
    together = sum((t - mean_t) * (m - mean_m) for t, m in samples)
    return 60.0 * together / spread if spread > 0.0 else 0.0


def usual_growth(samples: Sequence[tuple[float, float]]) -> float:
    """The median of what the memory grows in a minute, megabytes: what leaks with each visit grows in every minute, while
    a driver takes its share in single steps, when it makes a shader ready that was not shown before."""
    growths = []
    start = 0
    for at, (seconds, memory) in enumerate(samples):
        if seconds - samples[start][0] >= 60.0:
            growths.append(memory - samples[start][1])
            start = at
    return statistics.median(growths) if growths else 0.0
