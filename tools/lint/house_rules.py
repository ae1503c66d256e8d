# SPDX-License-Identifier: MIT
"""The rules of the house: short files, licence lines, dependencies that point one way, one version number."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

MAX_LINES = 500
_CODE = (".cpp", ".h", ".gd", ".gdshader", ".gdshaderinc", ".py", ".sh", ".cmake", "CMakeLists.txt", "/run", "/test")
_TEXT = (*_CODE, ".md", ".json", ".cfg", ".xml", ".tscn", ".tres", ".godot", ".gdextension", ".txt")
# In two pieces each, so that this file keeps the rule that it checks.
_FORBIDDEN = tuple("".join(pair) for pair in (
    ("/wo", "rk/"), ("../sh", "ared"), ("helper ses", "sion"), ("deb.deb", "ian.org"), ("snapshot.deb", "ian.org"),
))
# Who may include whom inside gdextension/: each folder names the folders it must not know.
_BLIND_TO = {
    "core": ("godot_cpp/", "gdextension_interface", "src/", "bindings/", "lut_cli/"),
    "lut_cli": ("godot_cpp/", "gdextension_interface", "src/", "bindings/"),
    "bindings": ("core/", "src/", "lut_cli/"),
    "src": ("bindings/", "lut_cli/"),
}
_ADDON = "res://addons/blackhole_sky"
# A package that the star catalogue is made of; its version may be the same by chance.
_OTHER_VERSIONS = re.compile(r"hipparcos[-_]catalog[`= -]+[0-9.]+")
_COPIES = ("LICENSE", "CHANGELOG.md", "THIRDPARTY.md")


@dataclass(frozen=True)
class Rule:
    """One rule; check(root, files) yields a line for each breach."""

    name: str
    check: Callable[[Path, Sequence[Path]], Iterator[str]]


def lengths(root: Path, files: Sequence[Path]) -> Iterator[str]:
    """No source file over 500 lines without a stated reason."""
    for path, text in _texts(files, _CODE):
        count = text.count("\n")
        if count > MAX_LINES and "LONG-FILE-REASON:" not in text:
            yield f"{path.relative_to(root)}: {count} lines; split it, or state why not after LONG-FILE-REASON:"


def licence_lines(root: Path, files: Sequence[Path]) -> Iterator[str]:
    """The licence is named in the first line, or the second one of a script that starts with #!."""
    for path, text in _texts(files, _CODE):
        head = text.splitlines()[:2]
        line = head[1] if len(head) == 2 and head[0].startswith("#!") else "".join(head[:1])
        if not re.fullmatch(r"(//|#) SPDX-License-Identifier: MIT", line):
            yield f"{path.relative_to(root)}: the first line must be the SPDX-License-Identifier comment"


def own_words(root: Path, files: Sequence[Path]) -> Iterator[str]:
    """The project speaks of itself: no addresses of archives, no places on somebody's machine."""
    for path, text in _texts(files, _TEXT):
        for number, line in enumerate(text.splitlines(), 1):
            for word in _FORBIDDEN:
                if word in line:
                    yield f"{path.relative_to(root)}:{number}: '{word}' does not belong here"


def include_directions(root: Path, files: Sequence[Path]) -> Iterator[str]:
    """Inside gdextension/ dependencies point one way: src to core, lut_cli to core; core knows nobody."""
    base = root / "gdextension"
    for path, text in _texts(files, (".cpp", ".h", ".hpp")):
        if not path.is_relative_to(base):
            continue
        folder = path.relative_to(base).parts[0]
        for included in re.findall(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', text, re.MULTILINE):
            if included.startswith(_BLIND_TO.get(folder, ())) or (folder in _BLIND_TO and ".." in included):
                yield f"{path.relative_to(root)}: must not include {included}"


def addon_alone(root: Path, files: Sequence[Path]) -> Iterator[str]:
    """What a user copies works alone: the addon refers to nothing outside its folder."""
    addon = root / "addons" / "blackhole_sky"
    for path, text in _texts(files, _TEXT):
        if not path.is_relative_to(addon):
            continue
        for reference in re.findall(r"res://[^\s\"'\)\],]*", text):
            if reference not in ("res://", _ADDON) and not reference.startswith(_ADDON + "/"):
                yield f"{path.relative_to(root)}: refers to {reference}, which is outside the addon"


def same_copies(root: Path, files: Sequence[Path]) -> Iterator[str]:
    """What lies at the top and in the addon under one name, for whoever has only one of them, is the same text."""
    for name in _COPIES:
        top, copy = root / name, root / "addons" / "blackhole_sky" / name
        if not (top in files and copy in files and top.read_bytes() == copy.read_bytes()):
            yield f"{copy.relative_to(root)}: must be a copy of {name}"


def one_version(root: Path, files: Sequence[Path]) -> Iterator[str]:
    """The version number stands in plugin.cfg; the change logs tell its history; nothing else repeats it."""
    home = root / "addons" / "blackhole_sky" / "plugin.cfg"
    match = re.search(r'^version="([0-9]+\.[0-9]+\.[0-9]+)', home.read_text(encoding="utf-8"), re.MULTILINE)
    if not match:
        yield f"{home.relative_to(root)}: has no line version=\"X.Y.Z\""
        return
    pattern = re.compile(rf"(?<![\d.]){re.escape(match.group(1))}(?![\d]|\.\d)")
    for path, text in _texts(files, _TEXT):
        if path == home or path.name.startswith("CHANGELOG"):
            continue
        for number, line in enumerate(text.splitlines(), 1):
            if pattern.search(_OTHER_VERSIONS.sub("", line)):
                yield f"{path.relative_to(root)}:{number}: repeats the version {match.group(1)} of plugin.cfg"


RULES = [
    Rule("no file over 500 lines", lengths),
    Rule("licence lines", licence_lines),
    Rule("the project speaks of itself", own_words),
    Rule("include directions", include_directions),
    Rule("the addon stands alone", addon_alone),
    Rule("copies in the addon", same_copies),
    Rule("one version number", one_version),
]


def _texts(files: Sequence[Path], endings: tuple[str, ...]) -> Iterator[tuple[Path, str]]:
    """The files with these endings and what is in them."""
    for path in files:
        if str(path).endswith(endings):
            yield path, path.read_text(encoding="utf-8", errors="replace")
