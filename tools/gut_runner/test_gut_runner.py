# SPDX-License-Identifier: MIT
"""Tests of the test runner: a corpus of GutTest scripts whose outcomes are known, and its command line.

    python3 -m unittest discover -s tools/gut_runner        # or: python3 tools/gut_runner/test_gut_runner.py

The engine is the one that ./run would use, or the one named in $BLACKHOLE_GODOT. Names of tests in the corpus begin with test_ and
their outcome: pass, fail, pending, risky. With GUT_ADDON=/path/to/addons/gut the corpus also runs under GUT
itself, and every outcome must be the same there.
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

from setup import godot  # noqa: E402

INSTALLER = HERE / "install.py"
STATUS_OF_NAME = {"pass": "pass", "fail": "fail", "pending": "pending", "risky": "no asserts"}
ALONE = "-gtest=res://special/test_alone.gd"


def find_godot() -> str:
    """The engine's executable: $BLACKHOLE_GODOT, else the one that ./run would use."""
    return os.environ.get("BLACKHOLE_GODOT") or str(godot.find().executable)


def run_installer(project: Path) -> str:
    command = [sys.executable, str(INSTALLER), "--project", str(project)]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


class Project:
    """A scratch copy of the corpus as a Godot project."""

    def __init__(self, addon: Path | None = None):
        self._folder = tempfile.TemporaryDirectory()
        self.root = Path(self._folder.name) / "project"
        shutil.copytree(HERE / "selftest", self.root)
        if addon is None:
            run_installer(self.root)
        else:
            shutil.copytree(addon, self.root / "addons" / "gut")
        self._godot = find_godot()
        self._environment = dict(os.environ)
        for kind in ("DATA", "CONFIG"):
            self._environment[f"XDG_{kind}_HOME"] = str(Path(self._folder.name) / kind.lower())

    def close(self) -> None:
        self._folder.cleanup()

    def godot(self, *arguments: str) -> subprocess.CompletedProcess:
        command = [self._godot, "--headless", "--path", str(self.root), *arguments]
        return subprocess.run(
            command,
            capture_output=True,
            text=True,
            timeout=240,
            env=self._environment,
            stdin=subprocess.DEVNULL,
        )

    def import_all(self) -> None:
        self.godot("--import")

    def gut(self, *arguments: str) -> subprocess.CompletedProcess:
        return self.godot("-s", "addons/gut/gut_cmdln.gd", "-gexit", "-gdisable_colors", *arguments)

    def outcomes(self, *arguments: str) -> tuple[int, dict[str, str]]:
        """Exit code, and status by "classname::name", of a run without configuration file."""
        report = self.root / "results.xml"
        report.unlink(missing_ok=True)
        code = self.gut("-gconfig=", "-gjunit_xml_file=res://results.xml", *arguments).returncode
        cases = ElementTree.parse(report).iter("testcase")
        return code, {f"{c.get('classname')}::{c.get('name')}": c.get("status") for c in cases}


class GodotCase(unittest.TestCase):
    """Shares one imported project among the tests of a class."""

    project: Project

    @classmethod
    def setUpClass(cls) -> None:
        cls.project = Project()
        cls.addClassCleanup(cls.project.close)
        cls.project.import_all()


