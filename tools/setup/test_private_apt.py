# SPDX-License-Identifier: MIT
import unittest

from setup.private_apt import installed_names

_SIMULATED = """NOTE: This is only a simulation!
Reading package lists...
Inst gcc-16-base (16-20260315-1 Debian:forky [amd64])
Inst libc6:amd64 (2.42-13 Debian:forky [amd64]) []
Inst libasound2t64 (1:1.2.15-1 Debian:forky [amd64])
Conf libc6 (2.42-13 Debian:forky [amd64])
"""


class InstalledNames(unittest.TestCase):
    def test_names_as_the_files_have_them_in_the_order_of_unpacking(self) -> None:
        self.assertEqual(
            installed_names(_SIMULATED),
            ["gcc-16-base_16-20260315-1", "libc6_2.42-13", "libasound2t64_1%3a1.2.15-1"],
        )
