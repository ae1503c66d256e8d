# SPDX-License-Identifier: MIT
"""What the engine complains of in what it prints."""

from __future__ import annotations

import re

_COMPLAINT = re.compile(r"^\s*(?:USER |SCRIPT |SHADER )?(?:ERROR|WARNING): .*", re.MULTILINE)
# Of a machine without sound, session or card, and none of the project's.
_OF_THE_MACHINE = re.compile(r"dbus|D-Bus|ALSA|PulseAudio|udev|XOpenIM|XIM|libdecor|Blocking in swap chain|V-Sync mode")


def complaints(printed: str) -> list[str]:
    """The errors and warnings, without those that tell of the machine."""
    return [line.strip() for line in _COMPLAINT.findall(printed) if not _OF_THE_MACHINE.search(line)]
