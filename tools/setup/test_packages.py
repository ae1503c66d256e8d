# SPDX-License-Identifier: MIT
import os
import shutil
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from setup import packages
from setup.console import Failure


@unittest.skipUnless(shutil.which("dpkg-query"), "not a Debian system")
class Packages(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        target = mock.patch("setup.paths.STAMPS", Path(holder.name))
        target.start()
        self.addCleanup(target.stop)

    def test_missing(self) -> None:
        self.assertEqual(packages.missing_packages(["dpkg", "no-such-package"]), ["no-such-package"])

    def test_a_user_without_rights_is_told_the_command(self) -> None:
        with mock.patch.object(packages, "may_install", return_value=None):
            with self.assertRaisesRegex(Failure, "sudo apt-get install no-such-package"):
                packages.ensure(["dpkg", "no-such-package"])

    def test_what_is_there_is_asked_for_once(self) -> None:
        packages.ensure(["dpkg"])
        with mock.patch.object(packages, "missing_packages", side_effect=AssertionError("asked again")):
            packages.ensure(["dpkg"])

    def test_nobody_installs_without_sudo(self) -> None:
        with mock.patch.object(os, "geteuid", return_value=1000):
            with mock.patch("setup.process.capture", return_value=None):
                self.assertIsNone(packages.may_install())
            with mock.patch("setup.process.capture", return_value=""):
                self.assertEqual(packages.may_install(), ["sudo", "-n"])