class Corpus(GodotCase):
    """The outcome of every test is the one its name says."""

    code: int
    result: dict[str, str]
    junit: ElementTree.Element

    @classmethod
    def setUpClass(cls) -> None:
        super().setUpClass()
        cls.code, cls.result = cls.project.outcomes("-gdir=res://tests")
        cls.junit = ElementTree.parse(cls.project.root / "results.xml").getroot()

    def check_names(self, outcomes: dict[str, str]) -> None:
        for test, status in outcomes.items():
            name = test.split("::")[1]
            if name.startswith("test_"):
                with self.subTest(test):
                    self.assertEqual(status, STATUS_OF_NAME[name.split("_")[1]])

    def written(self, folder: str) -> int:
        """How many tests a folder of the corpus has, by its text, less those that must not run."""
        count = 0
        for script in (HERE / "selftest" / folder).glob("test_*.gd"):
            lines = script.read_text(encoding="utf-8").splitlines()
            count += sum(line.strip().startswith("func test_") for line in lines)
            count -= sum(line.strip().startswith("func test_fail_never_run") for line in lines)
            count -= sum(line.strip().startswith("func test_fail_is_never_run") for line in lines)
        return count

    def test_outcomes(self) -> None:
        self.assertEqual(self.code, 1)
        # test_derived.gd inherits two tests: one from another file, one from another class.
        self.assertEqual(len(self.result), self.written("tests") + 2)
        self.check_names(self.result)

    def test_stricter_than_gut(self) -> None:
        code, outcomes = self.project.outcomes("-gdir=res://stricter")
        self.assertEqual(code, 1)
        for around in ("before_all", "after_all"):
            key = f"stricter/test_stricter.gd.TestErrorOutside::{around}"
            self.assertEqual(outcomes.pop(key), "fail")
        self.assertEqual(len(outcomes), self.written("stricter"))
        self.check_names(outcomes)

    def test_same_under_gut_itself(self) -> None:
        addon = os.environ.get("GUT_ADDON")
        if not addon:
            self.skipTest("GUT_ADDON does not name a folder with GUT")
        real = Project(Path(addon))
        self.addCleanup(real.close)
        real.import_all()
        self.assertEqual((self.code, self.result), real.outcomes("-gdir=res://tests"))

    def test_junit_counts(self) -> None:
        root = self.junit
        self.assertEqual(root.tag, "testsuites")
        cases = list(root.iter("testcase"))
        self.assertEqual(int(root.get("tests")), len(cases))
        failing = [case for case in cases if case.get("status") == "fail"]
        self.assertEqual(int(root.get("failures")), len(failing))
        self.assertTrue(all(case.find("failure").text for case in failing))
        for suite in root.iter("testsuite"):
            of_suite = [case.get("status") for case in suite.iter("testcase")]
            self.assertEqual(int(suite.get("tests")), len(of_suite))
            self.assertEqual(int(suite.get("failures")), of_suite.count("fail"))
            self.assertEqual(int(suite.get("skipped")), of_suite.count("pending"))


