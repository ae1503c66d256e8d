# SPDX-License-Identifier: MIT
"""Command line: python3 -m generator.docs OUT.cpp CLASS.xml...

Writes a source that carries the class descriptions into the library, for the editor's help.
"""

from __future__ import annotations

import sys
from pathlib import Path
from xml.etree import ElementTree

_LINE = 2000  # bytes per string literal: compilers limit the length of one


def literal(text: str) -> str:
    """The text as adjacent C string literals."""
    data = text.encode("utf-8")
    pieces = []
    for start in range(0, len(data), _LINE):
        piece = "".join(_escape(byte) for byte in data[start : start + _LINE])
        pieces.append(f'\t\t"{piece}"')
    return "\n".join(pieces)


def _escape(byte: int) -> str:
    character = chr(byte)
    if character in '\\"?':
        return "\\" + character
    return character if 32 <= byte < 127 else f"\\{byte:03o}"


def render(documents: list[Path]) -> str:
    """The source for these XML files; each must be a well-formed class description."""
    out = [
        "// SPDX-License-Identifier: MIT",
        "// Generated from the class descriptions (XML): do not edit.",
        "#include <godot_cpp/godot.hpp>",
        "",
        "namespace {",
        "",
    ]
    for index, path in enumerate(documents):
        text = path.read_text(encoding="utf-8")
        if ElementTree.fromstring(text).tag != "class":
            raise ValueError(f"{path}: the root element is not <class>")
        out += [
            f"const char text_{index}[] =\n{literal(text)};",
            f"const godot::internal::DocDataRegistration document_{index}(text_{index}, sizeof(text_{index}) - 1);",
            "",
        ]
    return "\n".join(out + ["} // namespace", ""])


def main() -> int:
    if len(sys.argv) < 3:
        print(__doc__, file=sys.stderr)
        return 2
    out = Path(sys.argv[1])
    try:
        text = render([Path(name) for name in sorted(sys.argv[2:])])
    except (OSError, ValueError, ElementTree.ParseError) as error:
        print(f"generator.docs: {error}", file=sys.stderr)
        return 1
    out.parent.mkdir(parents=True, exist_ok=True)
    out.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
