# SPDX-License-Identifier: MIT
import unittest
from pathlib import Path

from package import exports, libraries, preset_keys, presets, version
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
        changed = presets.with_options(_TEXT, self.one, {"binary_format/embed_pck": 7})
        self.assertEqual(changed, _TEXT.replace("embed_pck=false", "embed_pck=7"))
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
    def test_misspelt_left_out_and_missing(self) -> None:
        self.assertEqual(preset_keys.compare(_TEXT, _TEXT), [])
        wrong = preset_keys.compare(_TEXT.replace("embed_pck", "embed_pkc"), _TEXT)
        self.assertEqual(len(wrong), 2)
        self.assertRegex(wrong[0], "One.*knows no option binary_format/embed_pkc")
        self.assertRegex(wrong[1], "One.*binary_format/embed_pck is left out")
        wrong = preset_keys.compare(_TEXT, _TEXT[: _TEXT.index("[preset.1]")])
        self.assertEqual(wrong, ["The editor does not know the preset Two."])

    def test_the_vendors_plugin_is_not_asked(self) -> None:
        text = _TEXT + "xr_features/enable_meta_plugin=true\nmeta_xr_features/passthrough=1\n"
        self.assertEqual(preset_keys.compare(text, _TEXT), [])

    def test_without_options(self) -> None:
        bare = preset_keys.without_options(_TEXT)
        self.assertEqual(presets.read(bare), presets.read(_TEXT))
        for preset in presets.read(bare).values():
            self.assertEqual(presets.option_keys(bare, preset), ["custom_template/release"])


class Versions(unittest.TestCase):
    def test_androids_number_grows(self) -> None:
        self.assertEqual(version.number("1.2.3"), 10203)
        self.assertLess(version.number("0.9.9"), version.number("0.10.0"))

    def test_every_preset_takes_the_version(self) -> None:
        text = presets.FILE.read_text(encoding="utf-8")
        for preset in presets.read(text).values():
            changed = presets.with_options(text, preset, exports.version_options(preset))
            self.assertEqual(changed.count(version.text()), {"Linux": 0, "Windows": 2, "Quest": 1}[preset.name])


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

    def test_the_description_names_the_libraries(self) -> None:
        description = (paths.ROOT / "addons/blackhole_sky/blackhole_sky.gdextension").read_text(encoding="utf-8")
        for machine in ("x86_64", "aarch64"):
            known = libraries.known(machine)
            for word in ("release", "windows"):
                self.assertIn(f'\n{known[word].features} = "bin/{known[word].file}"\n', description)


if __name__ == "__main__":
    unittest.main()
