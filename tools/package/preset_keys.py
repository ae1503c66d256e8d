# SPDX-License-Identifier: MIT
"""Whether the export presets have the options that the engine's editor knows, all of them and no other: it passes by a
misspelt one in silence."""

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


def wrong(godot: Godot) -> str:
    """What is wrong, a sentence for each option that the editor does not know, or that is left out."""
    log = paths.LOGS / "preset-keys.log"
    text = presets.FILE.read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder:
        project = Path(folder) / "project"
        shutil.copytree(_PROJECT, project)
        file = project / presets.FILE.name
        file.write_text(without_options(text), encoding="utf-8")
        command = [godot.executable, "--headless", "--editor", "--path", project]
        status = process.run_logged(command, log, timeout_s=120)
        written = file.read_text(encoding="utf-8")
    if status != 0 or written == without_options(text):
        return f"The editor did not write the presets (exit status {status}). The end of {log}:\n{tail(log)}"
    return "\n".join(compare(text, written))


def without_options(text: str) -> str:
    """The presets with one option each, since the editor complains of a section without."""
    kept = re.sub(r"(?ms)^(\[preset\.\d+\.options\]\n).*?(?=^\[|\Z)", r'\1\ncustom_template/release=""\n\n', text)
    return kept.rstrip("\n") + "\n"


def compare(text: str, written: str) -> list[str]:
    """The differences between the options of the presets in the text and those that the editor has written."""
    wrong_ones = []
    by_editor = presets.read(written)
    for preset in presets.read(text).values():
        if preset.name not in by_editor:
            wrong_ones.append(f"The editor does not know the preset {preset.name}.")
            continue
        known = set(presets.option_keys(written, by_editor[preset.name]))
        own = {key for key in presets.option_keys(text, preset) if not _OF_THE_VENDORS.match(key)}
        wrong_ones += [f"{preset.name}: the editor knows no option {key}." for key in sorted(own - known)]
        wrong_ones += [f"{preset.name}: the option {key} is left out." for key in sorted(known - own)]
    return wrong_ones