class CommandLine(GodotCase):
    """Options, configuration, hooks, exit codes."""

    def check(self, code: int, text: str, *arguments: str) -> None:
        run = self.project.gut(*arguments)
        output = run.stdout + run.stderr
        self.assertEqual(run.returncode, code, output)
        self.assertIn(text, output)

    def config(self, content: object) -> str:
        path = self.project.root / "config.json"
        path.write_text(content if isinstance(content, str) else json.dumps(content))
        return "-gconfig=res://config.json"

    def test_all_pass(self) -> None:
        self.check(0, "1 passed, 0 failed, 1 pending", "-gconfig=", ALONE)

    def test_nothing_to_run(self) -> None:
        self.check(1, "no test was run", "-gconfig=")
        self.check(1, "no test was run", "-gconfig=", ALONE, "-gunit_test_name=absent")

    def test_missing_places(self) -> None:
        self.check(1, "res://no.gd does not exist", "-gconfig=", ALONE, "-gtest=res://no.gd")
        self.check(1, "res://nowhere does not exist", "-gconfig=", ALONE, "-gdir=res://nowhere")

    def test_script_that_does_not_compile(self) -> None:
        text = "test_broken.gd does not compile"
        self.check(1, text, "-gconfig=", ALONE, "-gtest=res://special/test_broken.gd")
        # Named like a test, but no GutTest.
        other = self.project.root / "special" / "test_other.gd"
        other.write_text("extends Node\n")
        self.addCleanup(other.unlink)
        text = "test_other.gd does not extend GutTest"
        self.check(1, text, "-gconfig=", ALONE, "-gtest=res://special/test_other.gd")

    def test_wrong_options(self) -> None:
        self.check(1, "unknown option -gnonsense", "-gconfig=", ALONE, "-gnonsense=1")
        self.check(1, "-gtest wants a value", "-gconfig=", "-gtest")
        self.check(1, "must be a whole number", "-gconfig=", ALONE, "-glog=much")

    def test_help(self) -> None:
        self.check(0, "-gunit_test_name", "-gh")

    def test_wrong_configuration(self) -> None:
        self.check(1, "missing.json does not exist", ALONE, "-gconfig=res://missing.json")
        self.check(1, "config.json, line", ALONE, self.config("{"))
        self.check(1, "must be an object", ALONE, self.config([]))
        self.check(1, "dirs must be of type Array", ALONE, self.config({"dirs": "res://tests"}))

    def test_configuration_and_precedence(self) -> None:
        config = {"dirs": ["res://special"], "selected": "alone", "_comment": "unknown keys are fine"}
        self.check(0, "2 tests", self.config(config))
        config["unit_test_name"] = "pending"
        self.check(0, "1 tests", self.config(config))
        self.check(0, "2 tests", self.config(config), "-gunit_test_name=alone")

    def test_option_and_value_apart(self) -> None:
        self.check(0, "2 tests", "-gconfig=", "-gtest", "res://special/test_alone.gd", "-glog", "0")

    def test_subfolders(self) -> None:
        self.check(1, "no test was run", "-gconfig=", "-gdir=res://", "-gselect=alone")
        arguments = ("-gdir=res://", "-ginclude_subdirs", "-gselect=alone")
        self.check(0, "2 tests", "-gconfig=", *arguments)

    def test_selection(self) -> None:
        inner = ("-gdir=res://tests", "-gselect=lifecycle", "-ginner_class=TestOwn")
        self.check(0, "1 scripts (0 skipped), 1 tests: 1 passed", "-gconfig=", *inner)
        several = "-gtest=res://special/test_alone.gd,res://tests/test_derived.gd"
        self.check(0, "7 tests", "-gconfig=", several)

    def test_hooks(self) -> None:
        before, after = "-gpre_run_script=res://hooks/", "-gpost_run_script=res://hooks/"
        self.check(7, "post-run hook: 2 tests", "-gconfig=", ALONE, after + "exit_code.gd")
        self.check(1, '"hooked" expected to equal "plain"', "-gconfig=", ALONE, before + "setting.gd")
        self.check(1, "called the run off", "-gconfig=", ALONE, before + "stop.gd")
        self.check(1, "none.gd does not exist", "-gconfig=", ALONE, before + "none.gd")
        wrong = before.replace("hooks/", "special/test_alone.gd")
        self.check(1, "does not extend GutHookScript", "-gconfig=", ALONE, wrong)

    def test_error_types(self) -> None:
        errors = ("-gconfig=", "-gdir=res://tests", "-gselect=errors.gd")
        pushed = (*errors, "-gunit_test_name=fail_error_of_a_thread")
        self.check(1, "from a thread", *pushed)
        self.check(0, "1 passed", *pushed, "-gfailure_error_types=engine")
        self.check(0, "1 passed", *pushed, "-gno_error_tracking")
        expecting = (*errors, "-gunit_test_name=pass_assert_push_error")
        self.check(0, "1 passed", *expecting)
        self.check(1, "errors are not tracked", *expecting, "-gno_error_tracking")

    def test_error_outside_the_tests(self) -> None:
        stray = "-gtest=res://special/test_stray.gd"
        self.check(1, "error before special/test_stray.gd", "-gconfig=", stray)

    def test_junit_file_that_cannot_be_written(self) -> None:
        arguments = ("-gconfig=", ALONE, "-gjunit_xml_file=/proc/no/such/place.xml")
        self.check(1, "cannot write the JUnit file", *arguments)


class ClassNames(unittest.TestCase):
    """Before the first import the base class is not known: the runner says so."""

    def test_says_what_to_do(self) -> None:
        project = Project()
        self.addCleanup(project.close)
        run = project.gut("-gconfig=", ALONE)
        self.assertEqual(run.returncode, 1)
        self.assertIn("--import", run.stdout + run.stderr)


if __name__ == "__main__":
    unittest.main()
