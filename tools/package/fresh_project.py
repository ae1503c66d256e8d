# SPDX-License-Identifier: MIT
"""A user's project: empty, then with the addon out of its zip, then without it again."""

from __future__ import annotations

import re
import shutil
import zipfile
from pathlib import Path

from package.engine_output import complaints
from setup import display, paths, process
from setup.console import tail
from setup.godot import Godot

_SOURCES = Path(__file__).parent / "fresh_project"
_SCRIPT = "sky_check.gd"
_SCENE_WITH_SKY = """[gd_scene load_steps=3 format=3]

[ext_resource type="PackedScene" path="res://main.tscn" id="1"]
[ext_resource type="Script" path="res://sky_check.gd" id="2"]

[node name="Main" instance=ExtResource("1")]

[node name="Sky" type="Node3D" parent="."]
script = ExtResource("2")
"""
_SCENE = "with_sky.tscn"
_ABORTED = 134
# Godot 4.6 aborts at the end of the first headless import with any new extension (godotengine/godot#111048), having
# imported all. And it still has one that is gone in a list of its own, which it corrects after having complained.
_FIRST_TIME = re.compile(
    rf"exit status {_ABORTED}$|ERROR: (?:Error loading GDExtension configuration file|GDExtension dynamic library not found"
    r"|Error loading extension): 'res://addons/blackhole_sky/blackhole_sky\.gdextension'\.$"
)


class FreshProject:
    """The project in `folder`, which is made. What the engine keeps of a user goes beside it."""

    def __init__(self, godot: Godot, folder: Path, environment: dict[str, str]) -> None:
        self._godot = godot
        self._folder = folder
        self._environment = {**environment, "XDG_DATA_HOME": str(folder.parent / "user")}
        folder.mkdir(parents=True)
        for name in ("project.godot", "main.tscn"):
            shutil.copy2(_SOURCES / name, folder)

    def add(self, zip_file: Path) -> None:
        """Unzips the addon as the asset library does, without the zip's root folder, and adds a sky to a scene."""
        with zipfile.ZipFile(zip_file) as archive:
            for name in archive.namelist():
                target = self._folder / name.partition("/")[2]
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_bytes(archive.read(name))
        shutil.copy2(_SOURCES / _SCRIPT, self._folder)
        (self._folder / _SCENE).write_text(_SCENE_WITH_SKY, encoding="utf-8")

    def remove(self) -> None:
        """Takes out what add() put in."""
        shutil.rmtree(self._folder / "addons")
        for path in self._folder.glob(f"{_SCRIPT}*"):
            path.unlink()
        (self._folder / _SCENE).unlink()

    def import_assets(self, after_change: bool = False) -> str:
        """Lets the engine import; what it complains of. `after_change`: the addon has just come or gone, and the engine
        meets that for the first time; what it says of that (see _FIRST_TIME) does not count, and it imports once more."""
        command: list[object] = ["--headless", "--path", self._folder, "--import"]
        if after_change:
            first = [line for line in self._run(command, "fresh-first-import").splitlines() if not _FIRST_TIME.match(line)]
            if first:
                return "\n".join(first)
        return self._run(command, "fresh-import")

    def run(self, with_sky: bool) -> str:
        """Starts the project; what the engine complains of, or what is wrong with the picture."""
        scene = [_SCENE] if with_sky else ["--quit-after", "10"]
        command = ["--path", self._folder, "--audio-driver", "Dummy", *scene]
        return self._run(command, "fresh-run", "PASS" if with_sky else "")

    def _run(self, arguments: list[object], name: str, wanted: str = "") -> str:
        log = paths.LOGS / f"{name}.log"
        command = [str(part) for part in (self._godot.executable, *arguments)]
        if "--headless" not in command:
            command = display.on_screen(command)
        status = process.run_logged(command, log, env=self._environment, timeout_s=240)
        printed = log.read_text(encoding="utf-8", errors="replace")
        wrong = complaints(printed)
        if status != 0 or wanted not in printed:
            wrong.append(f"exit status {status}")
            if status != _ABORTED:
                wrong.append(f"The end of {log}:\n{tail(log)}")
        return "\n".join(wrong)
