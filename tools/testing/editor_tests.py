# SPDX-License-Identifier: MIT
"""The stage that runs the real editor on a project of its own: the addon's editor side, and the class reference."""

from __future__ import annotations

import json
import re
import shutil
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator
from pathlib import Path

from setup import display, paths, process
from setup.console import Failure, tail
from testing.context import Context, sources
from testing.junit import Case

_ADDON = "addons/blackhole_sky"
_TESTS = "tests/editor"
_IN_HEADLESS = ("test_plugin_trace", "test_new_skies", "test_gizmos", "test_bakes", "test_importers")
_IN_WINDOW = ("test_viewport",)
_PROJECT = """config_version=5

[application]

config/name="Editor tests"
config/features=PackedStringArray("4.6")

[editor_plugins]

enabled=PackedStringArray("res://addons/editor_checks/plugin.cfg")

[rendering]

renderer/rendering_method="mobile"
viewport/hdr_2d=true
environment/defaults/default_clear_color=Color(0, 0, 0, 1)
"""
_COMPLAINT = re.compile(r"^\s*(SCRIPT |SHADER |USER )?(ERROR|WARNING):")
# What the tests provoke: a table of stars with a declination of 140 degrees.
_PROVOKED = "bad.csv"
_BAD_LINE = "bad.csv, line 3"


def stage(context: Context) -> list[Case]:
    """The editor opened for the first time, its tests, and (with --all) those that need a window."""
    godot = context.project
    folder = paths.BUILD / "test-results" / "editor"
    shutil.rmtree(folder, ignore_errors=True)
    project = folder / "project"
    make_project(project)
    headless = [str(godot.executable), "--headless", "--editor", "--path", str(project)]
    cases = _session("editor", headless, _IN_HEADLESS, folder, context)
    if context.all_variants:
        window = display.on_screen([
            str(godot.executable), "--editor", "--path", str(project), "--rendering-method", "mobile",
            "--audio-driver", "Dummy", "--resolution", "1280x720",
        ])
        cases += _session("editor-window", window, _IN_WINDOW, folder, context)
    return cases + _class_reference(context, folder)


def make_project(project: Path) -> None:
    """A project with the addon, as a user copies it, and the tests as a plugin."""
    for source in sources(under=_ADDON):
        _copy(source, project / source.relative_to(paths.ROOT))
    for pattern in ("bin/*", "data/*.lut"):
        for built in (paths.ROOT / _ADDON).glob(pattern):
            _copy(built, project / built.relative_to(paths.ROOT))
    tests = paths.ROOT / _TESTS
    for source in sources(under=_TESTS):
        name = source.relative_to(tests)
        _copy(source, project / (name if name.parts[0] == "scenes" else Path("addons/editor_checks") / name))
    (project / "project.godot").write_text(_PROJECT, encoding="utf-8")


def complaints(printed: str) -> Iterator[str]:
    """The errors and warnings in a log, but for the provoked one."""
    for line in printed.splitlines():
        if _COMPLAINT.match(line) and _PROVOKED not in line:
            yield line.strip()


def empty_descriptions(root: ElementTree.Element) -> Iterator[str]:
    """What the class reference of one class leaves unsaid."""
    described = {"brief_description", "description"}
    for part in root:
        if part.tag in described and not (part.text or "").strip():
            yield part.tag
    for kind, inner in (("method", True), ("signal", True), ("member", False), ("constant", False)):
        for node in root.iter(kind):
            text = node.findtext("description") if inner else node.text
            if not (text or "").strip() and "overrides" not in node.attrib:
                yield f"{kind} {node.get('name')}"


def _copy(source: Path, target: Path) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy2(source, target)


def _session(
    name: str, command: list[str], tests: tuple[str, ...], folder: Path, context: Context
) -> list[Case]:
    results = folder / f"{name}.json"
    log = paths.LOGS / f"test-{name}.log"
    env = context.environment() | {
        "BLACKHOLE_EDITOR_RESULTS": str(results), "BLACKHOLE_EDITOR_TESTS": ",".join(tests),
        "BLACKHOLE_EDITOR_PICTURES": str(folder),
        # The editor remembers what was opened: that is to be its own affair.
        "XDG_CONFIG_HOME": str(folder / "config"), "XDG_DATA_HOME": str(folder / "data"),
    }
    status = process.run_logged(command, log, env=env, timeout_s=300)
    if not results.exists():
        raise Failure(f"The editor ended without results, exit status {status}. The end of {log}:\n{tail(log)}")
    found = json.loads(results.read_text(encoding="utf-8"))
    cases = [Case(one["name"], one["group"], failure=one["failure"] or None) for one in found]
    cases += [
        Case(test, name, failure="no test of this script was run")
        for test in tests if not any(case.group == test for case in cases)
    ]
    printed = log.read_text(encoding="utf-8", errors="replace")
    wrong = list(complaints(printed))
    cases.append(Case("the editor has nothing to complain of", name, failure="\n".join(wrong) or None))
    if "test_importers" in tests:
        said = None if _BAD_LINE in printed else f"the log does not say '{_BAD_LINE}'; see {log}"
        cases.append(Case("a bad table of stars is named, with its line", name, failure=said))
    if status != 0:
        cases.append(Case("ends well", name, failure=f"exit status {status}. The end of {log}:\n{tail(log)}"))
    return cases


def _class_reference(context: Context, folder: Path) -> list[Case]:
    """The engine writes down every class anew, from the descriptions we have: nothing may be left empty."""
    reference = folder / "reference"
    shutil.copytree(paths.SOURCES / "doc_classes", reference / "doc_classes")
    log = paths.LOGS / "test-doctool.log"
    godot = context.project
    command = [
        godot.executable, "--headless", "--path", folder / "project", "--doctool", reference, "--gdextension-docs",
    ]
    status = process.run_logged(command, log, env=context.environment(), timeout_s=120)
    cases = []
    for path in sorted((reference / "doc_classes").glob("*.xml")):
        empty = list(empty_descriptions(ElementTree.parse(path).getroot()))
        cases.append(Case(path.stem, "class reference", failure="\n".join(empty) or None))
    if status != 0 or not cases:
        cases.append(Case("is written", "class reference", failure=f"exit status {status}. {tail(log)}"))
    return cases
