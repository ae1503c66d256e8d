# SPDX-License-Identifier: MIT
"""./run export: the demo as a program, by the presets of export_presets.cfg."""

from __future__ import annotations

import argparse
import re
import shutil
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from package import debian_templates, libraries, official_templates, presets, version
from package.presets import Preset
from setup import paths, prepare, process, project_import
from setup.console import Failure, note, say, tail
from setup.godot import Godot

USAGE = "usage: ./run export [Linux|Windows|Quest] [--debug] [--out DIR]"
# Read by whoever gets the program; beside it.
_PAPERS = ("LICENSE", "THIRDPARTY.md", "addons/blackhole_sky/data/CREDITS.md")
# Not among the project's assets, and needed: what is imported, and Android's build template where it is installed.
_KEPT = (".godot", "android")
# Godot 4.6 ends with status 0 also when it could not export; its errors say why.
_ERROR = re.compile(r"^(?:SCRIPT )?ERROR: (.*?)(?=^   at: |^\S*ERROR: |\Z)", re.MULTILINE | re.DOTALL)


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> None:  # type: ignore[override]
        raise Failure(f"export: {message}\n{USAGE}", 2)


def run(arguments: list[str]) -> int:
    """The subcommand; prints the program's path."""
    known = presets.read(presets.FILE.read_text(encoding="utf-8"))
    parser = _Parser(add_help=False)
    parser.add_argument("preset", nargs="?", choices=known, default="Linux")
    parser.add_argument("--debug", action="store_true")
    parser.add_argument("--out")
    chosen = parser.parse_args(arguments)
    preset = known[chosen.preset]
    kind = "debug" if chosen.debug else "release"
    out = Path(chosen.out).absolute() if chosen.out else (paths.ROOT / preset.path).parent
    godot = prepare.project()
    if preset.platform == "Windows Desktop":
        libraries.make("windows", godot)
    print(make(godot, preset, kind, out))
    return 0


def make(godot: Godot, preset: Preset, kind: str, out: Path) -> Path:
    """Exports into folder `out`; the program. A Failure says what is missing."""
    template = official_templates.file(preset.platform, kind, godot.version)
    program = out / preset.path.name
    options = version_options(preset)
    if template.is_file():
        say(f"Exporting {preset.name} ({kind}) with the official template")
    elif preset.platform == "Linux":
        options[f"custom_template/{kind}"] = str(debian_templates.bring(godot.version).program(kind))
        say(f"Exporting {preset.name} ({kind}) with Debian's template")
        note("It will run on this machine. To hand it on, install the official templates first (docs/exporting.md).")
    else:
        raise Failure(
            f"{preset.name} needs the official export template {template.name}, and there is none in\n"
            f"    {template.parent}\nInstall it in the editor (Editor, Manage Export Templates), and start again. "
            "docs/exporting.md goes through the steps.", 3,
        )
    with machine_copy(preset, options) as project:
        export(godot, project, preset, kind, program)
    for paper in _PAPERS:
        shutil.copy2(paths.ROOT / paper, out)
    return program


def version_options(preset: Preset) -> dict[str, str | int]:
    """The options that tell a platform the program's version."""
    text = version.text()
    if preset.platform == "Windows Desktop":
        return {"application/file_version": f"{text}.0", "application/product_version": f"{text}.0"}
    if preset.platform == "Android":
        return {"version/name": text, "version/code": version.number(text)}
    return {}


@contextmanager
def machine_copy(preset: Preset, options: Mapping[str, str | int]) -> Iterator[Path]:
    """A copy of the imported project in a temporary folder, whose preset has other options."""
    with tempfile.TemporaryDirectory(prefix="blackhole-sky-export-") as folder:
        project = Path(folder) / "project"
        kept = (path for name in _KEPT for path in (paths.ROOT / name).rglob("*") if path.is_file())
        for file in [*project_import.project_files(paths.ROOT), *kept]:
            target = project / file.relative_to(paths.ROOT)
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(file, target)
        text = presets.FILE.read_text(encoding="utf-8")
        (project / presets.FILE.name).write_text(presets.with_options(text, preset, options), encoding="utf-8")
        yield project


def export(godot: Godot, project: Path, preset: Preset, kind: str, program: Path) -> None:
    """Lets the engine export a project; a Failure with what it says when it cannot."""
    program.parent.mkdir(parents=True, exist_ok=True)
    program.unlink(missing_ok=True)
    log = paths.LOGS / f"export-{preset.name.lower()}.log"
    command = [godot.executable, "--headless", "--path", project, f"--export-{kind}", preset.name, program]
    status = process.run_logged(command, log, timeout_s=600)
    errors = reasons(log.read_text(encoding="utf-8", errors="replace"))
    if status != 0 or errors or not program.is_file():
        why = "\n".join(errors) or tail(log)
        raise Failure(f"Exporting {preset.name} failed (exit status {status}):\n{why}\nAll of the output is in {log}.")


def reasons(printed: str) -> list[str]:
    """The engine's errors in what it printed, all lines of each."""
    return [error.strip() for error in _ERROR.findall(printed)]
