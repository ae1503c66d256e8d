# SPDX-License-Identifier: MIT
import contextlib
import io
import tempfile
import threading
import unittest
from collections.abc import Callable
from pathlib import Path
from unittest import mock

from setup.console import Failure
from testing import cli, junit
from testing.cli import Stage
from testing.context import Context
from testing.junit import Case


def _stage(name: str, run: Callable[[Context], list[Case]]) -> Stage:
    return Stage(name, "", run)


def _trouble(_context: Context) -> list[Case]:
    raise Failure("no engine")


class Main(unittest.TestCase):
    def _run(self, *stages: Stage, arguments: tuple[str, ...] = ()) -> tuple[int, str]:
        printed = io.StringIO()
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(cli, "STAGES", list(stages)), \
                mock.patch.object(cli, "RESULTS", Path(folder)), contextlib.redirect_stdout(printed):
            status = cli.main(list(arguments))
            self.results = {path.stem: junit.read(path) for path in Path(folder).glob("*.xml")}
        return status, printed.getvalue().splitlines()[-1]

    def test_all_good(self) -> None:
        good = _stage("good", lambda _: [Case("a"), Case("b")])
        self.assertEqual(self._run(good), (0, "2 passed, 0 failed"))
        self.assertEqual(len(self.results["good"]), 2)

    def test_one_failure_is_enough(self) -> None:
        mixed = _stage("mixed", lambda _: [Case("a"), Case("b", failure="no"), Case("c", skipped="later")])
        self.assertEqual(self._run(mixed), (1, "1 passed, 1 failed, 1 skipped"))

    def test_a_stage_without_tests_fails(self) -> None:
        self.assertEqual(self._run(_stage("empty", lambda _: [])), (1, "0 passed, 1 failed"))

    def test_a_stage_that_cannot_run_fails_and_the_next_runs(self) -> None:
        good = _stage("good", lambda _: [Case("a")])
        self.assertEqual(self._run(_stage("trouble", _trouble), good), (1, "1 passed, 1 failed"))
        self.assertEqual(self.results["trouble"][0].failure, "no engine")

    def test_neighbours_that_may_run_beside_each_other(self) -> None:
        both_here = threading.Barrier(2, timeout=20.0)

        def meet(_context: Context) -> list[Case]:
            both_here.wait()
            return [Case("met")]

        stages = [Stage(name, "", meet, beside=True) for name in ("one", "other")]
        with mock.patch.object(cli, "_prepare"), mock.patch.object(cli.os, "cpu_count", return_value=2):
            self.assertEqual(self._run(*stages), (0, "2 passed, 0 failed"))
        self.assertEqual(set(self.results), {"one", "other"})

    def test_one_that_mostly_waits_takes_the_place_of_none(self) -> None:
        all_here = threading.Barrier(3, timeout=20.0)

        def meet(_context: Context) -> list[Case]:
            all_here.wait()
            return [Case("met")]

        stages = [Stage(name, "", meet, beside=True, waits=name == "waiting") for name in ("one", "waiting", "other")]
        with mock.patch.object(cli, "_prepare"), mock.patch.object(cli.os, "cpu_count", return_value=2):
            self.assertEqual(self._run(*stages), (0, "3 passed, 0 failed"))

    def test_of_a_long_failure_both_ends_are_shown(self) -> None:
        lines = cli.shortened("\n".join(str(number) for number in range(100)), "a.xml").split("\n")
        self.assertEqual((lines[0], lines[6], lines[-1]), ("    0", "    ... 80 more lines in a.xml ...", "    99"))
        self.assertEqual(cli.shortened("one\ntwo", "a.xml"), "    one\n    two")

    def test_chosen_stages_alone(self) -> None:
        stages = [_stage(name, lambda _: [Case("a")]) for name in ("gut", "render-mobile", "render-forward_plus")]
        self.assertEqual(self._run(*stages, arguments=("render",))[1], "2 passed, 0 failed")
        self.assertEqual(self._run(*stages, arguments=("render-mobile", "gut"))[1], "2 passed, 0 failed")

    def test_an_unknown_stage_is_refused(self) -> None:
        with contextlib.redirect_stderr(io.StringIO()) as printed, self.assertRaises(SystemExit) as caught:
            cli.main(["nonsense"])
        self.assertEqual(caught.exception.code, 2)
        self.assertIn("there is no stage 'nonsense'", printed.getvalue())

    def test_the_long_variants_are_passed_on(self) -> None:
        seen: list[bool] = []

        def look(context: Context) -> list[Case]:
            seen.append(context.all_variants)
            return [Case("a")]

        self._run(_stage("a", look), arguments=("--all",))
        self.assertEqual(seen, [True])
