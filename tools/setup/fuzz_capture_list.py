# SPDX-License-Identifier: MIT
"""Tries what ./run capture itself reads, lists of shots and shots, with broken files:

    python3 tools/setup/fuzz_capture_list.py --folder=DIR [--seconds=N] [--seed=N] [--input=FILE]

A list is taken or refused by a Failure that names it; anything else is a finding, and is kept in the folder.
"""

from __future__ import annotations

import copy
import json
import random
import re
import sys
import time
import traceback
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from setup import capture, paths  # noqa: E402
from setup.console import Failure  # noqa: E402

_SLOW_S = 4.0
_MOST_FINDINGS = 8
_SCALARS: list[object] = [None, True, 0, -1, 0.5, 1e308, float("nan"), "", "x", "a\0b", "/", "..", [], {}, "\udc80"]
_TEXTS = (b"[", b"]", b"{", b"}", b'"', b",", b":", b"\0", b"\xff", b"NaN", b"1e999", b"-", b"9" * 5000, b"[" * 200000)


def seeds() -> list[bytes]:
    """Lists to begin with."""
    gallery = (paths.ROOT / "docs" / "gallery" / "gallery.json").read_bytes()
    shots = json.loads((paths.ROOT / "tests" / "data" / "shots" / "accepted.json").read_text(encoding="utf-8"))
    inline = [{"shot": shot, "out": f"{number}.png"} for number, shot in enumerate(shots[:8])]
    movie = [{"shot": {"path": {"fps": 24, "duration_s": 1}}, "out": "x.mp4"}, {"shot": "a.json", "out": "b/"}]
    return [gallery, json.dumps(inline).encode(), json.dumps(movie).encode()]


def attempt(path: Path) -> str:
    """Lets ./run capture read the list as far as it does before anything is drawn; what it says."""
    try:
        jobs, _ = capture.read_jobs(["--batch", str(path)])
        for job in jobs:
            capture.renderer_of(job)
            capture.is_for_headset(job)
        return "accepted"
    except Failure as failure:
        assert str(failure).startswith("capture: "), f"a refusal says who speaks: {failure}"
        return re.sub(r"'[^']*'|/\S+|\d+", "#", str(failure))[:120]


class Mutator:
    """Changes lists, value by value and byte by byte."""

    def __init__(self, seed: int) -> None:
        self._random = random.Random(seed)

    def changed(self, given: bytes) -> bytes:
        """A file a little different from the given one."""
        if self._random.random() < 0.6:
            try:
                data = json.loads(given)
            except (ValueError, RecursionError):
                data = None
            if data:
                return json.dumps(self._other(copy.deepcopy(data))).encode(errors="replace")
        for _ in range(self._random.randint(1, 4)):
            given = self._spliced(given)
        return given[:400000]

    def _other(self, data: object) -> object:
        holders = [data] if isinstance(data, (list, dict)) else []
        for holder in holders:  # grows while it is walked through
            values = holder.values() if isinstance(holder, dict) else holder
            holders += [value for value in values if isinstance(value, (list, dict))]
            if len(holders) > 300:
                break
        if not holders or self._random.random() < 0.03:
            return self._random.choice(_SCALARS)
        holder = self._random.choice(holders)
        keys = list(holder) if isinstance(holder, dict) else list(range(len(holder)))
        if not keys:
            return data
        key, value = self._random.choice(keys), self._random.choice(_SCALARS)
        roll = self._random.random()
        if roll < 0.2:
            del holder[key]
        elif roll < 0.4 and isinstance(holder, dict):
            holder[f"{key}s"] = value
        else:
            holder[key] = [holder[key]] if roll < 0.5 else value
        return data

    def _spliced(self, given: bytes) -> bytes:
        at = self._random.randrange(len(given) + 1)
        end = min(len(given), at + self._random.randint(0, 12))
        roll = self._random.random()
        if roll < 0.1:
            return given[:at]
        fresh = self._random.choice(_TEXTS) if roll < 0.6 else bytes([self._random.randrange(256)])
        return given[:at] + fresh + given[end:]


class Run:
    """One run: what was tried and what came out."""

    def __init__(self, folder: Path, seed: int) -> None:
        self.folder, self.seed = folder, seed
        self.tries = self.findings = 0
        self.kinds: dict[str, int] = {}
        folder.mkdir(parents=True, exist_ok=True)

    def attempt(self, given: bytes) -> bool:
        """Tries one file; true where the answer is of a new kind."""
        self.tries += 1
        path = self.folder / "list.json"
        path.write_bytes(given)
        begun = time.process_time()  # a busy machine is nobody's fault
        try:
            kind = attempt(path)
            assert time.process_time() - begun < _SLOW_S, "an answer within seconds"
        except Exception as error:  # whatever it is: it is the finding
            self.findings += 1
            kept = self.folder / f"finding_{self.seed}_{self.findings}"
            kept.write_bytes(given)
            kind = f"{type(error).__name__} at {traceback.extract_tb(error.__traceback__)[-1].lineno}"
            print(f"fuzz: finding (seed {self.seed}, try {self.tries}): {kind}: {str(error)[:200]}\nkept as {kept}")
        self.kinds[kind] = self.kinds.get(kind, 0) + 1
        return self.kinds[kind] == 1

    def told(self) -> str:
        """The line that says how it went."""
        return (
            f"fuzz capture_list: {self.tries} executions, {len(self.kinds)} kinds of answer, "
            f"{self.kinds.get('accepted', 0)} accepted, {self.findings} findings"
        )


def main(arguments: list[str]) -> int:
    """Runs until the time is over; 1 when something was found."""
    options = dict(argument.removeprefix("--").split("=", 1) for argument in arguments)
    seed = int(options.get("seed", "1"))
    run, mutator = Run(Path(options["folder"]), seed), Mutator(seed)
    if "input" in options:
        run.attempt(Path(options["input"]).read_bytes())
        return 1 if run.findings else 0
    corpus = seeds()
    for given in corpus:
        run.attempt(given)
    end = time.monotonic() + float(options.get("seconds", "10"))
    while time.monotonic() < end and run.findings < _MOST_FINDINGS:
        given = mutator.changed(mutator._random.choice(corpus))
        if run.attempt(given) and len(given) < 20000:
            corpus.append(given)
    print(run.told())
    return 1 if run.findings else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
