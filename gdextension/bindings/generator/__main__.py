# SPDX-License-Identifier: MIT
"""Command line: python3 -m generator --api extension_api.json --surface surface.json --out DIR

Writes headers to DIR/include and sources to DIR/src; files whose text has not changed keep their time stamps,
files that are no longer wanted are removed.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from . import emit_builtins, emit_classes, emit_global
from .cpp_types import snake_case
from .model import Model, SurfaceError, load


def render(model: Model) -> dict[str, str]:
    """All generated files by their path below the output folder."""
    files: dict[str, str] = {}
    for cls in model.classes.values():
        name = snake_case(cls.name)
        files[f"include/godot_cpp/classes/{name}.hpp"] = emit_classes.header(model, cls)
        files[f"src/classes/{name}.cpp"] = emit_classes.source(model, cls)
    files["src/classes.cpp"] = emit_classes.registration(model)
    for builtin in model.builtins.values():
        name = snake_case(builtin.name)
        if builtin.is_hand_written:
            continue
        files[f"include/godot_provider/generated/{name}_methods.hpp"] = emit_builtins.methods_header(
            model, builtin
        )
        if builtin.is_packed:
            files[f"include/godot_cpp/variant/{name}.hpp"] = emit_builtins.packed_header(builtin)
    files["include/godot_provider/generated/value_types.hpp"] = emit_builtins.value_types(model)
    files["include/godot_provider/generated/vararg_methods.hpp"] = emit_builtins.vararg_methods(model)
    files["include/godot_provider/generated/sizes.hpp"] = emit_builtins.sizes(model)
    files["src/builtin_methods.cpp"] = emit_builtins.methods_source(model)
    files["src/layout_checks.cpp"] = emit_builtins.layout_checks(model)
    files["include/godot_cpp/classes/global_constants.hpp"] = emit_global.global_constants(model)
    files["include/godot_cpp/variant/utility_functions.hpp"] = emit_global.utility_header(model)
    files["src/utility_functions.cpp"] = emit_global.utility_source(model)
    return files


def write(files: dict[str, str], out: Path) -> None:
    """Brings the output folder to exactly these files."""
    for path in out.rglob("*"):
        if path.is_file() and str(path.relative_to(out)) not in files:
            path.unlink()
    for name, text in files.items():
        path = out / name
        if path.exists() and path.read_text(encoding="utf-8") == text:
            continue
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="generator", description="Generates the subset of godot-cpp we use."
    )
    parser.add_argument("--api", type=Path, required=True, help="extension_api.json of the engine")
    parser.add_argument("--surface", type=Path, required=True, help="surface.json: what to generate")
    parser.add_argument("--out", type=Path, required=True, help="output folder, owned by the generator")
    arguments = parser.parse_args()
    try:
        write(render(load(arguments.api, arguments.surface)), arguments.out)
    except SurfaceError as error:
        print(f"generator: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
