# SPDX-License-Identifier: MIT
import unittest
from pathlib import Path

from package import libraries, preset_keys, presets, version
from package.presets import Preset
from setup import paths
from setup.console import Failure

_TEXT = """[preset.0]

name="One"
platform="Linux"
export_path="out/one/program"

[preset.0.options]

custom_template/debug=""
custom_template/release=""
binary_format/embed_pck=false

[preset.1]

name="Two"
platform="Windows Desktop"
export_path="out/two/program.exe"

[preset.1.options]

custom_template/release=""
"""


class Copy(unittest.TestCase):
    def setUp(self) -> None:
        self.one, self.two = presets.read(_TEXT).values()

    def test_read(self) -> None:
        self.assertEqual(self.one, Preset(0, "One", "Linux", Path("out/one/program")))
        self.assertEqual(self.two, Preset(1, "Two", "Windows Desktop", Path("out/two/program.exe")))

    def test_an_option_of_one_preset(self) -> None:
        changed = presets.with_options(_TEXT, self.one, {"custom_template/release": r"/a \1 b"})
        self.assertEqual(changed, _TEXT.replace('release=""', r'release="/a \1 b"', 1))
        changed = presets.with_options(_TEXT, self.two, {"custom_template/release": "/b"})
        self.assertEqual(changed, '/b"'.join(_TEXT.rsplit('"', 1)))

    def test_an_option_that_is_not_there(self) -> None:
        with self.assertRaisesRegex(Failure, "custom_template/debug for Two"):
            presets.with_options(_TEXT, self.two, {"custom_template/debug": "/b"})

    def test_option_keys(self) -> None:
        self.assertEqual(
            presets.option_keys(_TEXT, self.one),
            ["custom_template/debug", "custom_template/release", "binary_format/embed_pck"],
        )


class Keys(unittest.TestCase):
    def test_what_the_editor_tells(self) -> None:
        told = preset_keys.told("Godot\npreset One\noption a/b\noption c\npreset Two\noption d\n")
        self.assertEqual(told, {"One": {"a/b", "c"}, "Two": {"d"}})

    def test_misspelt_and_missing(self) -> None:
        known = {"One": {"custom_template/debug", "custom_template/release", "binary_format/embed"}}
        wrong = preset_keys.compare(_TEXT, known)
        self.assertEqual(len(wrong), 2)
        self.assertRegex(wrong[0], "One.*binary_format/embed_pck")
        self.assertRegex(wrong[1], "preset Two")


class Committed(unittest.TestCase):
    """The project's own file."""

    def setUp(self) -> None:
        self.text = presets.FILE.read_text(encoding="utf-8")

    def test_the_presets(self) -> None:
        found = presets.read(self.text)
        self.assertEqual(
            {name: preset.platform for name, preset in found.items()},
            {"Linux": "Linux", "Windows": "Windows Desktop", "Quest": "Android"},
        )

    def test_no_path_of_a_machine(self) -> None:
        for line in self.text.splitlines():
            key, _, value = line.partition("=")
            if key.startswith("custom_template/") or key.startswith("keystore/"):
                self.assertEqual(value, '""', key)
            self.assertFalse(value.strip('"').startswith(("/", "~")) and "/" in value[2:], line)

    def test_the_project_has_the_addons_version(self) -> None:
        project = (paths.ROOT / "project.godot").read_text(encoding="utf-8")
        self.assertIn(f'\nconfig/version="{version.text()}"\n', project)

    def test_the_description_names_the_libraries(self) -> None:
        description = (paths.ROOT / "addons/blackhole_sky/blackhole_sky.gdextension").read_text(encoding="utf-8")
        for machine in ("x86_64", "aarch64"):
            known = libraries.known(machine)
            for word in ("release", "windows"):
                self.assertIn(f'\n{known[word].features} = "bin/{known[word].file}"\n', description)


if __name__ == "__main__":
    unittest.main()
