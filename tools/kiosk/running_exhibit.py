# SPDX-License-Identifier: MIT
"""An exhibit with its supervisor on a screen of its own, for tests, and what it says of itself."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import subprocess
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import IO

from setup import kiosk, paths, process

_SUPERVISED_BY = "--supervised-by="
_ORPHAN_S = 20.0  # the program looks every five seconds whether its supervisor is there


class RunningExhibit:
    """`with RunningExhibit(...)`: it runs; afterwards it does not, and `outlived` tells whether the program had to be
    killed because it did not end when its supervisor had. `exported`: the command of a program to take instead of the
    engine with the project."""

    def __init__(
        self, engine: Path, wish: kiosk.Wish, logs: Path, environment: Mapping[str, str], sink: IO[bytes],
        exported: Sequence[str] = (),
    ) -> None:
        # The screen is to outlive the supervisor, as in a museum.
        screen = ["xvfb-run", "-a", "-s", "-screen 0 640x360x24", "sh", "-c", f'"$@"; sleep {_ORPHAN_S + 5.0:.0f}', "sh"]
        project = [str(engine), "--path", str(paths.ROOT), *kiosk.engine_arguments(wish)]
        self._command = [*screen, *(exported or project)]
        self._environment = environment
        self._sink = sink
        self._logs = logs
        self.outlived = False

    def __enter__(self) -> RunningExhibit:
        self._screen = subprocess.Popen(
            self._command, cwd=paths.ROOT, env=self._environment, stdin=subprocess.DEVNULL, stdout=self._sink,
            stderr=subprocess.STDOUT, start_new_session=True,
        )
        return self

    def __exit__(self, *_: object) -> None:
        self._end_supervisor()
        process.end_group(self._screen)

    def status(self) -> int | None:
        """The supervisor's exit status; None while it runs."""
        return self._screen.poll()

    def beat(self) -> dict[str, object]:
        """The program's last sign of life; empty when there is none yet."""
        try:
            beat = json.loads((self._logs / "heartbeat.json").read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return {}
        return beat if isinstance(beat, dict) else {}

    def pid(self) -> int:
        """The program's process; 0 when it has not told yet."""
        return int(str(self.beat().get("pid", 0)))

    def _end_supervisor(self) -> None:
        """Ends it alone, while the screen is still there: the program then ends by itself."""
        pid = self.pid()
        try:
            words = Path(f"/proc/{pid}/cmdline").read_text(encoding="utf-8").split("\0")
        except OSError:
            return
        for word in words:
            if word.startswith(_SUPERVISED_BY):
                with contextlib.suppress(ProcessLookupError):
                    os.kill(int(word.removeprefix(_SUPERVISED_BY)), signal.SIGTERM)
        deadline = time.monotonic() + _ORPHAN_S
        while time.monotonic() < deadline:
            if megabytes(pid) == 0.0:
                return
            time.sleep(0.2)
        self.outlived = True
        with contextlib.suppress(ProcessLookupError):
            os.kill(pid, signal.SIGKILL)


def megabytes(pid: int) -> float:
    """Resident memory of a process; 0 when there is none."""
    try:
        pages = int(Path(f"/proc/{pid}/statm").read_text(encoding="ascii").split()[1])
    except (OSError, ValueError, IndexError):
        return 0.0
    return pages * os.sysconf("SC_PAGE_SIZE") / 1e6
