# SPDX-License-Identifier: MIT
import subprocess
import tempfile
import unittest
from pathlib import Path

from setup import relocate
from setup.console import Failure

# Stands for the loader, which would run patchelf: keeps what it was called with.
_LOADER = '#!/bin/sh\necho "$@" >> "$(dirname "$0")/calls"\n'


class Relocate(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name) / "a copy"
        self.log = Path(holder.name) / "log"
        self.path = self.folder / "root"
        self.libraries = self.path / "usr/lib/x86_64-linux-gnu"
        (self.libraries / "pulseaudio").mkdir(parents=True)
        (self.path / "usr/bin").mkdir()
        for name in ("libc.so.6", "libpulse.so.0.1", "pulseaudio/libpulsecommon.so"):
            (self.libraries / name).touch()
        (self.libraries / "libpulse.so.0").symlink_to("libpulse.so.0.1")
        self.loader = self.libraries / "ld-linux-x86-64.so.2"
        self.loader.write_text(_LOADER, encoding="utf-8")
        self.loader.chmod(0o755)

    def _calls(self) -> str:
        return (self.libraries / "calls").read_text(encoding="utf-8")

    def test_incomplete_packages(self) -> None:
        self.loader.unlink()
        with self.assertRaisesRegex(Failure, "No program loader"):
            relocate.find_root(self.path)
        (self.libraries / "libc.so.6").unlink()
        with self.assertRaisesRegex(Failure, "No C library"):
            relocate.find_root(self.path)

    def test_libraries_find_each_other(self) -> None:
        relocate.find_root(self.path).gather(self.log)
        self.assertTrue((self.libraries / "libpulsecommon.so").is_symlink())
        self.assertIn(f"--remove-rpath {self.libraries}/libpulse.so.0.1\n", self._calls())
        self.assertNotIn("libpulse.so.0\n", self._calls())

    def test_a_program_gets_loader_and_libraries(self) -> None:
        (self.path / "usr/bin/tool").write_text("tool", encoding="utf-8")
        target = self.folder / "bin" / "tool.bin"
        relocate.find_root(self.path).executable("tool", target, self.log)
        self.assertEqual(target.read_text(encoding="utf-8"), "tool")
        expected = f"--set-interpreter {self.loader} --force-rpath --set-rpath {self.libraries} {target}\n"
        self.assertIn(expected, self._calls())

    def test_a_library_gets_libraries(self) -> None:
        target = self.folder / "lib" / "libpulse.so"
        relocate.find_root(self.path).library(self.libraries / "libpulse.so.0", target, self.log)
        self.assertFalse(target.is_symlink())
        self.assertIn(f"--force-rpath --set-rpath {self.libraries} {target}", self._calls())

    def test_the_starter_sets_the_drivers(self) -> None:
        binary, starter = self.folder / "tool.bin", self.folder / "tool"
        binary.write_text('#!/bin/sh\necho "$LIBGL_DRIVERS_PATH" "$@"\n', encoding="utf-8")
        binary.chmod(0o755)
        relocate.find_root(self.path).starter(starter, binary)
        env = {"PATH": "/usr/bin:/bin"}
        done = subprocess.run([starter, "a b"], env=env, stdout=subprocess.PIPE, text=True, check=True)
        self.assertEqual(done.stdout, f"{self.libraries}/dri a b\n")


if __name__ == "__main__":
    unittest.main()
