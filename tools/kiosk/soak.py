#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""An exhibit with visitors that do not exist, and everything that can befall it: killed, hung, its settings damaged, its
disk full.

    tools/kiosk/soak.py SECONDS [SEED]
"""

from __future__ import annotations

import json
import os
import random
import signal
import sys
import tempfile
import time
from collections.abc import Callable, Mapping
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from kiosk import soak_report  # noqa: E402
from kiosk.running_exhibit import RunningExhibit, megabytes  # noqa: E402
from setup import kiosk, prepare  # noqa: E402

_SETTINGS: dict[str, object] = {
    "mode": "screen", "languages": ["de", "en"], "health_notice": "always", "idle_seconds": 30, "visit_minutes": 1.2,
    "soft_end_seconds": 20, "fullscreen": False, "pin": "4711", "daily_restart_hour": -1, "hang_seconds": 10,
    "well_seconds": 20, "start_seconds": 60, "log_megabytes": 0.2, "log_count": 20,
}
_TIME_SCALE = 16
_USER_DATA = Path("godot") / "app_userdata" / "Black Hole Sky"
_COMES_BACK_S = 100.0  # the supervisor waits up to a minute
# After so long a program has its memory: drivers make shaders ready when something is shown for the first time.
_WARM_S = 300.0
_MOST_USUAL_GROWTH, _MOST_GROWTH = 0.5, 1.0  # megabytes a minute: in most minutes, and over all of them
_LONG_S = 300.0


class Soak:
    """One run. `wrong` says in sentences what was not as it should be."""

    def __init__(self, engine: Path, seconds: float, seed: int = 1, environment: Mapping[str, str] = os.environ) -> None:
        self.wrong: list[str] = []
        self.told: list[str] = []
        self._engine = engine
        self._seconds = seconds
        self._random = random.Random(seed)
        self._environment = environment
        self._ended = 0
        self._nodes: list[int] = []  # while visitors are called
        self._samples: dict[int, list[tuple[float, float]]] = {}

    def run(self, folder: Path) -> None:
        """Starts the exhibit in this folder, lets everything happen, and judges."""
        data = folder / "data"
        self._own = data / _USER_DATA
        self._logs = self._own / "kiosk"
        self._config = folder / "kiosk.json"
        self._logs.mkdir(parents=True)
        self._config.write_text(json.dumps(_SETTINGS), encoding="utf-8")
        env = {**self._environment, "XDG_DATA_HOME": str(data)}
        with (folder / "output.log").open("wb") as sink:
            self._exhibit = RunningExhibit(self._engine, self._wish(), self._logs, env, sink)
            with self._exhibit:
                self._live()
        if self._exhibit.outlived:
            self.wrong.append("the program outlives its supervisor")
        rows = [f"{pid},{at:.1f},{memory:.1f}" for pid, samples in self._samples.items() for at, memory in samples]
        (folder / "memory.csv").write_text("\n".join(["process,seconds,megabytes", *rows]) + "\n", encoding="utf-8")
        self._judge(folder / "output.log")

    def _wish(self) -> kiosk.Wish:
        return kiosk.Wish(
            config=self._config,
            engine=["--rendering-method", "gl_compatibility", "--audio-driver", "Dummy", "--resolution", "320x180",
                    "--max-fps", "30"],
            exhibit=["--few-stars", f"--time-scale={_TIME_SCALE}", f"--simulated-visitors={self._random.randrange(1000)}"],
        )

    def _live(self) -> None:
        ends = time.monotonic() + self._seconds
        if not self._wait_for_life(0):
            return
        faults: list[Callable[[], None]] = [self._kill, self._hang, self._fill_disk, self._damage_settings]
        # Equal parts of the time, a fault in each but the last; of a long one the second half shows whether memory is flat.
        calm = ends - 0.5 * self._seconds if self._seconds >= _LONG_S else ends - 8.0
        every = 45.0 if self._seconds >= _LONG_S else max(self._seconds / (len(faults) + 3), 6.0)
        turn = 0
        while time.monotonic() < ends and self._exhibit.status() is None and not self.wrong:
            self._watch(min(every, max(ends - time.monotonic(), 0.1)))
            if time.monotonic() < calm:
                faults[turn % len(faults)]()
                turn += 1
        if self._exhibit.status() is not None:
            self.wrong.append(f"the supervisor ended with status {self._exhibit.status()}")
        # A visit that is on shall end by itself, not with the program.
        deadline = time.monotonic() + 20.0
        while time.monotonic() < deadline and self._exhibit.beat().get("step") != "attract":
            time.sleep(0.05)
        self._check_health()

    def _watch(self, seconds: float) -> None:
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            beat = self._exhibit.beat()
            pid = int(str(beat.get("pid", 0)))
            if beat.get("step") == "attract" and beat.get("ready"):
                self._nodes.append(int(str(beat["nodes"])))
            memory = megabytes(pid)
            if memory > 0.0:
                self._samples.setdefault(pid, []).append((time.monotonic(), memory))
            time.sleep(0.5)

    def _kill(self) -> None:
        self.told.append("killed")
        self._end_program(signal.SIGKILL)

    def _hang(self) -> None:
        self.told.append("hung")
        self._end_program(signal.SIGSTOP)

    def _damage_settings(self) -> None:
        self.told.append("settings damaged")
        whole = self._config.read_bytes()
        self._config.write_bytes(whole[: len(whole) // 2])
        (self._own / "settings.json").write_bytes(b"\x00{\xff" + self._random.randbytes(40))
        self._end_program(signal.SIGKILL)
        self._config.write_bytes(whole)
        self._end_program(signal.SIGKILL)

    def _fill_disk(self) -> None:
        """Logs lead to a full disk for some visits; then there is room again."""
        self.told.append("disk full")
        names = ("visits.csv", "kiosk.log")
        for name in names:
            log = self._logs / name
            if log.exists():
                log.rename(log.with_suffix(".kept"))
            log.symlink_to("/dev/full")
        number = self._exhibit.beat().get("visit", 0)
        fault = ""
        deadline = time.monotonic() + 40.0
        while time.monotonic() < deadline and (self._exhibit.beat().get("visit", 0) < number + 2 or not fault):
            fault = fault or self._exhibit.beat().get("log_fault", "")
            time.sleep(0.2)
        if self._exhibit.beat().get("visit", 0) < number + 2:
            self.wrong.append("with a full disk no visitors come any more")
        if "cannot be written" not in fault:
            self.wrong.append("nothing was said of a full disk")
        for name in names:
            log = self._logs / name
            log.unlink()
            if log.with_suffix(".kept").exists():
                log.with_suffix(".kept").rename(log)
        deadline = time.monotonic() + 40.0
        while time.monotonic() < deadline and self._exhibit.beat().get("log_fault", ""):
            time.sleep(0.2)
        if self._exhibit.beat().get("log_fault", ""):
            self.wrong.append("the log does not go on once there is room again")

    def _end_program(self, how: signal.Signals) -> None:
        if self.wrong:
            return
        pid = self._exhibit.pid()
        try:
            os.kill(pid, how)
        except ProcessLookupError:
            self.wrong.append("the program ended by itself")
            return
        self._ended += 1
        self._wait_for_life(pid)

    def _wait_for_life(self, former: int) -> bool:
        deadline = time.monotonic() + _COMES_BACK_S
        while time.monotonic() < deadline:
            if self._exhibit.pid() not in (0, former) and megabytes(self._exhibit.pid()) > 0.0:
                return True
            time.sleep(0.1)
        self.wrong.append(f"the program did not come back within {_COMES_BACK_S:.0f} s")
        return False

    def _check_health(self) -> None:
        time.sleep(6.0)  # it is written every five seconds
        try:
            health = json.loads((self._logs / "health.json").read_text(encoding="utf-8"))
        except (OSError, ValueError) as error:
            self.wrong.append(f"health.json: {error}")
            return
        if health["state"] != "running":
            self.wrong.append(f"health.json says {health['state']}: {health['last_event']}")
        if health["restarts"] != self._ended:
            self.wrong.append(f"health.json knows of {health['restarts']} restarts; there were {self._ended}")

    def _judge(self, output: Path) -> None:
        visits = soak_report.read_visits(self._logs / "visits.csv")
        # The one that is on when everything is ended has no line.
        least = round(self._seconds / 9.0) if self._seconds >= _LONG_S else 3
        self.wrong += soak_report.wrong_visits(visits, least, self._ended)
        self.wrong += soak_report.wrong_order(soak_report.read_lines(self._logs / "kiosk.log"))
        self.wrong += self._wrong_memory()
        printed = output.read_text(encoding="utf-8", errors="replace")
        self.wrong += [line for line in printed.splitlines() if line.startswith("SCRIPT ERROR")][:3]
        ends = {end: sum(visit.end == end for visit in visits) for end in sorted({visit.end for visit in visits})}
        self.told.append(f"{len(visits)} visits, {self._ended} times ended; {ends}")

    def _wrong_memory(self) -> list[str]:
        wrong = []
        for pid, samples in self._samples.items():
            warm = [sample for sample in samples if sample[0] - samples[0][0] >= _WARM_S]
            if not warm:
                continue
            minutes = (warm[-1][0] - warm[0][0]) / 60.0
            growth, usual = soak_report.slope(warm), soak_report.usual_growth(warm)
            self.told.append(f"{warm[-1][1]:.0f} MB, {growth:+.1f} MB a minute over {minutes:.1f} min, {usual:+.2f} in most")
            if minutes > 5.0 and (growth > _MOST_GROWTH or usual > _MOST_USUAL_GROWTH):
                wrong.append(f"memory grows by {growth:.1f} MB a minute, {usual:.2f} in most")
        if self._nodes and max(self._nodes) > self._nodes[0]:
            wrong.append(f"nodes are left over: {self._nodes[0]} before the first visit, {max(self._nodes)} later")
        return wrong


def main(arguments: list[str]) -> int:
    """The script by itself."""
    if len(arguments) not in (1, 2):
        print(__doc__, file=sys.stderr)
        return 2
    folder = Path(tempfile.mkdtemp(prefix="soak-"))
    soak = Soak(prepare.project().executable, float(arguments[0]), int(arguments[1]) if arguments[1:] else 1)
    soak.run(folder)
    print("\n".join([*soak.told, *(f"WRONG: {sentence}" for sentence in soak.wrong), f"all of it lies in {folder}"]))
    return 1 if soak.wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
