# SPDX-License-Identifier: MIT
"""The exhibit in a headset whose runtime dies and comes back: the program is started again until it is there."""

from __future__ import annotations

import json
import os
import subprocess
import time
from collections.abc import Mapping
from pathlib import Path

from setup import kiosk, paths, process
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
    command = ["xvfb-run", "-a", "-s", "-screen 0 640x360x24", str(engine), "--path", str(paths.ROOT)]
    env = {**environment, **headset.environment(), "XDG_DATA_HOME": str(folder / "data")}
    with (folder / "headset.log").open("wb") as sink:
        supervisor = subprocess.Popen(
            [*command, *kiosk.engine_arguments(wish)], cwd=paths.ROOT, env=env, stdin=subprocess.DEVNULL, stdout=sink,
            stderr=subprocess.STDOUT, start_new_session=True,
        )
        try:
            return _lose_and_find(headset, logs)
        finally:
            process.end_group(supervisor)


def _lose_and_find(headset: SimulatedHeadset, logs: Path) -> str:
    if not _waits(logs, 0):
        return "the exhibit did not come up in the headset"
    first = _pid(logs)
    headset.kill()
    log = logs / "supervisor.log"
    for words in ("the headset's runtime has gone", "the headset's runtime is not there"):
        if not _appears(log, words):
            return f"after the runtime's death supervisor.log does not say that {words}"
    headset.start()
    return "" if _waits(logs, first) else "the exhibit did not come back with the runtime"


def _waits(logs: Path, former: int) -> bool:
    """Does another program than `former` wait for visitors in the headset, before patience ends?"""
    deadline = time.monotonic() + _PATIENCE_S
    while time.monotonic() < deadline:
        if _beat(logs).get("ready") and _pid(logs) != former:
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


def _pid(logs: Path) -> int:
    return int(str(_beat(logs).get("pid", 0)))


def _beat(logs: Path) -> dict[str, object]:
    try:
        beat = json.loads((logs / "heartbeat.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return beat if isinstance(beat, dict) else {}
