# SPDX-License-Identifier: MIT
"""The stages that read the sources: format, lint, house rules."""

from __future__ import annotations

import os
import re
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from lint import house_rules
from setup import paths
from testing import tidy
from testing.context import Context, complaint, each_file, relative, sources
from testing.junit import Case

# The GUT runner's own tests show what it does with a script that does not compile.
_BROKEN_ON_PURPOSE = "tools/gut_runner/selftest/special/test_broken.gd"


def format_stage(context: Context) -> list[Case]:
    """clang-format on the C++ sources, gdformat on the scripts."""
    _ = context.engine
    cpp = each_file(sources(".cpp", ".h", under="gdextension"), "clang-format", _clang_format)
    return cpp + _gdscript_cases(context.style_tools / "gdformat", ["--check"], "gdformat")


def lint_stage(context: Context) -> list[Case]:
    """clang-tidy on the C++ sources, gdlint on the scripts, shellcheck on the shell files."""
    _ = context.engine
    shell = each_file(_shell_files(), "shellcheck", lambda path: complaint(["shellcheck", "-x", path]))
    scripts = _gdscript_cases(context.style_tools / "gdlint", [], "gdlint")
    return shell + scripts + tidy.cases(context.extension, context.all_variants)


def rules_stage(_context: Context) -> list[Case]:
    """The rules of the house that no other tool knows."""
    return [
        Case(rule.name, "house_rules", failure="\n".join(rule.check(paths.ROOT, sources())) or None)
        for rule in house_rules.RULES
    ]


def _clang_format(path: Path) -> str:
    wrong = complaint(["clang-format", "--dry-run", "-Werror", "--style=file", path])
    lines = re.findall(rf"^{re.escape(str(path))}:(\d+):\d+: error", wrong, re.MULTILINE)
    if lines:
        return f"not formatted (line {', '.join(dict.fromkeys(lines))}); run clang-format -i {relative(path)}"
    return wrong


def _shell_files() -> list[Path]:
    fronts = [paths.ROOT / name for name in ("run", "test", ".ci/run")]
    return [*fronts, *sources(".sh")]


def _gdscript_cases(tool: Path, options: list[str], group: str) -> list[Case]:
    """One case per script, from one start per processor of a tool that names the files it objects to."""
    names = [relative(path) for path in sources(".gd")]
    names = [name for name in names if name != _BROKEN_ON_PURPOSE]
    if not names:
        return [Case("scripts", group, failure="there is no .gd file to check")]
    starts = os.cpu_count() or 2
    with ThreadPoolExecutor(starts) as pool:
        shares = (names[i::starts] for i in range(min(starts, len(names))))
        done = pool.map(lambda share: _share_of_cases(tool, options, group, share), shares)
        return [case for cases in done for case in cases]


def _share_of_cases(tool: Path, options: list[str], group: str, names: list[str]) -> list[Case]:
    done = subprocess.run(
        [str(tool), *options, *names], cwd=paths.ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        text=True, check=False,
    )
    lines = done.stdout.splitlines()
    cases = []
    for name in names:
        about = [line for line in lines if re.search(rf"(^|\s){re.escape(name)}(:|\s|$)", line)]
        cases.append(Case(name, group, failure="\n".join(about) if done.returncode and about else None))
    if done.returncode and not any(case.failure for case in cases):
        cases.append(Case("ends well", group, failure=done.stdout or f"exit status {done.returncode}"))
    return cases
