# SPDX-License-Identifier: MIT
"""The stage under the sanitizers: GoogleTest on core, what works on several threads, the extension in a headless engine."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

from setup import build, paths, process
from setup.console import Failure, tail
from setup.godot import Godot
from testing.context import Context, result_file, run_for_junit
from testing.junit import Case

_BINDINGS = paths.SOURCES / "tests" / "bindings"
_PROJECT = paths.SOURCES / "tests" / "sanitized" / "project"
_LIBRARY = "libblackhole_sky.linux.{}.so"
_END = "EXERCISE COMPLETE"
_RUN_S = 900.0


def stage(context: Context) -> list[Case]:
    """One case for each test of the suites, and one for the extension."""
    godot = context.engine
    return [*_threads(context), *_suites(context, godot), _extension(context, godot)]


def _threads(context: Context) -> list[Case]:
    """test_threads under the thread sanitizer."""
    folder = build.build("tsan", None, "test_threads")
    result = result_file("tsan")
    command = [folder / "tests" / "test_threads", f"--gtest_output=xml:{result}"]
    environment = context.environment() | {"TSAN_OPTIONS": "halt_on_error=1:exitcode=66"}
    return run_for_junit(command, "tsan", _RUN_S, environment)


def _suites(context: Context, godot: Godot) -> list[Case]:
    """All of GoogleTest under the address and undefined-behaviour sanitizers."""
    folder = build.build("asan", godot)
    command = ["ctest", "--test-dir", folder, "--output-junit", result_file("asan"), "--output-on-failure", "-j2"]
    return run_for_junit(command, "asan", 3 * _RUN_S, context.environment())


def _extension(context: Context, godot: Godot) -> Case:
    """exercise.gd with the sanitized extension: it comes to its end, and the sanitizers say nothing."""
    sys.path.insert(0, str(_BINDINGS))
    import run_provider_tests as provider  # noqa: PLC0415

    folder = build.build("asan", godot)
    work = paths.BUILD / "sanitized"
    library = folder / "src" / _LIBRARY.format(os.uname().machine)
    if not library.exists():
        raise Failure(f"the build has made no {library}")
    project = _project(work, library)
    environment = context.environment() | provider.sanitizer_environment(work, find_leaks=True)
    environment |= {"XDG_DATA_HOME": str(work / "user"), "XDG_CONFIG_HOME": str(work / "config")}
    log = paths.LOGS / "test-sanitized.log"
    command = [godot.executable, "--headless", "--audio-driver", "Dummy", "--path", project]
    status = process.run_logged([*command, "-s", "res://exercise.gd"], log, env=environment, timeout_s=_RUN_S)
    printed = log.read_text(encoding="utf-8", errors="replace")
    report = provider.sanitizer_report(work)
    fine = status == 0 and _END in printed and "SCRIPT ERROR" not in printed and not report
    return Case("extension in a headless scene", "sanitized", failure=None if fine else f"{report}\n{tail(log, 60)}")


def _project(work: Path, library: Path) -> Path:
    """A fresh project with the addon, but for what only the editor needs, and the sanitized library."""
    project = work / "project"
    shutil.rmtree(project, ignore_errors=True)
    shutil.copytree(_PROJECT, project)
    addon = project / "addons" / "blackhole_sky"
    skipped = shutil.ignore_patterns("bin", "*.import", "*.gd", "*.uid")
    shutil.copytree(paths.ROOT / "addons" / "blackhole_sky", addon, ignore=skipped)
    file = addon / "blackhole_sky.gdextension"
    lines = file.read_text(encoding="utf-8").split("[libraries]")[0]
    file.write_text(f'{lines}[libraries]\n\nlinux = "{library}"\n', encoding="utf-8")
    (project / ".godot").mkdir()
    listed = "res://addons/blackhole_sky/blackhole_sky.gdextension\n"
    (project / ".godot" / "extension_list.cfg").write_text(listed, encoding="utf-8")
    return project
