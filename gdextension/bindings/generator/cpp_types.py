# SPDX-License-Identifier: MIT
"""How the engine's types are written in C++: as value, as parameter, as default value, in file names."""

from __future__ import annotations

import re
from dataclasses import dataclass

from .model import SCALARS, Argument, Method, Model, SurfaceError, referenced_class

_INTEGER_METAS = {
    "int8": "std::int8_t",
    "int16": "std::int16_t",
    "int32": "std::int32_t",
    "int64": "std::int64_t",
    "uint8": "std::uint8_t",
    "uint16": "std::uint16_t",
    "uint32": "std::uint32_t",
    "uint64": "std::uint64_t",
}


def snake_case(name: str) -> str:
    """File and variable names as godot-cpp forms them: "World3D" -> "world3d", "Node3D" -> "node3d"."""
    spaced = re.sub(r"([a-z])([A-Z])", r"\1_\2", name)
    spaced = re.sub(r"([A-Z]+)([A-Z][a-z])", r"\1_\2", spaced)
    spaced = re.sub(r"([0-9])([A-Z][a-z])", r"\1_\2", spaced)
    return spaced.lower()


@dataclass(frozen=True)
class CppTypes:
    """Writes types; the model says which names are classes and which are built in."""

    model: Model

    def value(self, type_name: str, meta: str | None = None) -> str:
        """The type as a value: "enum::Image.Format" -> "Image::Format", "World3D" -> "Ref<World3D>"."""
        if type_name == "int":
            return _INTEGER_METAS.get(meta or "int64", "std::int64_t")
        if type_name == "float":
            return "float" if meta == "float" else "double"
        if type_name in ("bool", "Variant") or type_name in self.model.builtins:
            return type_name
        if type_name.startswith("enum::"):
            return type_name[len("enum::") :].replace(".", "::")
        if type_name.startswith("bitfield::"):
            return f"BitField<{type_name[len('bitfield::') :].replace('.', '::')}>"
        if type_name.startswith("typedarray::"):
            element = type_name[len("typedarray::") :]
            return f"TypedArray<{self._element(element)}>"
        if type_name in self.model.classes:
            return (
                self._element(type_name) if self.model.classes[type_name].is_refcounted else f"{type_name} *"
            )
        raise SurfaceError(
            f"Type {type_name} is not on the surface; add it there, or drop the method that uses it."
        )

    def parameter(self, argument: Argument) -> str:
        """The declaration of a parameter, without its default value."""
        value = self.value(argument.type, argument.meta)
        if self.by_value(argument.type):
            return f"{value}p_{argument.name}" if value.endswith("*") else f"{value} p_{argument.name}"
        return f"const {value} &p_{argument.name}"

    def by_value(self, type_name: str) -> bool:
        """True for scalars, enumerations and object pointers."""
        if type_name in SCALARS or type_name.startswith(("enum::", "bitfield::")):
            return True
        return type_name in self.model.classes and not self.model.classes[type_name].is_refcounted

    def returned(self, method: Method) -> str:
        """The return type."""
        return "void" if method.return_type is None else self.value(method.return_type, method.return_meta)

    def default(self, argument: Argument) -> str:
        """The C++ form of the engine's default value."""
        text = argument.default or ""
        type_name = argument.type
        if type_name == "Variant" and text == "null":
            return "Variant()"
        if text == "null":
            return "nullptr"
        if type_name.startswith("enum::"):
            return f"static_cast<{self.value(type_name)}>({text})"
        if type_name.startswith("bitfield::"):
            return f"{self.value(type_name)}(std::int64_t({text}))"
        if type_name in SCALARS:
            return text
        if text.startswith(("&", "^")):
            text = text[1:]
        if text.startswith('"'):
            return text
        if text in ("[]", "{}") or text.endswith(("()", "([])")):
            return f"{self.value(type_name)}()"
        if re.fullmatch(r"\w+\([-0-9., e]+\)", text) and not text.startswith("Transform"):
            return text
        raise SurfaceError(
            f"The default value {text} of type {type_name} has no C++ form yet; extend cpp_types.py."
        )

    def classes_in(self, methods: list[Method]) -> list[str]:
        """The engine classes that the methods mention, sorted."""
        found = set()
        for method in methods:
            for type_name in [a.type for a in method.arguments] + [method.return_type or "void"]:
                name = referenced_class(type_name)
                if name in self.model.classes:
                    found.add(name)
        return sorted(found)

    def enum_owners_in(self, methods: list[Method]) -> list[str]:
        """The classes whose enumerations appear in the methods' signatures, sorted."""
        found = set()
        for method in methods:
            for type_name in [a.type for a in method.arguments] + [method.return_type or "void"]:
                if type_name.startswith(("enum::", "bitfield::")) and "." in type_name:
                    found.add(referenced_class(type_name) or "")
        return sorted(found)

    def _element(self, name: str) -> str:
        is_reference = name in self.model.classes and self.model.classes[name].is_refcounted
        return f"Ref<{name}>" if is_reference else name
