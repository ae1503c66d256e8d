# SPDX-License-Identifier: MIT
"""The stage that lets the engine read every script, scene and shader: no error and no warning is accepted."""

from __future__ import annotations

import re
from pathlib import Path

from setup import paths, process, project_import
from setup.console import Failure, tail
from testing.context import Context, relative, sources
from testing.junit import Case

_LOADER = Path(__file__).parent / "load_scripts.gd"


def scripts_stage(context: Context) -> list[Case]:
    """One case per file, from one start of the engine."""
    godot = context.project
    own = set(sources(".gd", ".tscn", ".tres", ".gdshader"))
    files = ["res://" + relative(path) for path in project_import.project_files(paths.ROOT) if path in own]
    listed = paths.BUILD / "test-results" / "scripts.txt"
    listed.parent.mkdir(parents=True, exist_ok=True)
    listed.write_text("\n".join(files), encoding="utf-8")
    log = paths.LOGS / "test-scripts.log"
    # -d: the local debugger, which alone prints script warnings.
    command = [godot.executable, "--headless", "-d", "--path", paths.ROOT, "-s", _LOADER, "--", listed]
    if process.run_logged(command, log, timeout_s=300) != 0:
        raise Failure(f"Godot did not end well. The end of {log}:\n{tail(log)}")
    return cases(files, log.read_text(encoding="utf-8", errors="replace"))


def cases(files: list[str], printed: str) -> list[Case]:
    """What the engine said about each file; a complaint belongs to the file it names, else to the one being loaded."""
    complaints: dict[str, list[str]] = {name: [] for name in files}
    ended = {}
    waiting: list[str] = []
    lines = printed.splitlines()
    for number, line in enumerate(lines):
        loaded = re.match(r"loaded (res://\S+) (.*)", line)
        if loaded:
            complaints.setdefault(loaded.group(1), []).extend(waiting)
            ended[loaded.group(1)] = loaded.group(2)
            waiting = []
        elif re.search(r"(^|> )(SCRIPT |SHADER |USER )?(ERROR|WARNING):", line):
            place = lines[number + 1].strip() if number + 1 < len(lines) else ""
            named = re.search(r"\((res://[^:)]+):\d+\)", place)
            about = complaints.get(named.group(1), waiting) if named else waiting
            about.append(f"{line.removeprefix('debug> ')} {place}")
    if waiting and files:
        complaints[files[-1]].extend(waiting)  # said at the very end
    for name in files:
        if ended.get(name) != "well":
            complaints[name].append("was not loaded")
    return [Case(name, "scripts", failure="\n".join(dict.fromkeys(complaints[name])) or None) for name in files]
