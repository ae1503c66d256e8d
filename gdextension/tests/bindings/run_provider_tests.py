#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Builds the test extension of the bindings and runs its GDScript tests in headless Godot.

By default against the provider in gdextension/bindings; with --godot-cpp-dir against upstream godot-cpp, which
must pass the same tests. With --asan both the extension and the bindings are built with the address and
undefined-behaviour sanitizers, and a leak, double free or use after free fails the run.

Exit status: 0 when every test has passed, 1 when one has failed, 2 when nothing could be run.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import time
from dataclasses import dataclass, field
from pathlib import Path
from xml.etree import ElementTree

HERE = Path(__file__).resolve().parent
BINDINGS = HERE.parent.parent / "bindings"
RUN_SECONDS = 300  # far more than a run takes; a hanging Godot must not hang the tests
SANITIZER_EXIT = 77  # not used by Godot


class SetUpError(Exception):
    """Nothing could be run; the message says why and what to do."""


@dataclass
class Result:
    """One test and what went wrong with it (empty: it has passed)."""

    suite: str
    name: str
    seconds: float = 0.0
    failures: list[str] = field(default_factory=list)


@dataclass(frozen=True)
class Options:
    godot: Path
    build_dir: Path
    asan: bool
    godot_cpp_dir: Path | None
    cmake_arguments: tuple[str, ...]
    jobs: int


def run_checked(command: list[str], what: str, cwd: Path | None = None) -> None:
    """Runs a build step; its output is shown only when it fails."""
    try:
        done = subprocess.run(
            command, cwd=cwd, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False
        )
    except FileNotFoundError as error:
        raise SetUpError(f"{what}: {error.filename} is not installed") from error
    if done.returncode != 0:
        raise SetUpError(f"{what} failed:\n{done.stdout[-6000:]}")


def build(options: Options) -> Path:
    """Configures and builds the extension; returns the library."""
    command = ["cmake", "-S", str(HERE), "-B", str(options.build_dir), "-DCMAKE_BUILD_TYPE=Debug"]
    if not (options.build_dir / "CMakeCache.txt").exists() and shutil.which("ninja"):
        command += ["-G", "Ninja"]
    command.append(f"-DGODOT_EXECUTABLE={options.godot}")
    command.append(f"-DPROBE_SANITIZE={'address,undefined' if options.asan else ''}")
    if options.godot_cpp_dir is not None:
        options.build_dir.mkdir(parents=True, exist_ok=True)
        profile = options.build_dir / "build_profile.json"
        make_profile = [
            sys.executable,
            "-m",
            "generator.build_profile",
            str(BINDINGS / "surface.json"),
            str(profile),
        ]
        run_checked(make_profile, "Writing the build profile", cwd=BINDINGS)
        command += [f"-DGODOT_CPP_DIR={options.godot_cpp_dir}", f"-DGODOTCPP_BUILD_PROFILE={profile}"]
    run_checked(command + list(options.cmake_arguments), "Configuring the test extension")
    run_checked(
        ["cmake", "--build", str(options.build_dir), "--parallel", str(options.jobs), "--target", "probe"],
        "Building the test extension",
    )
    return options.build_dir / "libprobe.so"


def prepare_project(options: Options, library: Path) -> Path:
    """A fresh copy of the test project that loads the library."""
    project = options.build_dir / "project"
    shutil.rmtree(project, ignore_errors=True)
    shutil.copytree(HERE / "project", project)
    (project / "probe.gdextension").write_text(
        '[configuration]\nentry_symbol = "probe_init"\ncompatibility_minimum = "4.6"\nreloadable = true\n\n'
        f'[libraries]\nlinux.x86_64 = "{library}"\nlinux.arm64 = "{library}"\n',
        encoding="utf-8",
    )
    (project / ".godot").mkdir()
    (project / ".godot" / "extension_list.cfg").write_text("res://probe.gdextension\n", encoding="utf-8")
    return project


