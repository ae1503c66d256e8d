# SPDX-License-Identifier: MIT
import unittest
from pathlib import Path
from unittest import mock

from package import import_table
from setup.console import Failure

_PRINTED = """
The Import Tables (interpreted .idata section contents)
 vma:            Hint    Time      Forward  DLL       First
 00001000	00001040 00000000 00000000 00001200 00001100

	DLL Name: KERNEL32.dll
	vma:  Hint/Ord Member-Name Bound-To
	1300	  100  CloseHandle

	DLL Name: {other}

[Ordinal/Name Pointer] Table
	[   0] {function}

The Function Table (interpreted .pdata section contents)
"""


class ImportTable(unittest.TestCase):
    def _check(self, other: str, function: str = "blackhole_sky_init") -> None:
        printed = _PRINTED.format(other=other, function=function)
        with mock.patch.object(import_table.process, "capture", return_value=printed):
            import_table.check(Path("a.dll"))

    def test_windows_own(self) -> None:
        for name in ("msvcrt.dll", "ADVAPI32.dll", "api-ms-win-crt-heap-l1-1-0.dll"):
            self._check(name)

    def test_a_compilers_own(self) -> None:
        for name in ("libstdc++-6.dll", "libwinpthread-1.dll", "zlib1.dll"):
            with self.subTest(name), self.assertRaisesRegex(Failure, f"a.dll needs .*: {name.replace('+', '[+]')}[.]"):
                self._check(name)

    def test_the_entry_and_nothing_else_is_offered(self) -> None:
        for function in ("inflate", "blackhole_sky_init\n\t[   1] inflate"):
            with self.subTest(function), self.assertRaisesRegex(Failure, "a.dll offers .*inflate"):
                self._check("msvcrt.dll", function)

    def test_no_library(self) -> None:
        with mock.patch.object(import_table.process, "capture", return_value=None), \
                self.assertRaisesRegex(Failure, "cannot read a.dll"):
            import_table.check(Path("a.dll"))


if __name__ == "__main__":
    unittest.main()
