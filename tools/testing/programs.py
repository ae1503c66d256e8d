# SPDX-License-Identifier: MIT
"""The stages that run test programs: C++, the binding provider, Python, the commands, GUT."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

from setup import build, display, paths, session
from setup.console import Failure
from testing.context import Context, relative, result_file, run_for_junit, scripts_left_out, sources
from testing.junit import Case

_PROVIDER = paths.SOURCES / "tests" / "bindings" / "run_provider_tests.py"
_COMMANDS = Path(__file__).parent / "command_tests.py"
# So long pictures may take, in seconds.
_PLAIN_S, _LONG_S = 900, 2400


def cpp_stage(context: Context) -> list[Case]:
    """The GoogleTest suites on core."""
    _ = context.engine
    folder = build.build("test", None)
    command = ["ctest", "--test-dir", folder, "--output-junit", result_file("cpp"), "--output-on-failure", "-j2"]
    return run_for_junit(command, "cpp", 900, context.environment())


def provider_stage(context: Context) -> list[Case]:
    """The tests of the binding provider (or of upstream godot-cpp in $GODOT_CPP_DIR), under the address sanitizer."""
    godot = context.engine
    command = [
        sys.executable, _PROVIDER, "--godot", godot.executable, "--build-dir", paths.BUILD / "provider",
        "--asan", "--junit", result_file("provider"),
    ]
    if upstream := os.environ.get("GODOT_CPP_DIR"):
        command += ["--godot-cpp-dir", os.path.abspath(upstream)]
    return run_for_junit(command, "provider", 900, context.environment())


def python_stage(context: Context) -> list[Case]:
    """The unit tests of the tools."""
    _ = context.engine
    cases: list[Case] = []
    for path in sources(".py", under="tools"):
        if path.name.startswith("test_"):
            name = "python-" + relative(path.with_suffix("")).replace("/", "-")
            cases += _unittest(path, name, 120, context)
    return cases


def commands_stage(context: Context) -> list[Case]:
    """./run as a visitor uses it."""
    _ = context.project
    return _unittest(_COMMANDS, "commands", 900, context)


def gut_stage(context: Context) -> list[Case]:
    """The GUT tests that draw nothing."""
    godot = context.project
    command = [godot.executable, "--headless", "--path", paths.ROOT, "-s", "addons/gut/gut_cmdln.gd"]
    options = ["-gconfig=res://.gutconfig.json", "-gexit", f"-gjunit_xml_file={result_file('gut')}"]
    cases = run_for_junit([*command, *options], "gut", 600, _own_home("gut", context))
    return cases + scripts_left_out("gut", "tests/unit", "tests/integration")


def render_stage(context: Context, renderer: str) -> list[Case]:
    """The GUT tests that measure pictures, with one renderer."""
    if renderer not in session.RENDERERS:
        raise Failure(f"there is no renderer '{renderer}'")
    godot = context.project
    name = f"render-{renderer}"
    command = display.on_screen([
        str(godot.executable), "--path", str(paths.ROOT), "--rendering-method", renderer, "--audio-driver", "Dummy",
        "-s", "addons/gut/gut_cmdln.gd", "-gconfig=", "-gdir=res://tests/render", "-ginclude_subdirs", "-gexit",
        f"-gjunit_xml_file={result_file(name)}",
    ])
    timeout_s = _LONG_S if context.all_variants else _PLAIN_S
    return run_for_junit(command, name, timeout_s, _own_home(name, context)) + scripts_left_out(name, "tests/render")


def _own_home(name: str, context: Context) -> dict[str, str]:
    """The environment with a folder of its own for what the engine keeps of a user: others run at the same time."""
    home = paths.BUILD / "test-results" / f"home-{name}"
    home.mkdir(parents=True, exist_ok=True)
    return context.environment() | {"XDG_DATA_HOME": str(home)}


def _unittest(path: Path, name: str, timeout_s: float, context: Context) -> list[Case]:
    runner = Path(__file__).parent / "unittest_junit.py"
    # The modules that the tools use come with the system's packages, so its Python is the one to take.
    python = shutil.which("python3", path="/usr/bin") or sys.executable
    command = [python, runner, path, result_file(name)]
    return run_for_junit(command, name, timeout_s, context.environment())
