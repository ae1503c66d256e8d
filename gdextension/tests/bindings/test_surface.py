#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""gdextension/src stays on the surface, the check would notice if it did not, and the generator offers no more.

Usage: GODOT_API=extension_api.json test_surface.py (run_provider_tests.py passes the one of its build).
"""

from __future__ import annotations

import json
import os
import re
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
GDEXTENSION = HERE.parent.parent
sys.path.insert(0, str(GDEXTENSION / "bindings"))

from generator.__main__ import render
from generator.model import SurfaceError, load
from surface_check import BINDINGS, check, load_surface, violations

API = Path(os.environ.get("GODOT_API", ""))
SURFACE = BINDINGS / "surface.json"


class SourcesStayOnTheSurface(unittest.TestCase):
    def test_src(self) -> None:
        self.assertEqual(check(API, [GDEXTENSION / "src"], [GDEXTENSION / "core"]), [])

    def test_the_test_extension(self) -> None:
        self.assertEqual(check(API, [HERE / "extension"]), [])


class TheCheckNotices(unittest.TestCase):
    def found(self, code: str) -> list[str]:
        return list(violations("x.cpp", code, load_surface(API), set()))

    def test_headers(self) -> None:
        self.assertTrue(self.found("#include <godot_cpp/classes/tween.hpp>\n"))
        self.assertTrue(self.found('#include "godot_provider/interface.hpp"\n'))
        self.assertFalse(self.found("#include <godot_cpp/classes/node3d.hpp>\n"))

    def test_classes(self) -> None:
        self.assertEqual(self.found("\nTween *tween = nullptr;"), ["x.cpp:2: class Tween"])
        self.assertFalse(self.found('// Tween\n/* Tween */ f("Tween");'))

    def test_members(self) -> None:
        self.assertTrue(self.found("int x = Node::get_path_to;"))
        self.assertFalse(self.found("int x = Node::NOTIFICATION_READY + Node3D::NOTIFICATION_PROCESS;"))
        self.assertFalse(self.found("RenderingServer::get_singleton();"))

    def test_methods(self) -> None:
        self.assertTrue(self.found("node->set_physics_process(true);"))
        self.assertTrue(self.found("server->\n  y; server->camera_create();"))
        self.assertFalse(self.found("node->set_process(true);"))

    def test_macros(self) -> None:
        self.assertTrue(self.found("ERR_FAIL_EDMSG(text);"))
        self.assertTrue(self.found("GDVIRTUAL_BIND(_x);"))
        self.assertFalse(self.found("ERR_FAIL_MSG(text); return ERR_FILE_CORRUPT;"))


class TheGeneratorOffersTheSurface(unittest.TestCase):
    def test_headers_exist(self) -> None:
        generated = set(render(load(API, SURFACE)))
        for header in load_surface(API).headers - {"gdextension_interface.h"}:
            written = (BINDINGS / "include" / header).exists()
            self.assertTrue(written or f"include/{header}" in generated, header)

    def test_only_listed_methods(self) -> None:
        files = render(load(API, SURFACE))
        classes = json.loads(SURFACE.read_text(encoding="utf-8"))["classes"]
        allowed = {"get_singleton", "register_virtuals", "GODOT_PROVIDER_ENGINE_CLASS"}
        for name, wanted in classes.items():
            path = next(p for p, text in files.items() if f"class {name} : public" in text)
            body = files[path].split("class " + name + " : public")[1].split("\nnamespace internal {")[0]
            declared = set(re.findall(r"^\t(?!\t)[^{};=]*?\b(\w+)\(", body, re.MULTILINE)) - allowed
            declared = {method for method in declared if not method.startswith("_varargs_")}
            self.assertEqual(declared, set(wanted), name)

    def test_unknown_names_are_refused(self) -> None:
        for change, message in (
            ({"classes": {"NoSuchClass": []}}, "NoSuchClass"),
            ({"classes": {"Node": ["no_such_method"]}}, "no_such_method"),
            ({"builtins": {"NoSuchType": []}}, "NoSuchType"),
        ):
            surface = json.loads(SURFACE.read_text(encoding="utf-8")) | change
            with tempfile.TemporaryDirectory() as folder:
                path = Path(folder) / "surface.json"
                path.write_text(json.dumps(surface), encoding="utf-8")
                with self.assertRaisesRegex(SurfaceError, message):
                    load(API, path)


if __name__ == "__main__":
    if not API.is_file():
        sys.exit("Set GODOT_API to the extension_api.json of the engine (godot --dump-extension-api).")
    unittest.main()
