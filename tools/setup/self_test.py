# SPDX-License-Identifier: MIT
"""./run self-test: draws on this machine's graphics card and compares with the exact solution."""

from __future__ import annotations

import argparse
import json
import os
import tempfile
from pathlib import Path

from setup import display, paths, prepare, process, session
from setup.console import Failure, say, tail
from setup.godot import Godot

USAGE = "usage: ./run self-test [OUT.json] [--renderer mobile|forward_plus|gl_compatibility]"
_TIMEOUT_S = 600.0


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> None:  # type: ignore[override]
        raise Failure(f"self-test: {message}\n{USAGE}", 2)


def run(arguments: list[str]) -> int:
    """The subcommand; returns the exit status: 1 when a check has failed."""
    parser = _Parser(add_help=False)
    parser.add_argument("out", nargs="?")
    parser.add_argument("--renderer", choices=session.RENDERERS, default="mobile")
    chosen = parser.parse_args(arguments)
    godot = prepare.project()
    say(f"Checking the graphics card ({chosen.renderer})")
    with tempfile.TemporaryDirectory() as folder:
        found = check(godot, chosen.renderer, Path(folder) / "found.json")
    print("\n".join(found["report"]))
    if chosen.out:
        out = Path(chosen.out).absolute()
        out.parent.mkdir(parents=True, exist_ok=True)
        out.write_text(json.dumps(found, indent=2) + "\n", encoding="utf-8")
        print(out)
    return 0 if found["passed"] else 1


def check(godot: Godot, renderer: str, out: Path) -> dict:
    """Starts the program as its user would, with `-- --self-test`, and returns what it wrote to `out`."""
    paths.LOGS.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(prefix=f"self-test-{renderer}-", suffix=".log", dir=paths.LOGS)
    os.close(handle)
    log = Path(name)
    command = display.on_screen([
        str(godot.executable), "--path", str(paths.ROOT), "--rendering-method", renderer,
        "--audio-driver", "Dummy", "--", f"--self-test={out}",
    ])
    status = process.run_logged(command, log, timeout_s=_TIMEOUT_S)
    if status not in (0, 1) or not out.is_file():
        raise Failure(f"self-test: {tail(log)}\n(exit status {status}; all of the output is in {log})", status or 1)
    log.unlink()
    found = json.loads(out.read_text(encoding="utf-8"))
    if found["renderer"] != renderer:
        # Without Vulkan the engine goes on with OpenGL.
        found["report"].append(f"The engine could not start {renderer} here and took {found['renderer']} instead.")
    return found
