#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Finds what C++ sources use of Godot beyond bindings/surface.json.

Usage: surface_check.py --api extension_api.json SOURCE_FOLDER...

The compiler refuses most of it already, for the provider generates nothing else; this check names the place even
where a folder is built against upstream godot-cpp only, and it also covers macros and include paths.
Exit status: 0 nothing found, 1 something found.
"""

from __future__ import annotations

import argparse
import json
import re
import sys
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

BINDINGS = Path(__file__).resolve().parent.parent.parent / "bindings"
sys.path.insert(0, str(BINDINGS))

from generator.cpp_types import snake_case

# Members that every class has by GDCLASS or by the bindings themselves.
COMMON_MEMBERS = {"get_singleton", "get_class_static", "get_parent_class_static", "cast_to", "self_type"}
# Names of engine classes that mean something else in C++: godot-cpp's ClassDB registers classes.
OTHER_MEANING = {"ClassDB"}
_NOISE = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.DOTALL)
_INCLUDE = re.compile(
    r'^\s*#\s*include\s*[<"]((?:godot_cpp|godot_provider)/[^>"]+|gdextension_interface\.h)[>"]', re.MULTILINE
)
_GODOT_MACRO = re.compile(
    r"\b((?:ADD|BIND|CRASH|DEV|ERR|GD|GDE|GDREGISTER|GDVIRTUAL|GODOT|MAKE|VARIANT|WARN)_[A-Z0-9_]+|"
    r"GDCLASS|GDEXTENSION_CLASS\w*|D_METHOD|DEFVAL)\b"
)


@dataclass
class Surface:
    """What may be used, by kind."""

    headers: set[str]
    macros: set[str]
    classes: dict[str, set[str]]  # class -> its members and those of its ancestors
    methods: set[str]  # all listed methods of all classes
    unlisted_classes: set[str]
    unlisted_methods: set[str] = field(default_factory=set)


def load_surface(api_path: Path, surface_path: Path = BINDINGS / "surface.json") -> Surface:
    """Joins the surface file with the names the engine has in all."""
    api: dict[str, Any] = json.loads(api_path.read_text(encoding="utf-8"))
    surface: dict[str, Any] = json.loads(surface_path.read_text(encoding="utf-8"))
    by_name = {entry["name"]: entry for entry in api["classes"]}
    members: dict[str, set[str]] = {}
    listed_methods: set[str] = set()
    every_method: set[str] = set()
    for name, methods in surface["classes"].items():
        listed_methods |= set(methods)
        found: set[str] = set(COMMON_MEMBERS)
        ancestor: str | None = name
        while ancestor:
            entry = by_name[ancestor]
            found |= set(surface["classes"].get(ancestor, []))
            found |= {constant["name"] for constant in entry.get("constants", [])}
            for enum in entry.get("enums", []):
                found |= {enum["name"], *(value["name"] for value in enum["values"])}
            every_method |= {method["name"] for method in entry.get("methods", [])}
            ancestor = entry.get("inherits")
        members[name] = found
    for methods in surface["builtins"].values():
        listed_methods |= set(methods)
    builtin_methods = {m["name"] for entry in api["builtin_classes"] for m in entry.get("methods", [])}
    headers = {f"godot_cpp/{name}.hpp" for name in surface["headers"]}
    headers |= {f"godot_cpp/classes/{snake_case(name)}.hpp" for name in surface["classes"]}
    headers |= {f"godot_cpp/variant/{snake_case(name)}.hpp" for name in surface["builtins"]}
    constants = {
        value["name"]
        for enum in api["global_enums"]
        if enum["name"] in surface["global_enums"]
        for value in enum["values"]
    }
    return Surface(
        headers=headers | {"gdextension_interface.h"},
        macros=set(surface["macros"]) | constants,  # Error's values look like the error macros
        classes=members,
        methods=listed_methods,
        unlisted_classes=set(by_name) - set(members) - OTHER_MEANING,
        # Names that built-in types share with the C++ library tell nothing here: the compiler judges those.
        unlisted_methods=every_method - listed_methods - builtin_methods,
    )


def strip_noise(text: str) -> str:
    """The code without comments and literals, line numbers kept."""
    return _NOISE.sub(lambda match: "\n" * match.group().count("\n") or " ", text)


def violations(name: str, text: str, surface: Surface, own: set[str]) -> Iterator[str]:
    """What one file uses beyond the surface; `own`: classes and functions that the project declares itself."""
    for match in _INCLUDE.finditer(text):
        if match.group(1) not in surface.headers:
            yield f"{name}: header {match.group(1)}"
    for number, line in enumerate(strip_noise(text).splitlines(), 1):
        place = f"{name}:{number}"
        if line.lstrip().startswith("#"):
            continue
        for match in _GODOT_MACRO.finditer(line):
            if match.group(1) not in surface.macros | own:
                yield f"{place}: macro {match.group(1)}"
        for word in re.findall(r"(?<![.>\w])([A-Z]\w*)\b(?!\s*\()", line):
            if word in surface.unlisted_classes and word not in own:
                yield f"{place}: class {word}"
        for scope, member in re.findall(r"\b([A-Z]\w*)::(\w+)", line):
            if scope in surface.classes and member not in surface.classes[scope]:
                yield f"{place}: {scope}::{member}"
        for method in re.findall(r"(?:->|\.)\s*(\w+)\s*\(", line):
            if method in surface.unlisted_methods and method not in own:
                yield f"{place}: method {method}()"


def declared_names(folders: list[Path]) -> set[str]:
    """Classes, functions and macros that the folders declare."""
    names: set[str] = set()
    for path in source_files(folders):
        text = strip_noise(path.read_text(encoding="utf-8"))
        names |= set(re.findall(r"\b(?:class|struct|enum(?: class)?|using)\s+(\w+)", text))
        names |= set(re.findall(r"#\s*define\s+(\w+)", text))
        if path.suffix in (".h", ".hpp"):
            names |= set(re.findall(r"[\w>&*]\s+[&*]*(\w+)\s*\([^;{]*\)[^;{(]*[;{]", text))
    return names


def source_files(folders: list[Path]) -> list[Path]:
    return sorted(
        path for folder in folders for path in folder.rglob("*") if path.suffix in (".h", ".hpp", ".cpp")
    )


def check(api_path: Path, folders: list[Path], declaring: list[Path] | None = None) -> list[str]:
    """All violations in the folders; `declaring`: further folders whose own names may be used."""
    surface = load_surface(api_path)
    own = declared_names(folders + (declaring or []))
    found: list[str] = []
    for path in source_files(folders):
        found += violations(str(path), path.read_text(encoding="utf-8"), surface, own)
    return found


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--api", type=Path, required=True, help="extension_api.json")
    parser.add_argument(
        "--declaring", type=Path, action="append", default=[], help="folder with names of our own"
    )
    parser.add_argument("folders", type=Path, nargs="+")
    given = parser.parse_args()
    found = check(given.api, given.folders, given.declaring)
    for line in found:
        print(f"{line} is not in bindings/surface.json")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
