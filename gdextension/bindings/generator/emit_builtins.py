# SPDX-License-Identifier: MIT
"""Emits the built-in types: their methods, the packed arrays, the list of value types, sizes."""

from __future__ import annotations

from .cpp_types import CppTypes, snake_case
from .emit_classes import BANNER
from .model import BuiltinType, Method, Model

# Element type, and the header that defines it, of each packed array.
_PACKED_ELEMENTS = {
    "PackedByteArray": ("std::uint8_t", None),
    "PackedInt32Array": ("std::int32_t", None),
    "PackedInt64Array": ("std::int64_t", None),
    "PackedFloat32Array": ("float", None),
    "PackedFloat64Array": ("double", None),
    "PackedStringArray": ("String", "string"),
    "PackedVector2Array": ("Vector2", "vector2"),
    "PackedVector3Array": ("Vector3", "vector3"),
    "PackedColorArray": ("Color", "color"),
}


def variant_tag(name: str) -> str:
    """The engine's constant for a type: "PackedFloat32Array" -> "PACKED_FLOAT32_ARRAY"."""
    return snake_case(name).upper()


def _overloads(method: Method) -> list[int]:
    """Numbers of arguments to offer: defaults become overloads, for the types are incomplete in the header."""
    required = sum(1 for a in method.arguments if a.default is None)
    return list(range(required, len(method.arguments)))


def _signature(types: CppTypes, method: Method, count: int) -> str:
    return ", ".join(types.parameter(a) for a in method.arguments[:count])


def _declarations(types: CppTypes, method: Method) -> list[str]:
    returned = types.returned(method)
    if method.is_vararg:
        return [
            f"template <class... Values>\n\t{returned} {method.name}(const Values &...values) const;",
            f"{returned} _varargs_{method.name}(const Variant *values, std::size_t count) const;",
        ]
    head = "static " if method.is_static else ""
    tail = " const" if method.is_const else ""
    counts = _overloads(method) + [len(method.arguments)]
    return [f"{head}{returned} {method.name}({_signature(types, method, n)}){tail};" for n in counts]


def methods_header(model: Model, builtin: BuiltinType) -> str:
    """The base class that declares the engine's methods of one built-in type."""
    types = CppTypes(model)
    tag = variant_tag(builtin.name)
    out = [BANNER, "#pragma once", '#include "godot_provider/builtin.hpp"']
    out += [
        f'#include "godot_cpp/variant/{snake_case(name)}.hpp"'
        for name in sorted(_value_arguments(model, builtin))
    ]
    out += ["namespace godot {"]
    out += [f"class {b.name};" for b in model.builtins.values() if not b.is_hand_written]
    out += ["class Object;", "class Variant;"]
    out += ["namespace internal {"]
    out.append(
        f"class {builtin.name}Methods : public Builtin<GDEXTENSION_VARIANT_TYPE_{tag}, {builtin.size}> {{\npublic:"
    )
    for method in builtin.methods:
        out += ["\t" + line for line in _declarations(types, method)]
    out += ["};", "} // namespace internal", "} // namespace godot", ""]
    return "\n".join(out)


def _value_arguments(model: Model, builtin: BuiltinType) -> set[str]:
    found = set()
    for method in builtin.methods:
        for name in [a.type for a in method.arguments] + [method.return_type or "void"]:
            if name in model.builtins and model.builtins[name].is_hand_written:
                found.add(name)
    return found


def _bodies(types: CppTypes, builtin: BuiltinType, method: Method) -> list[str]:
    owner = f"{builtin.name}Methods"
    returned = types.returned(method)
    tail = " const" if method.is_const else ""
    lookup = f'builtin_method({owner}::kVariantType, "{method.name}", {method.hash})'
    fetch = f"\tstatic const GDExtensionPtrBuiltInMethod method = {lookup};\n"
    if method.is_vararg:
        head = f"{returned} {owner}::_varargs_{method.name}(const Variant *values, std::size_t count) const"
        call = f"call_builtin_variants<{returned}>(method, _native_ptr(), values, count)"
        return [f"{head} {{\n{fetch}\treturn {call};\n}}\n"]
    self_pointer = "nullptr" if method.is_static else "_native_ptr()"
    arguments = "".join(f", p_{a.name}" for a in method.arguments)
    head = f"{returned} {owner}::{method.name}({_signature(types, method, len(method.arguments))}){tail}"
    call = f"call_builtin<{returned}>(method, {self_pointer}{arguments})"
    bodies = [f"{head} {{\n{fetch}\treturn {call};\n}}\n"]
    for count in _overloads(method):
        given = [f"p_{a.name}" for a in method.arguments[:count]]
        given += [f"{types.value(a.type)}({types.default(a)})" for a in method.arguments[count:]]
        bodies.append(
            f"{returned} {owner}::{method.name}({_signature(types, method, count)}){tail} {{\n"
            f"\treturn {method.name}({', '.join(given)});\n}}\n"
        )
    return bodies