def sanitizer_environment(build_dir: Path, find_leaks: bool) -> dict[str, str]:
    """What lets an engine that is not sanitized itself load a sanitized extension.

    The engine opens extensions with RTLD_DEEPBIND, which the sanitizer refuses; a small library in front takes
    that flag away. Where leaks are looked for, the extension stays in memory after the engine closes it; elsewhere
    it goes, so that the editor's reloading loads it anew.
    """
    shim = build_dir / "libno_deepbind.so"
    run_checked(
        ["cc", "-shared", "-fPIC", "-o", str(shim), str(HERE / "no_deepbind.c"), "-ldl"], "Building the shim"
    )
    runtimes = []
    for name in ("libasan.so", "libubsan.so"):
        found = subprocess.run(["cc", f"-print-file-name={name}"], text=True, capture_output=True, check=True)
        runtimes.append(os.path.realpath(found.stdout.strip()))
    for log in build_dir.glob("sanitizer.log*"):
        log.unlink()
    common = f"log_path={build_dir / 'sanitizer.log'}:exitcode={SANITIZER_EXIT}"
    return {
        "KEEP_LIBRARIES": str(int(find_leaks)),  # whose stacks the report of leaks must be able to name
        "LD_PRELOAD": ":".join([str(shim), *runtimes]),
        "ASAN_OPTIONS": f"{common}:detect_leaks={int(find_leaks)}:verify_asan_link_order=0",
        "UBSAN_OPTIONS": f"{common}:halt_on_error=1:print_stacktrace=1",
    }


def run_godot(
    options: Options, arguments: list[str], project: Path, find_leaks: bool = True, sanitized: bool = True
) -> tuple[int, str]:
    """Runs headless Godot in the project; returns its exit status and output."""
    environment = dict(os.environ)
    environment["XDG_DATA_HOME"] = str(options.build_dir / "user")
    environment["XDG_CONFIG_HOME"] = str(options.build_dir / "config")
    # The editor keeps its class help there; another editor that writes it meanwhile would take ours away.
    environment["XDG_CACHE_HOME"] = str(options.build_dir / "cache")
    if options.asan and sanitized:
        environment |= sanitizer_environment(options.build_dir, find_leaks)
    command = [
        str(options.godot),
        "--headless",
        "--audio-driver",
        "Dummy",
        "--path",
        str(project),
        *arguments,
    ]
    try:
        done = subprocess.run(
            command,
            env=environment,
            text=True,
            errors="replace",
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            timeout=RUN_SECONDS,
            check=False,
        )
    except subprocess.TimeoutExpired as error:
        return -1, f"no end after {RUN_SECONDS} s\n{error.output}"
    return done.returncode, done.stdout


def sanitizer_report(build_dir: Path) -> str:
    return "\n".join(log.read_text(errors="replace") for log in sorted(build_dir.glob("sanitizer.log*")))


def run_scripts(options: Options, project: Path) -> list[Result]:
    """The tests in GDScript, and what came out when Godot ended."""
    results_file = options.build_dir / "results.json"
    results_file.unlink(missing_ok=True)
    arguments = ["-s", "res://run_tests.gd", "--", f"--results={results_file}"]
    if options.godot_cpp_dir is not None:
        arguments.append("--upstream")
    status, output = run_godot(options, arguments, project)
    end = Result("process", "ends_cleanly")
    results = [end]
    if results_file.exists():
        cases = json.loads(results_file.read_text(encoding="utf-8"))["cases"]
        results += [Result(c["suite"], c["name"], c["seconds"], c["failures"]) for c in cases]
        if not cases:
            end.failures.append("no test has been run")
    else:
        end.failures.append(f"Godot ended with {status} before all tests had run:\n{output[-4000:]}")
    failed = any(result.failures for result in results)
    if status != (1 if failed else 0):
        end.failures.append(f"exit status {status}:\n{output[-4000:]}")
    for sign in ("leaked at exit", "Leaked instance", "resources still in use", "handle_crash"):
        if sign in output:
            end.failures.append(f'"{sign}" in the output:\n{output[-4000:]}')
    if options.asan and (report := sanitizer_report(options.build_dir)):
        end.failures.append(report[:8000])
    return results


def fill_help_cache(options: Options) -> None:
    """Lets the engine write its class help down. An editor that has to write it first does not show that of extensions
    until it is started again."""
    empty = options.build_dir / "empty_project"
    empty.mkdir(exist_ok=True)
    (empty / "project.godot").write_text("config_version=5\n", encoding="utf-8")
    run_godot(options, ["--import"], empty, sanitized=False)


def run_editor(options: Options, project: Path) -> Result:
    """The editor loads the extension, shows its warnings and help, reloads it, and ends.

    Leaks are not looked for: the engine itself leaks the argument types of each method when it reloads a library.
    """
    result = Result("process", "editor_loads_the_extension")
    started = time.monotonic()
    fill_help_cache(options)
    status, output = run_godot(options, ["--editor", "--quit-after", "20000"], project, find_leaks=False)
    result.seconds = time.monotonic() - started
    if status != 0 or "EDITOR CHECKS PASSED" not in output or "ERROR:" in output:
        told = [line for line in output.splitlines() if "FAILED in the editor" in line or "ERROR:" in line]
        result.failures.append("\n".join([f"exit status {status}", *told, output[-4000:]]))
    if options.asan and (report := sanitizer_report(options.build_dir)):
        result.failures.append(report[:8000])
    return result


