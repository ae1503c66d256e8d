# SPDX-License-Identifier: MIT
import contextlib
import io
import subprocess
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from setup import private_packages, stamps
from setup.console import Failure
from setup.private_apt import PrivateApt


class Offers(unittest.TestCase):
    def _offer(self, versions: dict[str, str | None], archives: tuple[str, ...] = ("http://near.example/",),
               listed: bool = True) -> private_packages.Offer:
        """What is offered when the suites have these versions, of which those with a 2 are enough."""
        def candidate(apt: PrivateApt, _package: str) -> str | None:
            return versions.get(apt.suite)

        with mock.patch.object(private_packages.archive, "candidates", return_value=list(archives)), \
                mock.patch.object(PrivateApt, "update", return_value=listed), \
                mock.patch.object(PrivateApt, "candidate", candidate):
            return private_packages.offer(
                "tool", lambda version: version.startswith("2"), Path("/cache"), Path("/cache/log"), "There is no tool",
                "Make one.",
            )

    def test_the_first_suite_that_has_enough(self) -> None:
        self.assertEqual(self._offer({"forky": "2.1", "sid": "2.2"}).version, "2.1")
        offer = self._offer({"forky": "1.9", "sid": "2.2"})
        self.assertEqual((offer.version, offer.apt.suite), ("2.2", "sid"))

    def test_none_names_what_was_seen_and_the_remedy(self) -> None:
        seen = r"There is no tool(.|\n)*forky: 1\.9\n.*sid: no tool(.|\n)*Make one\."
        with self.assertRaisesRegex(Failure, seen) as caught:
            self._offer({"forky": "1.9"})
        self.assertEqual(caught.exception.code, 3)

    def test_without_a_network(self) -> None:
        with self.assertRaisesRegex(Failure, "forky: its package lists could not be fetched"):
            self._offer({}, listed=False)

    def test_without_an_archive(self) -> None:
        with self.assertRaisesRegex(Failure, r"names no Debian archive(.|\n)*Make one\."):
            self._offer({}, archives=())


class Copies(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)

    def test_complete_are_those_with_the_right_stamp(self) -> None:
        for version, stamp in (("1.0", "right"), ("1.1", "wrong"), ("2.0", "right")):
            stamps.write(self.folder / f"tool-{version}" / "stamp", stamp)
        (self.folder / "tool-3.0").mkdir()
        found = private_packages.complete(self.folder, "tool", lambda _folder: "right")
        self.assertEqual(dict(found), {version: self.folder / f"tool-{version}" for version in ("1.0", "2.0")})

    def test_unpacking_into_a_folder_that_held_other_things(self) -> None:
        made = self.folder / "made"
        (made / "DEBIAN").mkdir(parents=True)
        (made / "usr").mkdir()
        (made / "usr" / "tool").touch()
        control = "Package: tool\nVersion: 1\nArchitecture: all\nMaintainer: A <a@b.c>\nDescription: a tool\n"
        (made / "DEBIAN" / "control").write_text(control, encoding="utf-8")
        package = self.folder / "tool.deb"
        subprocess.run(["dpkg-deb", "--build", made, package], check=True, stdout=subprocess.DEVNULL)
        root = self.folder / "root"
        root.mkdir()
        (root / "old").touch()
        with contextlib.redirect_stderr(io.StringIO()):
            private_packages.unpack([package], root, self.folder / "log")
        self.assertEqual([path.name for path in root.rglob("*")], ["usr", "tool"])


if __name__ == "__main__":
    unittest.main()
