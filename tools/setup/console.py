# SPDX-License-Identifier: MIT
"""What the visitor reads: progress on stderr, so that stdout carries results only."""

from __future__ import annotations

import sys
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

    def update(self, done: int, total: int = 0) -> None:
        """Shows that `done` of `total` pieces are ready."""
        self._total = total or self._total
        if self._total <= 0:
            return
        line = f"    {self._label} {done}/{self._total}"
        if sys.stderr.isatty():
            print(f"\r{line}\033[K", end="", file=sys.stderr, flush=True)
            self._open = True
        elif done * 10 // self._total > self._tenth:
            self._tenth = done * 10 // self._total
            print(line, file=sys.stderr, flush=True)

    def close(self) -> None:
        """Ends the line."""
        if self._open:
            print(file=sys.stderr, flush=True)
            self._open = False


def tail(log: Path, lines: int = 30) -> str:
    """The last lines of a log, indented for a message."""
    try:
        text = log.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return ""
    return "\n".join("    | " + line for line in text.splitlines()[-lines:])
