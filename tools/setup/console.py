# SPDX-License-Identifier: MIT
"""What the visitor reads: progress on stderr, so that stdout carries results only."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from pathlib import Path


class Failure(Exception):
    """A step that cannot go on; the text says why and what to do, in words for the visitor."""

    def __init__(self, message: str, code: int = 1) -> None:
        super().__init__(message)
        self.code = code


def say(text: str) -> None:
    """Announces one step."""
    print(f"==> {text}", file=sys.stderr, flush=True)


def note(text: str) -> None:
    """A remark under a step."""
    print(f"    {text}", file=sys.stderr, flush=True)


class Progress:
    """A counter: one line that is rewritten on a terminal, a line per tenth elsewhere."""

    def __init__(self, label: str, total: int = 0) -> None:
        self._label = label
        self._total = total
        self._tenth = -1
        self._open = False

    def update(self, done: int, total: int = 0, remark: str = "") -> None:
        """Shows that `done` of `total` pieces are ready; the remark follows."""
        self._total = total or self._total
        if self._total <= 0:
            return
        line = f"    {self._label} {done}/{self._total}{remark and f', {remark}'}"
        if sys.stderr.isatty():
            print(f"\r{line}\033[K", end="", file=sys.stderr, flush=True)
            self._open = True
        elif done * 10 // self._total != self._tenth:
            self._tenth = done * 10 // self._total
            print(line, file=sys.stderr, flush=True)

    def close(self) -> None:
        """Ends the line."""
        if self._open:
            print(file=sys.stderr, flush=True)
            self._open = False


class Pace:
    """How fast pieces come and when the last will, in words."""

    def __init__(self, unit: str, clock: Callable[[], float] = time.monotonic) -> None:
        self._unit = unit
        self._clock = clock
        self._first: tuple[float, int] | None = None

    def words(self, done: int, total: int) -> str:
        """After `done` of `total` pieces; empty after the first, whose time says little about the others'."""
        now = self._clock()
        if self._first is None or done <= self._first[1]:
            self._first = (now, done)
            return ""
        rate = (done - self._first[1]) / max(now - self._first[0], 1e-6)
        left = round((total - done) / rate)
        return f"{rate:.1f} {self._unit}/s, {left // 60}:{left % 60:02} min left"


def tail(log: Path, lines: int = 30) -> str:
    """The last lines of a log, indented for a message."""
    try:
        text = log.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return ""
    return "\n".join("    | " + line for line in text.splitlines()[-lines:])
