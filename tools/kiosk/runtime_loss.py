# SPDX-License-Identifier: MIT
"""The exhibit in a headset whose runtime dies and comes back: the program is started again until it is there."""

from __future__ import annotations

import json
import os
import time
from collections.abc import Mapping
from pathlib import Path

from kiosk.running_exhibit import RunningExhibit
from setup import kiosk
from setup.simulated_headset import SimulatedHeadset

_SETTINGS: dict[str, object] = {"mode": "headset", "fullscreen": False, "pin": "4711", "daily_restart_hour": -1}
_PATIENCE_S = 60.0


def run(engine: Path, headset: SimulatedHeadset, folder: Path, environment: Mapping[str, str] = os.environ) -> str:
    """What went wrong, in a sentence; empty when nothing did."""
    config, logs = folder / "headset.json", folder / "headset"
    config.write_text(json.dumps({**_SETTINGS, "log_folder": str(logs)}), encoding="utf-8")
    wish = kiosk.Wish(
        config=config, engine=["--rendering-method", "mobile", "--audio-driver", "Dummy", "--resolution", "320x180"],
        exhibit=["--few-stars"],
    )
    env = {**environment, **headset.environment(), "XDG_DATA_HOME": str(folder / "data")}
    with (folder / "headset.log").open("wb") as sink, RunningExhibit(engine, wish, logs, env, sink) as exhibit:
        wrong = _lose_and_find(headset, exhibit, logs / "supervisor.log")
    if not wrong and exhibit.outlived:
        wrong = "the program outlives its supervisor"
    return wrong


def _lose_and_find(headset: SimulatedHeadset, exhibit: RunningExhibit, log: Path) -> str:
    if not _waits(exhibit, 0):
        return "the exhibit did not come up in the headset"
    first = exhibit.pid()
    headset.kill()
    for words in ("the headset's runtime has gone", "the headset's runtime is not there"):
        if not _appears(log, words):
            return f"after the runtime's death supervisor.log does not say that {words}"
    headset.start()
    return "" if _waits(exhibit, first) else "the exhibit did not come back with the runtime"


def _waits(exhibit: RunningExhibit, former: int) -> bool:
    """Does another program than `former` wait for visitors in the headset, before patience ends?"""
    deadline = time.monotonic() + _PATIENCE_S
    while time.monotonic() < deadline:
        if exhibit.beat().get("ready") and exhibit.pid() != former:
            return True
        time.sleep(0.2)
    return False


def _appears(log: Path, words: str) -> bool:
    deadline = time.monotonic() + _PATIENCE_S
    while time.monotonic() < deadline:
        if words in log.read_text(encoding="utf-8"):
            return True
        time.sleep(0.2)
    return False
