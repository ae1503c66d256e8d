# SPDX-License-Identifier: MIT
"""Runs one file of unittest tests and writes JUnit XML: unittest_junit.py TEST_FILE OUT.xml"""

from __future__ import annotations

import sys
import time
import traceback
import unittest
from pathlib import Path
from types import TracebackType
from typing import Any

sys.path[0] = str(Path(__file__).resolve().parent.parent)

from testing import junit  # noqa: E402

_ExcInfo = tuple[type[BaseException], BaseException, TracebackType] | tuple[None, None, None]


class Recorder(unittest.TextTestResult):
    """A result that keeps each test as a case; a failed subtest fails its test."""

    def __init__(self, *arguments: Any, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self.cases: list[junit.Case] = []
        self._started = 0.0
        self._trouble: list[str] = []
        self._skipped: str | None = None

    def startTest(self, test: unittest.TestCase) -> None:
        super().startTest(test)
        self._started, self._trouble, self._skipped = time.monotonic(), [], None

    def stopTest(self, test: unittest.TestCase) -> None:
        super().stopTest(test)
        seconds = time.monotonic() - self._started
        group, name = test.id().rpartition(".")[::2]
        failure = "\n".join(self._trouble) or None
        self.cases.append(junit.Case(name, group, seconds, failure, None if failure else self._skipped))

    def addError(self, test: unittest.TestCase, err: _ExcInfo) -> None:
        super().addError(test, err)
        self._trouble.append(_text(err))
        if type(test).__name__ == "_ErrorHolder":  # setUpClass or a module failed: no test was begun
            self.cases.append(junit.Case(str(test), "setup", failure=self._trouble[-1]))

    def addFailure(self, test: unittest.TestCase, err: _ExcInfo) -> None:
        super().addFailure(test, err)
        self._trouble.append(_text(err))

    def addSubTest(self, test: unittest.TestCase, subtest: unittest.TestCase, err: _ExcInfo | None) -> None:
        super().addSubTest(test, subtest, err)
        if err is not None:
            self._trouble.append(f"{subtest}\n{_text(err)}")

    def addUnexpectedSuccess(self, test: unittest.TestCase) -> None:
        super().addUnexpectedSuccess(test)
        self._trouble.append("passed although it is marked as an expected failure")

    def addSkip(self, test: unittest.TestCase, reason: str) -> None:
        super().addSkip(test, reason)
        self._skipped = reason


def _text(error: _ExcInfo) -> str:
    return "".join(traceback.format_exception(error[1])) if error[1] else "failed"


def main(test_file: Path, out: Path) -> int:
    """Runs the tests; returns 0 when all passed."""
    sys.path.insert(0, str(test_file.parent))
    suite = unittest.defaultTestLoader.loadTestsFromName(test_file.stem)
    result = unittest.TextTestRunner(verbosity=2, resultclass=Recorder).run(suite)
    assert isinstance(result, Recorder)
    junit.write(out, test_file.stem, result.cases)
    return 0 if result.wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve(), Path(sys.argv[2])))
