# SPDX-License-Identifier: MIT
"""What a Windows DLL needs of others and offers to them, as objdump tells it, and whether it loads under Wine."""

from __future__ import annotations

import os
import re
import shutil
import tempfile
from pathlib import Path

from setup import paths, process
from setup.console import Failure

ENTRY = "blackhole_sky_init"
# Part of every Windows since 7. A compiler's own libraries (libstdc++, libgcc, libwinpthread, zlib1) are not.
_SYSTEM = frozenset(("advapi32.dll", "kernel32.dll", "msvcrt.dll", "ntdll.dll", "user32.dll"))
_TOOLS = "x86_64-w64-mingw32-"
_LOADER = Path(__file__).parent / "load_dll.cpp"


def check(dll: Path) -> None:
    """A Failure when the DLL needs others than Windows' own, or does not offer the one function that Godot calls."""
    printed = process.capture([f"{_TOOLS}objdump", "-p", dll])
    if printed is None:
        raise Failure(f"{_TOOLS}objdump cannot read {dll}.")
    strange = foreign(imports(printed))
    if strange:
        raise Failure(f"{dll.name} needs DLLs that are not part of Windows: {', '.join(strange)}. Link them in.")
    if exports(printed) != [ENTRY]:
        raise Failure(f"{dll.name} offers {exports(printed) or 'nothing'} instead of {ENTRY} alone.")


def imports(printed: str) -> list[str]:
    """The names of the DLLs in the import table that `objdump -p` printed."""
    return re.findall(r"^\s*DLL Name: (\S+)$", printed, re.MULTILINE)


def foreign(names: list[str]) -> list[str]:
    """Those that Windows does not bring along."""
    return [name for name in names if name.lower() not in _SYSTEM and not name.lower().startswith("api-ms-win-")]


def exports(printed: str) -> list[str]:
    """The names in the export table that `objdump -p` printed."""
    table = re.search(r"\[Ordinal/Name Pointer\] Table\n((?:\s*\[\s*\d+\].*\n)*)", printed)
    return re.findall(r"\]\s+(\S+)$", table.group(1), re.MULTILINE) if table else []


def wine() -> str | None:
    """Wine, where it is installed."""
    return shutil.which("wine64") or shutil.which("wine")


def load_under_wine(dll: Path) -> None:
    """Lets a small program load the DLL and find its function; a Failure when it cannot."""
    program = wine()
    assert program is not None
    log = paths.LOGS / "wine.log"
    with tempfile.TemporaryDirectory() as folder:
        process.require([*loader_command(), "-o", Path(folder) / "load.exe"], log, "Compiling the loader")
        environment = {**os.environ, "WINEPREFIX": f"{folder}/wine", "WINEDEBUG": "-all"}
        command = [program, f"{folder}/load.exe", f"Z:{dll}", ENTRY]
        process.require(command, log, f"Loading {dll.name} under Wine", env=environment, timeout_s=120)


def loader_command() -> list[object]:
    """The compiler's command line for the small program, less the place where it goes."""
    return [f"{_TOOLS}g++-posix", "-municode", "-static", "-Wall", "-Werror", _LOADER]
