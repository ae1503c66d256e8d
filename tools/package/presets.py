# SPDX-License-Identifier: MIT
"""The export presets of export_presets.cfg: which there are, and a copy of the file for this machine.

The committed file names no template, for that would be a path of somebody's machine.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from setup import paths
from setup.console import Failure

FILE = paths.ROOT / "export_presets.cfg"


@dataclass(frozen=True)
class Preset:
    """A preset: its number in the file, its name, Godot's word for the platform, and where its program goes."""

    number: int
    name: str
    platform: str
    path: Path


def read(text: str) -> dict[str, Preset]:
    """The presets in the text of such a file, by name."""
    found = {}
    for number, section in re.findall(r"^\[preset\.(\d+)\]\n(.*?)(?=^\[|\Z)", text, re.MULTILINE | re.DOTALL):
        values = dict(re.findall(r'^(\w+)="(.*)"$', section, re.MULTILINE))
        found[values["name"]] = Preset(int(number), values["name"], values["platform"], Path(values["export_path"]))
    return found


def with_options(text: str, preset: Preset, options: Mapping[str, str | int]) -> str:
    """The file's text with other values for some of a preset's options."""
    head = f"[preset.{preset.number}.options]\n"
    before, found, after = text.partition(head)
    section, following, rest = after.partition("\n[")
    for key, value in options.items():
        line = f'{key}="{value}"' if isinstance(value, str) else f"{key}={value}"
        section, count = re.subn(rf"^{re.escape(key)}=.*$", lambda _, line=line: line, section, flags=re.MULTILINE)
        if not found or count != 1:
            raise Failure(f"{FILE.name} has no option {key} for {preset.name}; let Godot's export dialog write the file.")
    return before + head + section + following + rest


def option_keys(text: str, preset: Preset) -> list[str]:
    """The keys among the options of a preset."""
    section = text.partition(f"[preset.{preset.number}.options]\n")[2].partition("\n[")[0]
    return re.findall(r"^(\w+(?:/[\w-]+)+)=", section, re.MULTILINE)
