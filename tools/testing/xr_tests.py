# SPDX-License-Identifier: MIT
"""The stage that wears a headset: tests/xr on a real OpenXR runtime with a simulated headset."""

from __future__ import annotations

import re
import subprocess
import threading
import time
from collections.abc import Mapping
from pathlib import Path

from setup import display, monado, paths, process, xr
from setup.console import Failure, tail
from setup.simulated_headset import SimulatedHeadset
from testing.context import Context, result_file, run_for_junit, scripts_left_out
from testing.junit import Case

# Each needs a process of its own: after a runtime's death there is no headset any more.
_FOLDERS = ("tests/xr", "tests/xr/lost")
_RENDERER = "mobile"
_FOCUS, _SAME_PLACE = "xr: in focus", "xr: back at the same place"
_NONE, _DIES = "start without a runtime", "a runtime that dies and comes back under ./run xr"
_PLAIN_S, _LONG_S = 900, 3000  # a long visit has 600 frames or 10,000
_MOST_LINES = 3000  # of a process whose runtime died


def stage(context: Context) -> list[Case]:
    """GUT on the simulated headset, then a runtime that dies under ./run xr; skipped where Monado cannot be had."""
    godot = context.project
    try:
        runtime = monado.find(godot)
    except Failure as failure:
        return [Case(name, "xr", skipped=str(failure)) for name in (*_FOLDERS, _NONE, _DIES)]
    cases: list[Case] = []
    for folder in _FOLDERS:
        with SimulatedHeadset(runtime) as headset:
            cases += _gut(context, folder, context.environment() | headset.environment())
    cases.append(_without_runtime(context))
    with SimulatedHeadset(runtime) as headset:
        cases.append(_supervised(context, headset))
    return cases


def _gut(context: Context, folder: str, environment: Mapping[str, str]) -> list[Case]:
    name = folder.replace("/", "-")
    options = ["-s", "addons/gut/gut_cmdln.gd", "-gconfig=", f"-gdir=res://{folder}", "-gexit"]
    command = _command(context, [*options, f"-gjunit_xml_file={result_file(name)}"])
    timeout_s = _LONG_S if context.all_variants else _PLAIN_S
    return run_for_junit(command, name, timeout_s, environment) + scripts_left_out(name, folder, deep=False)


def _without_runtime(context: Context) -> Case:
    """Where there is no runtime the scene says so and the desktop scene opens."""
    log = paths.LOGS / "test-xr-none.log"
    environment = context.environment() | {"XR_RUNTIME_JSON": str(paths.BUILD / "no-runtime.json")}
    status = process.run_logged(
        _command(context, [xr.SCENE, "--quit-after", "60"]), log, cwd=paths.ROOT, env=environment, timeout_s=120,
    )
    printed = log.read_text(encoding="utf-8", errors="replace")
    wrong = []
    if status != 0:
        wrong.append(f"exit status {status}")
    if "The desktop scene is shown instead" not in printed:
        wrong.append("the reason was not given")
    if re.search(r"^SCRIPT ERROR", printed, re.MULTILINE):
        wrong.append("a script failed")
    return Case(_NONE, "xr", failure=f"{', '.join(wrong)}; {tail(log)}" if wrong else None)


def _supervised(context: Context, headset: SimulatedHeadset) -> Case:
    """The runtime dies under a supervised scene and comes back: within 10 s the scene is in focus again."""
    log = paths.LOGS / "test-xr-supervised.log"
    log.parent.mkdir(parents=True, exist_ok=True)
    log.write_text("", encoding="utf-8")
    environment = context.environment() | headset.environment()
    running: list[subprocess.Popen[bytes]] = []
    ended = threading.Event()

    def start(variables: dict[str, str]) -> int:
        if ended.is_set():
            return 0
        with log.open("ab") as sink:
            running.append(subprocess.Popen(
                _command(context, [xr.SCENE]), cwd=paths.ROOT, env=environment | variables,
                stdin=subprocess.DEVNULL, stdout=sink, stderr=subprocess.STDOUT, start_new_session=True,
            ))
        return running[-1].wait()

    keeper = threading.Thread(target=lambda: xr.supervise(start), daemon=True)
    keeper.start()
    try:
        wrong = _die_and_return(log, headset)
    finally:
        ended.set()
        for child in running[-1:]:
            process.end_group(child)
        keeper.join(30)
    return Case(_DIES, "xr", failure=wrong or None)


def _die_and_return(log: Path, headset: SimulatedHeadset) -> str:
    if not _appears(log, _FOCUS, 1, 60.0):
        return f"the scene did not come into focus. The end of {log}:\n{tail(log)}"
    time.sleep(2.0)  # the hole is put into the room
    headset.kill()
    if not _appears(log, "xr: out of focus", 1, 5.0):
        return "the runtime's death was not noticed within 5 s"
    time.sleep(3.0)
    headset.start()
    back = time.monotonic()
    if not _appears(log, _FOCUS, 2, 30.0):
        return f"the scene did not come into focus again. The end of {log}:\n{tail(log)}"
    took = time.monotonic() - back
    if took > 10.0:
        return f"in focus again only {took:.1f} s after the runtime was back"
    if not _appears(log, _SAME_PLACE, 1, 10.0):
        return "the visitor is not at the same place as before"
    lines = log.read_text(encoding="utf-8", errors="replace").count("\n")
    return f"the log has {lines} lines" if lines > _MOST_LINES else ""


def _appears(log: Path, text: str, times: int, seconds: float) -> bool:
    deadline = time.monotonic() + seconds
    while time.monotonic() < deadline:
        if log.read_text(encoding="utf-8", errors="replace").count(text) >= times:
            return True
        time.sleep(0.1)
    return False


def _command(context: Context, arguments: list[str]) -> list[str]:
    return display.on_screen([
        str(context.engine.executable), "--path", str(paths.ROOT), "--rendering-method", _RENDERER,
        "--audio-driver", "Dummy", "--xr-mode", "on", *arguments,
    ])
