# SPDX-License-Identifier: MIT
import contextlib
import io
import json
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from setup import self_test
from setup.console import Failure

_FOUND = {"renderer": "mobile", "passed": True, "report": ["check  ok", "This GPU draws the sky right."]}


class SelfTest(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)

    def _run(self, found: dict[str, object], *arguments: str) -> tuple[int, str]:
        """The subcommand with an engine that finds this; its status and what it printed."""
        printed = io.StringIO()
        with mock.patch.object(self_test.prepare, "project"), \
                mock.patch.object(self_test, "check", return_value=found), \
                contextlib.redirect_stdout(printed), contextlib.redirect_stderr(io.StringIO()):
            status = self_test.run(list(arguments))
        return status, printed.getvalue()

    def _check(self, status: int, written: object, renderer: str = "mobile") -> dict[str, object]:
        """check() with an engine that ends with this status and writes this."""
        out = self.folder / "found.json"

        def engine(_command: object, log: Path, timeout_s: float) -> int:
            log.write_text("the driver gave up\n", encoding="utf-8")
            if written is not None:
                out.write_text(json.dumps(written), encoding="utf-8")
            return status

        with mock.patch.object(self_test.process, "run_logged", engine), \
                mock.patch.object(self_test.paths, "LOGS", self.folder / "logs"):
            return self_test.check(mock.Mock(executable="godot"), renderer, out)

    def test_the_verdict_is_printed_and_returned(self) -> None:
        self.assertEqual(self._run(_FOUND), (0, "check  ok\nThis GPU draws the sky right.\n"))
        self.assertEqual(self._run({**_FOUND, "passed": False})[0], 1)

    def test_the_file_asked_for(self) -> None:
        out = self.folder / "new" / "card.json"
        status, printed = self._run(_FOUND, str(out), "--renderer", "mobile")
        self.assertEqual((status, printed.splitlines()[-1]), (0, str(out)))
        self.assertEqual(json.loads(out.read_text(encoding="utf-8")), _FOUND)

    def test_a_wrong_command_line(self) -> None:
        for arguments in (["a", "b"], ["--renderer", "vulcan"], ["--help"]):
            with self.subTest(arguments), self.assertRaisesRegex(Failure, "usage:") as caught:
                self_test.run(arguments)
            self.assertEqual(caught.exception.code, 2)

    def test_an_engine_that_found_something(self) -> None:
        for status in (0, 1):
            self.assertEqual(self._check(status, _FOUND), _FOUND)
        self.assertEqual(list((self.folder / "logs").iterdir()), [])

    def test_an_engine_that_wrote_nothing_or_crashed(self) -> None:
        for status, written in ((0, None), (2, None), (139, _FOUND)):
            (self.folder / "found.json").unlink(missing_ok=True)
            with self.subTest(status), self.assertRaisesRegex(Failure, "the driver gave up") as caught:
                self._check(status, written)
            self.assertEqual(caught.exception.code, status or 1)

    def test_another_renderer_than_the_one_asked_for_is_said(self) -> None:
        found = self._check(0, {**_FOUND, "renderer": "gl_compatibility"}, "forward_plus")
        self.assertIn("could not start forward_plus", found["report"][-1])


if __name__ == "__main__":
    unittest.main()