def run_leak(options: Options, project: Path) -> Result:
    """The sanitizer finds a leak that is there: otherwise its silence would mean nothing."""
    result = Result("process", "sanitizer_finds_a_leak")
    status, output = run_godot(options, ["-s", "res://run_tests.gd", "--", "--leak"], project)
    report = sanitizer_report(options.build_dir)
    if status != SANITIZER_EXIT or "detected memory leaks" not in report or "leak_on_purpose" not in report:
        result.failures.append(f"exit status {status}, report:\n{report}\noutput:\n{output[-2000:]}")
    return result


def run_surface(options: Options) -> Result:
    """The sources stay on the surface (test_surface.py)."""
    result = Result("surface", "sources_stay_on_it")
    api = options.build_dir / "bindings" / "api" / "extension_api.json"
    started = time.monotonic()
    done = subprocess.run(
        [sys.executable, str(HERE / "test_surface.py")],
        env=dict(os.environ, GODOT_API=str(api)),
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        check=False,
    )
    result.seconds = time.monotonic() - started
    if done.returncode != 0 or "OK" not in done.stdout:
        result.failures.append(done.stdout[-6000:])
    return result


def write_junit(path: Path, name: str, results: list[Result]) -> None:
    suite = ElementTree.Element(
        "testsuite",
        name=name,
        tests=str(len(results)),
        failures=str(sum(1 for result in results if result.failures)),
    )
    for result in results:
        case = ElementTree.SubElement(
            suite,
            "testcase",
            classname=f"{name}.{result.suite}",
            name=result.name,
            time=f"{result.seconds:.4f}",
        )
        if result.failures:
            # XML has no place for the escape sequences that colour a terminal.
            told = [re.sub(r"\x1b\[[0-9;]*m|[^\t\n\x20-\uFFFD]", "", failure) for failure in result.failures]
            failure = ElementTree.SubElement(case, "failure", message=told[0].splitlines()[0])
            failure.text = "\n".join(told)
    path.parent.mkdir(parents=True, exist_ok=True)
    ElementTree.ElementTree(suite).write(path, encoding="utf-8", xml_declaration=True)


def parse(arguments: list[str]) -> tuple[Options, Path | None]:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument(
        "--godot", type=Path, default=os.environ.get("GODOT"), help="Godot 4.6 or newer; else $GODOT"
    )
    parser.add_argument(
        "--build-dir", type=Path, required=True, help="folder for the build and the test project"
    )
    parser.add_argument(
        "--asan", action="store_true", help="with the address and undefined-behaviour sanitizers"
    )
    parser.add_argument("--godot-cpp-dir", type=Path, help="upstream godot-cpp instead of the provider")
    parser.add_argument(
        "--cmake-arg", action="append", default=[], help="passed on to cmake (may be repeated)"
    )
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="parallel build steps")
    parser.add_argument("--junit", type=Path, help="file for the results in JUnit form")
    given = parser.parse_args(arguments)
    if given.godot is None:
        parser.error("no Godot: pass --godot or set GODOT")
    options = Options(
        godot=Path(shutil.which(given.godot) or given.godot).resolve(),
        build_dir=given.build_dir.resolve(),
        asan=given.asan,
        godot_cpp_dir=given.godot_cpp_dir.resolve() if given.godot_cpp_dir else None,
        cmake_arguments=tuple(given.cmake_arg),
        jobs=given.jobs,
    )
    return options, given.junit


def main() -> int:
    options, junit = parse(sys.argv[1:])
    name = "upstream" if options.godot_cpp_dir else "provider"
    if options.asan:
        name += "-asan"
    try:
        project = prepare_project(options, build(options))
        results = run_scripts(options, project)
        results.append(run_editor(options, project))
        if options.godot_cpp_dir is None:
            results.append(run_surface(options))
        if options.asan:
            results.append(run_leak(options, project))
    except SetUpError as error:
        print(f"{name}: {error}", file=sys.stderr)
        return 2
    if junit is not None:
        write_junit(junit, name, results)
    failed = [result for result in results if result.failures]
    for result in failed:
        print(f"FAILED {result.suite}.{result.name}\n  " + "\n  ".join(result.failures))
    print(f"{name}: {len(results) - len(failed)} of {len(results)} tests passed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
