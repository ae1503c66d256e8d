# SPDX-License-Identifier: MIT
"""What the stages of ./test share: the machine made ready, step by step and once, and small helpers."""

from __future__ import annotations

import contextlib
import os
import subprocess
import threading
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from setup import build, gdtoolkit, monado, packages, paths, prepare, process, project_import
from setup.console import Failure, tail
from setup.godot import Godot
from setup.process import Command
from testing import junit
from testing.junit import Case

RESULTS = paths.OUT / "test"


@dataclass
class Context:
    """One run of ./test. all_variants is true for `./test --all`, with_headset where a simulated headset is needed."""

    all_variants: bool = False
    with_headset: bool = False  # its runtime is fetched while the compiler works

    @cached_property
    def engine(self) -> Godot:
        """Godot, with the system packages for building and testing."""
        return prepare.engine(packages.CHECKS)

    @cached_property
    def extension(self) -> Path:
        """The build folder of the extension and its tools, up to date."""
        engine = self.engine
        if self.with_headset:
            threading.Thread(target=_bring_headset, args=(engine,), daemon=True).start()
        return build.build("release", engine)

    @cached_property
    def project(self) -> Godot:
        """Godot with the built and imported project and a test runner in it."""
        godot, _ = self.engine, self.extension
        install = paths.ROOT / "tools" / "gut_runner" / "install.py"
        process.require(["python3", install], paths.LOGS / "gut-install.log", "Installing the GUT runner")
        project_import.ensure_imported(godot)
        return godot

    @cached_property
    def style_tools(self) -> Path:
        """The folder with gdformat and gdlint."""
        _ = self.engine
        return gdtoolkit.bring()

    def environment(self) -> dict[str, str]:
        """What test programs learn from the environment: the engine, and whether the long variants are wanted."""
        return {
            **os.environ,
            "GODOT": str(self.engine.executable),
            "BLACKHOLE_TEST_ALL": "1" if self.all_variants else "0",
        }


def _bring_headset(engine: Godot) -> None:
    """What fails here fails again where the headset is needed, and is told there."""
    with contextlib.suppress(Failure, OSError):
        monado.find(engine)


def sources(*suffixes: str, under: str = "") -> list[Path]:
    """The project's own files with one of these endings (with none named: all), without what git ignores."""
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", "--", under or "."],
        cwd=paths.ROOT, stdout=subprocess.PIPE, check=False,
    )
    if listed.returncode == 0:
        found: Iterable[Path] = (paths.ROOT / name for name in listed.stdout.decode().split("\0") if name)
    else:  # an unpacked archive has no git
        skipped = ("build", "out", ".godot")
        found = (p for p in (paths.ROOT / under).rglob("*") if p.relative_to(paths.ROOT).parts[0] not in skipped)
    return sorted(path for path in set(found) if path.is_file() and (not suffixes or path.name.endswith(suffixes)))


def relative(path: Path) -> str:
    """A path as the visitor knows it."""
    return str(path.relative_to(paths.ROOT)) if path.is_relative_to(paths.ROOT) else str(path)


def each_file(files: Sequence[Path], group: str, check: Callable[[Path], str]) -> list[Case]:
    """One case per file, in parallel; check returns what is wrong with a file, or nothing."""
    def case(path: Path) -> Case:
        wrong = check(path)
        return Case(relative(path), group, failure=wrong or None)

    with ThreadPoolExecutor(os.cpu_count() or 2) as pool:
        return list(pool.map(case, files))


def complaint(command: Command) -> str:
    """What a checker prints when it is not content; empty when it exits 0."""
    done = subprocess.run(
        [str(part) for part in command], cwd=paths.ROOT, stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", check=False,
    )
    return "" if done.returncode == 0 else done.stdout.strip() or f"exit status {done.returncode}"


def run_for_junit(
    command: Command, name: str, timeout_s: float, environment: Mapping[str, str], result: Path | None = None,
) -> list[Case]:
    """Runs a test program that writes JUnit XML to `result` (build/test-results/NAME.xml) and returns its cases.

    An exit status that no failed case explains, a missing file and an empty one are failures of their own.
    """
    result = result or result_file(name)
    result.unlink(missing_ok=True)
    log = paths.LOGS / f"test-{name}.log"
    status = process.run_logged(command, log, cwd=paths.ROOT, env=environment, timeout_s=timeout_s)
    try:
        cases = junit.read(result)
    except (OSError, SyntaxError) as error:
        raise Failure(f"{name} wrote no results ({error}); exit status {status}. The end of {log}:\n{tail(log)}") from error
    if not cases:
        raise Failure(f"{name} ran no test. The end of {log}:\n{tail(log)}")
    if status != 0 and not any(case.failure for case in cases):
        cases.append(Case("ends well", name, failure=f"exit status {status}. The end of {log}:\n{tail(log)}"))
    return cases


def result_file(name: str) -> Path:
    """Where a test program is told to write its results."""
    path = paths.BUILD / "test-results" / f"{name}.xml"
    path.parent.mkdir(parents=True, exist_ok=True)
    return path


def scripts_left_out(name: str, *folders: str, deep: bool = True) -> list[Case]:
    """A failed case for each test script of which the run reports nothing: a script that does not compile is passed by.

    Of the folders with what is in them, or (not deep) of them alone.
    """
    result = Path(result_file(name))
    reported = result.read_text(encoding="utf-8") if result.exists() else ""
    scripts = [path for folder in folders for path in sources(".gd", under=folder) if path.name.startswith("test_")]
    if not deep:
        scripts = [path for path in scripts if relative(path.parent) in folders]
    return [
        Case(relative(path), name, failure="the run reports no test of this script")
        for path in scripts if relative(path) not in reported
    ]
