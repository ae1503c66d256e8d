# SPDX-License-Identifier: MIT
"""Whether the engine's editor knows every option of the export presets: it would pass by a misspelt one in silence."""

from __future__ import annotations

import re
import shutil
import tempfile
from pathlib import Path

from package import presets
from setup import paths, process
from setup.console import tail
from setup.godot import Godot

_PROJECT = Path(__file__).parent / "preset_keys"
# Added by the OpenXR vendors plugin, which is not part of the project (docs/exporting.md).
_OF_THE_VENDORS = re.compile(r"(?:meta_xr_features/|xr_features/enable_\w+_plugin$)")


def unknown(godot: Godot) -> str:
    """What is wrong, a sentence for each preset that is missing and each option that the editor does not know."""
    log = paths.LOGS / "preset-keys.log"
    text = presets.FILE.read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder:
        project = Path(folder) / "project"
        shutil.copytree(_PROJECT, project)
        (project / presets.FILE.name).write_text(text, encoding="utf-8")
        status = process.run_logged([godot.executable, "--headless", "--editor", "--path", project], log, timeout_s=120)
    known = told(log.read_text(encoding="utf-8", errors="replace"))
    if status != 0 or not known:
        return f"The editor told no options (exit status {status}). The end of {log}:\n{tail(log)}"
    return "\n".join(compare(text, known))


def told(printed: str) -> dict[str, set[str]]:
    """The options of each preset in what the plugin printed."""
    options: dict[str, set[str]] = {}
    of_preset: set[str] = set()
    for word, name in re.findall(r"^(preset|option) (.+)$", printed, re.MULTILINE):
        if word == "preset":
            of_preset = options.setdefault(name, set())
        else:
            of_preset.add(name)
    return options


def compare(text: str, known: dict[str, set[str]]) -> list[str]:
    """What the presets in the text have and the editor does not know, and the other way round."""
    wrong = []
    for preset in presets.read(text).values():
        if preset.name not in known:
            wrong.append(f"The editor does not know the preset {preset.name}.")
            continue
        written = presets.option_keys(text, preset)
        options = known[preset.name]
        own = {key for key in written if not _OF_THE_VENDORS.match(key)}
        wrong += [f"{preset.name}: the editor knows no option {key}." for key in sorted(own - options)]
    return wrong
