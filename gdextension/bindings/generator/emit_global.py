# SPDX-License-Identifier: MIT
"""Emits what belongs to no class: global enumerations and utility functions."""

from __future__ import annotations

from .emit_classes import BANNER, _enumeration, enum_name
from .model import Method, Model, SurfaceError


def global_constants(model: Model) -> str:
    """The header of the global enumerations."""
    out = [BANNER, "#pragma once", '#include "godot_provider/enum_name.hpp"', "#include <cstdint>", ""]
    out += ["namespace godot {", ""]
    out += [_enumeration(enum.name, enum.values, "") for enum in model.global_enums]
    out += ["namespace internal {"]
    out += [enum_name(enum.name) for enum in model.global_enums]
    out += ["} // namespace internal", "} // namespace godot", ""]
    return "\n".join(out)


def _check(method: Method) -> None:
    if not method.is_vararg or method.return_type is not None:
        raise SurfaceError(
            f"Utility function {method.name} returns a value: only printing ones are supported."
        )


def utility_header(model: Model) -> str:
    """The header of the utility functions."""
    out = [BANNER, "#pragma once", '#include "godot_cpp/variant/variant.hpp"', "", "namespace godot {", ""]
    out += ["// Functions of @GlobalScope.", "class UtilityFunctions {", "public:"]
    for method in model.utility_functions:
        _check(method)
        out += [
            "\ttemplate <class... Values>",
            f"\tstatic void {method.name}(const Values &...values) {{",
            "\t\tconst Variant list[] = {Variant(values)..., Variant()};",
            f"\t\t_varargs_{method.name}(list, sizeof...(values));",
            "\t}",
        ]
    out += ["", "private:"]
    out += [
        f"\tstatic void _varargs_{method.name}(const Variant *values, std::size_t count);"
        for method in model.utility_functions
    ]
    out += ["};", "", "} // namespace godot", ""]
    return "\n".join(out)


def utility_source(model: Model) -> str:
    """The definitions of the utility functions."""
    out = [
        BANNER,
        '#include "godot_cpp/variant/utility_functions.hpp"',
        '#include "godot_provider/call.hpp"',
        "",
    ]
    out += ["namespace godot {", ""]
    for method in model.utility_functions:
        out.append(
            f"void UtilityFunctions::_varargs_{method.name}(const Variant *values, std::size_t count) {{\n"
            "\tstatic const GDExtensionPtrUtilityFunction function ="
            f' internal::utility_function("{method.name}", {method.hash});\n'
            "\tinternal::call_utility_variants(function, nullptr, values, count);\n}\n"
        )
    out += ["} // namespace godot", ""]
    return "\n".join(out)
