# SPDX-License-Identifier: MIT
import os
import unittest
from unittest import mock

from setup import archive

_MAIN = "http://archive.example/debian/"


def _line(origin: str, label: str, codename: str, address: str) -> str:
    return "\t".join((origin, label, codename, address))


class Addresses(unittest.TestCase):
    def test_takes_debian_alone_among_third_parties(self) -> None:
        listed = "\n".join([
            _line("Node Source", "Node Source", "nodistro", "https://node.example/"),
            _line("Debian", "Debian-Security", "bookworm-security", "http://archive.example/debian-security/"),
            _line("Debian", "Debian", "bookworm", _MAIN),
            _line("Debian", "Debian", "bookworm-updates", _MAIN),
        ])
        self.assertEqual(archive.known(listed), [_MAIN])

    def test_another_distribution_has_none(self) -> None:
        self.assertEqual(archive.known(_line("Ubuntu", "Ubuntu", "noble", "http://ubuntu.example/")), [])

    def test_without_lists_every_configured_address_is_a_candidate(self) -> None:
        uris = "\n".join([
            "'https://node.example/dists/nodistro/InRelease' node.example_InRelease 0 ",
            "'http://archive.example/debian/dists/bookworm/InRelease' archive_InRelease 0 ",
            "'http://archive.example/debian/dists/bookworm-updates/InRelease' archive_updates_InRelease 0 ",
            "'http://archive.example/debian-security/dists/bookworm-security/InRelease' security_InRelease 0 ",
            "'http://archive.example/debian/dists/bookworm/main/binary-amd64/Packages.xz' archive_Packages 0 ",
        ])
        self.assertEqual(archive.configured(uris), ["https://node.example/", _MAIN])


class Candidates(unittest.TestCase):
    def test_the_variable_overrides(self) -> None:
        with mock.patch.dict(os.environ, {"DEBIAN_MIRROR": "http://near.example/debian"}):
            self.assertEqual(archive.candidates(), ["http://near.example/debian/"])

    def test_none_where_apt_knows_none(self) -> None:
        with mock.patch.dict(os.environ), mock.patch("setup.process.capture", return_value=None):
            os.environ.pop("DEBIAN_MIRROR", None)
            self.assertEqual(archive.candidates(), [])
