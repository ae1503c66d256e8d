# SPDX-License-Identifier: MIT
"""./run package: the addon as a zip."""

from __future__ import annotations

import argparse
from pathlib import Path

from package import addon_zip, libraries, version
from setup import paths, prepare
from setup.console import Failure, note, say

USAGE = "usage: ./run package [--out DIR] [--libraries release,debug,windows]"


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> None:  # type: ignore[override]
        raise Failure(f"package: {message}\n{USAGE}", 2)


def run(arguments: list[str]) -> int:
    """The subcommand; prints the zip's path."""
    words = libraries.known()
    parser = _Parser(add_help=False)
    parser.add_argument("--out", default=str(paths.OUT / "package"))
    parser.add_argument("--libraries", default=",".join(words))
    chosen = parser.parse_args(arguments)
    wanted = chosen.libraries.split(",")
    unknown = [word for word in wanted if word not in words]
    if unknown or "release" not in wanted:
        raise Failure(f"package: --libraries takes {', '.join(words)}, release among them\n{USAGE}", 2)
    print(make(Path(chosen.out).absolute(), wanted))
    return 0


def make(out: Path, wanted: list[str]) -> Path:
    """The zip in folder `out`, with these libraries."""
    godot = prepare.engine()
    made = [libraries.make(word, godot) for word in libraries.known() if word in wanted]
    root = f"blackhole_sky-{version.text()}"
    say(f"Packing {root}")
    files = addon_zip.content(addon_zip.ADDON, made)
    zip_file = out / f"{root}.zip"
    addon_zip.write(zip_file, root, files)
    note(f"{len(files)} files, {sum(map(len, files.values())) / 1e6:.1f} MB; zipped {zip_file.stat().st_size / 1e6:.1f} MB")
    return zip_file
