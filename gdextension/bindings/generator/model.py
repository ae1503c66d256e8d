# SPDX-License-Identifier: MIT
"""The engine's API dump and the surface file, joined into what is to be generated."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

# Types that C++ writes itself: plain data whose layout is the engine's.
HAND_WRITTEN_VALUES = (
    "Vector2",
    "Vector2i",
    "Rect2",
    "Vector3",
    "Vector3i",
    "Vector4",
    "Quaternion",
    "AABB",
    "Basis",
    "Transform3D",
    "Projection",
    "Color",
)
SCALARS = ("bool", "int", "float")


class SurfaceError(Exception):
    """The surface file asks for something that the engine does not have or that is not supported."""


@dataclass(frozen=True)
class Argument:
    """One parameter; `default` is the engine's text of its default value, or None."""

    name: str
    type: str
    meta: str | None
    default: str | None


@dataclass(frozen=True)
class Method:
    """One method of a class or built-in type, or a utility function."""

    name: str
    hash: int
    arguments: tuple[Argument, ...]
    return_type: str | None
    return_meta: str | None
    is_const: bool
    is_static: bool
    is_vararg: bool
    is_virtual: bool


@dataclass(frozen=True)
class Enumeration:
    """An enumeration with its values in order."""

    name: str
    is_bitfield: bool
    values: tuple[tuple[str, int], ...]


@dataclass
class EngineClass:
    """A class to generate; `methods` holds only those on the surface."""

    name: str
    parent: str | None
    is_refcounted: bool
    is_singleton: bool
    constants: tuple[tuple[str, int], ...]
    enums: tuple[Enumeration, ...]
    methods: list[Method] = field(default_factory=list)


@dataclass(frozen=True)
class BuiltinType:
    """A built-in type to generate."""

    name: str
    size: int
    methods: tuple[Method, ...]

    @property
    def is_packed(self) -> bool:
        return self.name.startswith("Packed")

    @property
    def is_hand_written(self) -> bool:
        return self.name in HAND_WRITTEN_VALUES


@dataclass
class Model:
    """All that the emitters need."""

    classes: dict[str, EngineClass]
    builtins: dict[str, BuiltinType]
    global_enums: list[Enumeration]
    utility_functions: list[Method]
    variant_size: int
    internal_hashes: dict[str, int]


def _method(data: dict[str, Any]) -> Method:
    returned = data.get("return_value") or {}
    return Method(
        name=data["name"],
        hash=data.get("hash", 0),
        arguments=tuple(
            Argument(a["name"], a["type"], a.get("meta"), a.get("default_value"))
            for a in data.get("arguments", [])
        ),
        return_type=returned.get("type", data.get("return_type")),
        return_meta=returned.get("meta"),
        is_const=data.get("is_const", False),
        is_static=data.get("is_static", False),
        is_vararg=data.get("is_vararg", False),
        is_virtual=data.get("is_virtual", False),
    )


def _enumeration(data: dict[str, Any]) -> Enumeration:
    values = tuple((v["name"], v["value"]) for v in data["values"])
    return Enumeration(data["name"], data.get("is_bitfield", False), values)


def _pick(owner: str, wanted: list[str], available: list[dict[str, Any]]) -> list[Method]:
    by_name = {entry["name"]: entry for entry in available}
    missing = [name for name in wanted if name not in by_name]
    if missing:
        raise SurfaceError(f"{owner} has no {', '.join(missing)} in this Godot; correct the surface file.")
    return [_method(by_name[name]) for name in wanted]


def referenced_class(type_name: str) -> str | None:
    """The engine class that a type text mentions, if any ("enum::Image.Format" -> "Image")."""
    for prefix in ("enum::", "bitfield::"):
        if type_name.startswith(prefix):
            name = type_name[len(prefix) :]
            return name.split(".")[0] if "." in name else None
    if type_name.startswith("typedarray::"):
        return type_name[len("typedarray::") :]
    return type_name


def _types_of(method: Method) -> list[str]:
    types = [argument.type for argument in method.arguments]
    return types + [method.return_type] if method.return_type else types


class _ClassPicker:
    """Collects the listed classes, then the ancestors and argument classes that they need."""

    def __init__(self, api: dict[str, Any], surface: dict[str, list[str]]) -> None:
        self._available = {entry["name"]: entry for entry in api["classes"]}
        self._singletons = {entry["type"] for entry in api["singletons"]}
        self._surface = surface
        self._picked: dict[str, EngineClass] = {}

    def pick_all(self) -> dict[str, EngineClass]:
        for name in self._surface:
            if name not in self._available:
                raise SurfaceError(f"This Godot has no class {name}; correct the surface file.")
            self._pick(name)
        return self._picked

    def _pick(self, name: str) -> None:
        if name in self._picked:
            return
        entry = self._available[name]
        parent = entry.get("inherits") or None
        if parent is not None:
            self._pick(parent)
        if name in self._picked:
            return
        picked = EngineClass(
            name=name,
            parent=parent,
            is_refcounted=entry["is_refcounted"],
            is_singleton=name in self._singletons,
            constants=tuple((c["name"], c["value"]) for c in entry.get("constants", [])),
            enums=tuple(_enumeration(e) for e in entry.get("enums", [])),
            methods=_pick(name, self._surface.get(name, []), entry.get("methods", [])),
        )
        self._picked[name] = picked
        for method in picked.methods:
            for type_name in _types_of(method):
                needed = referenced_class(type_name)
                if needed is not None and needed in self._available:
                    self._pick(needed)


def load(api_path: Path, surface_path: Path) -> Model:
    """Reads both files; raises SurfaceError with the remedy when they do not fit each other."""
    api: dict[str, Any] = json.loads(api_path.read_text(encoding="utf-8"))
    surface: dict[str, Any] = json.loads(surface_path.read_text(encoding="utf-8"))

    layouts = {entry["build_configuration"]: entry["sizes"] for entry in api["builtin_class_sizes"]}
    sizes = {entry["name"]: entry["size"] for entry in layouts["float_64"]}
    available = {entry["name"]: entry for entry in api["builtin_classes"]}
    builtins: dict[str, BuiltinType] = {}
    for name, wanted in surface["builtins"].items():
        if name not in available:
            raise SurfaceError(f"This Godot has no built-in type {name}; correct the surface file.")
        methods = tuple(_pick(name, wanted, available[name].get("methods", [])))
        builtins[name] = BuiltinType(name, sizes[name], methods)

    enums = {entry["name"]: entry for entry in api["global_enums"]}
    class_methods = {
        (entry["name"], method["name"]): method["hash"]
        for entry in api["classes"]
        for method in entry.get("methods", [])
        if "hash" in method
    }
    return Model(
        classes=_ClassPicker(api, surface["classes"]).pick_all(),
        builtins=builtins,
        global_enums=[_enumeration(enums[name]) for name in surface["global_enums"]],
        utility_functions=_pick("@GlobalScope", surface["utility_functions"], api["utility_functions"]),
        variant_size=sizes["Variant"],
        internal_hashes={
            "kHashGetParentClass": class_methods["ClassDB", "get_parent_class"],
            "kHashNotification": class_methods["Object", "notification"],
        },
    )