def methods_source(model: Model) -> str:
    """The definitions of all methods of built-in types."""
    types = CppTypes(model)
    out = [BANNER, '#include "godot_cpp/variant/variant.hpp"', '#include "godot_provider/call.hpp"']
    out += [
        '#include "godot_provider/marshal_object.hpp"',
        "",
        "namespace godot {",
        "",
        "namespace internal {",
        "",
    ]
    for builtin in model.builtins.values():
        for method in builtin.methods:
            out += _bodies(types, builtin, method)
    out += ["} // namespace internal", ""]
    for builtin in model.builtins.values():
        if builtin.is_packed:
            out.append(_packed_source(builtin))
    out += ["} // namespace godot", ""]
    return "\n".join(out)


def packed_header(builtin: BuiltinType) -> str:
    """The header of one packed array."""
    element, element_header = _PACKED_ELEMENTS[builtin.name]
    name = builtin.name
    index = f"{snake_case(name)}_operator_index"
    out = [BANNER, "#pragma once"]
    if element_header is not None:
        out.append(f'#include "godot_cpp/variant/{element_header}.hpp"')
    out += [
        f'#include "godot_provider/generated/{snake_case(name)}_methods.hpp"',
        '#include "godot_provider/packed_array.hpp"',
        "namespace godot {",
        "namespace internal {",
        f"struct {name}Access {{",
        f"\tstatic const {element} *read(GDExtensionTypePtr array, std::int64_t index) {{",
        f"\t\treturn static_cast<const {element} *>(api.{index}_const(array, index));",
        "\t}",
        f"\tstatic {element} *write(GDExtensionTypePtr array, std::int64_t index) {{",
        f"\t\treturn static_cast<{element} *>(api.{index}(array, index));",
        "\t}",
        "};",
        "} // namespace internal",
        f"class {name} : public internal::PackedArray<internal::{name}Methods, {element}, internal::{name}Access> {{",
        "public:",
        "\tusing PackedArray::PackedArray;",
        f"\t{name}() = default;",
        f"\t{name}(const Array &values);",
        f"\tbool operator==(const {name} &other) const;",
        f"\tbool operator!=(const {name} &other) const {{ return !(*this == other); }}",
        "};",
        "} // namespace godot",
        "",
    ]
    return "\n".join(out)


def _packed_source(builtin: BuiltinType) -> str:
    name = builtin.name
    return (
        f"{name}::{name}(const Array &values) {{\n"
        "\tconst GDExtensionConstTypePtr arguments[] = {values._native_ptr()};\n"
        "\trebuild(2, arguments);\n}\n\n"
        f"bool {name}::operator==(const {name} &other) const {{\n"
        "\treturn compare(GDEXTENSION_VARIANT_OP_EQUAL, other);\n}\n"
    )


def value_types(model: Model) -> str:
    """The list of built-in types as a macro, with their headers."""
    out = [BANNER, "#pragma once"]
    out += [f'#include "godot_cpp/variant/{snake_case(name)}.hpp"' for name in sorted(model.builtins)]
    out += ["", "// X(type, its name in Variant::Type)", "#define GODOT_PROVIDER_VALUE_TYPES(X) \\"]
    rows = [f"\tX({name}, {variant_tag(name)})" for name in model.builtins]
    return "\n".join(out) + "\n" + " \\\n".join(rows) + "\n"


def vararg_methods(model: Model) -> str:
    """The methods that take any number of values; included at the end of variant.hpp."""
    types = CppTypes(model)
    out = [BANNER, "#pragma once", "namespace godot::internal {"]
    for builtin in model.builtins.values():
        for method in builtin.methods:
            if method.is_vararg:
                out += [
                    "template <class... Values>",
                    f"{types.returned(method)} {builtin.name}Methods::{method.name}(const Values &...values) const {{",
                    "\tconst Variant list[] = {Variant(values)..., Variant()};",
                    f"\treturn _varargs_{method.name}(list, sizeof...(values));",
                    "}",
                ]
    out += ["} // namespace godot::internal", ""]
    return "\n".join(out)


def sizes(model: Model) -> str:
    """Numbers of the API dump that the hand-written part needs."""
    out = [BANNER, "#pragma once", "#include <cstddef>", "#include <cstdint>", "namespace godot::internal {"]
    out.append(f"inline constexpr std::size_t kSizeOfVariant = {model.variant_size};")
    for name, value in model.internal_hashes.items():
        out.append(f"inline constexpr std::int64_t {name} = {value};")
    out += ["} // namespace godot::internal", ""]
    return "\n".join(out)


def layout_checks(model: Model) -> str:
    """A source that fails to compile when a type's size differs from the engine's."""
    out = [BANNER, '#include "godot_cpp/variant/variant.hpp"', "namespace godot {"]
    out += [f"static_assert(sizeof({b.name}) == {b.size});" for b in model.builtins.values()]
    out += [f"static_assert(sizeof(Variant) == {model.variant_size});", "} // namespace godot", ""]
    return "\n".join(out)
