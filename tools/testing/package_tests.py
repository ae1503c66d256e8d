# SPDX-License-Identifier: MIT
"""The stage that proves what is handed on: the zip in a user's project, and the exported program."""

from __future__ import annotations

import os
import re
import shutil
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

from package import command, debian_templates, exports, preset_keys, presets
from package.exported import ExportedProgram, variables
from package.fresh_project import FreshProject
from package.presets import Preset
from setup import paths
from setup.console import Failure
from setup.godot import Godot
from testing.context import Context
from testing.junit import Case

_FOLDER = paths.BUILD / "test-results" / "package"
# Spaces and letters that are not ASCII, as people's folders have them.
_UNEASY = "Schwarzes Loch – Übung"
# What the engine says of a preset for which template and SDK are not installed.
_LACKS = re.compile(
    r"^(?:Cannot export project with preset|Project export for preset|No export template found at the expected path:"
    r"|/.*/export_templates/|Android build template not installed|A valid Java SDK path is required"
    r"|Invalid Android SDK path|Unable to find Android SDK)"
)


def stage(context: Context) -> list[Case]:
    """The zip with this machine's library, the Linux export, the presets; all libraries with --all."""
    godot = context.project
    shutil.rmtree(_FOLDER, ignore_errors=True)
    wanted = ["release", "debug", "windows"] if context.all_variants else ["release"]
    zip_file = command.make(_FOLDER, wanted)
    cases = _in_order("zip", [("a second one is the same", lambda: _second_zip(zip_file, wanted))])
    names = [_UNEASY, "plain"] if context.all_variants else [_UNEASY]
    with ThreadPoolExecutor(2) as pool:  # starting an editor takes one processor
        exported = pool.submit(_exported, context)
        cases += _in_order("presets", [("have the options that the editor knows", lambda: preset_keys.wrong(godot))])
        for name in names:
            project = FreshProject(godot, _FOLDER / name / "project", context.environment())
            cases += _in_order(f"project in '{name}'", _steps(project, zip_file))
        cases += exported.result()
    if context.all_variants:
        known = presets.read(presets.FILE.read_text(encoding="utf-8"))
        for name in ("Windows", "Quest"):
            cases += _in_order("presets", [(f"{name} lacks the template alone", partial(_refused, godot, known[name]))])
    return cases


def _steps(project: FreshProject, zip_file: Path) -> list[tuple[str, Callable[[], str]]]:
    """The way of a project with the addon and back."""
    return [
        ("takes the addon", lambda: _add(project, zip_file)),
        ("draws the sky", lambda: project.run(with_sky=True)),
        ("is imported without it", lambda: _remove(project)),
        ("runs without it", lambda: project.run(with_sky=False)),
    ]


def _exported(context: Context) -> list[Case]:
    """The Linux export, away from its sources. The exhibit loads the demo's scene too."""
    godot = context.project
    preset = presets.read(presets.FILE.read_text(encoding="utf-8"))["Linux"]
    made = _in_order("export", [("Linux", lambda: str(exports.make(godot, preset, "release", _FOLDER / "linux")) and "")])
    if made[0].failure:
        return made
    folder = _FOLDER / "elsewhere" / _UNEASY
    folder.parent.mkdir(parents=True)
    shutil.move(_FOLDER / "linux", folder)
    program = ExportedProgram(folder / preset.path.name, _FOLDER / "home", _environment(context))
    renderers = ["gl_compatibility", "mobile"] if context.all_variants else ["gl_compatibility"]
    ways: list[tuple[str, Callable[[], str]]] = [
        *((f"self-test, {renderer}", partial(program.self_test, renderer)) for renderer in renderers),
        ("exhibit", program.exhibit),
        *([("demo", program.demo)] if context.all_variants else []),
    ]
    for way in ways:
        made += _in_order("exported program", [way])
    return made


def _refused(godot: Godot, preset: Preset) -> str:
    """What the engine has against a preset, beside what this machine lacks for it."""
    with exports.machine_copy(preset, exports.version_options(preset)) as project:
        try:
            exports.export(godot, project, preset, "release", _FOLDER / "refused" / preset.path.name)
        except Failure as failure:
            told = str(failure).splitlines()[1:-1]
            return "\n".join(line for line in told if not _LACKS.search(line))
    return ""


def _environment(context: Context) -> dict[str, str]:
    """What the program needs to find its drivers, where its template is Debian's."""
    copy = debian_templates.of_cache(paths.cache_dir(), context.engine.version)
    return variables(copy.environment_script()) if copy else dict(os.environ)


def _in_order(group: str, steps: list[tuple[str, Callable[[], str]]]) -> list[Case]:
    """A case for each step, which says what is wrong or nothing; what follows a failure is not tried."""
    cases = []
    for name, step in steps:
        started = time.monotonic()
        try:
            wrong = step()
        except Failure as failure:
            wrong = str(failure)
        cases.append(Case(name, group, time.monotonic() - started, failure=wrong or None))
        if wrong:
            break
    return cases


def _second_zip(zip_file: Path, wanted: list[str]) -> str:
    second = command.make(_FOLDER / "second", wanted)
    return "" if second.read_bytes() == zip_file.read_bytes() else f"{second} differs from {zip_file}"


def _add(project: FreshProject, zip_file: Path) -> str:
    project.add(zip_file)
    return project.import_assets(after_change=True)


def _remove(project: FreshProject) -> str:
    project.remove()
    return project.import_assets(after_change=True)
