# SPDX-License-Identifier: MIT
"""A headset that a script wears: Monado with its driver "remote", which takes head and hands from a TCP port.

    with SimulatedHeadset(monado.find(godot)) as headset:
        subprocess.run([godot.executable, "--xr-mode", "on", ...], env=os.environ | headset.environment())

tools/xr/remote.py moves it. Whoever runs in environment() may kill and restart the service, as when a real runtime
crashes: "$BLACKHOLE_HEADSET_CONTROL" kill|start
"""

from __future__ import annotations

import json
import os
import shlex
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path
from types import TracebackType

from setup import headset_control, process
from setup.console import Failure, tail
from setup.monado import Monado

_PATIENCE_S = 30.0
_LISTENS = "Listening on port"


class SimulatedHeadset:
    """The running service in a folder of its own; leaving the context ends it and removes the folder."""

    def __init__(self, monado: Monado, patience_s: float = _PATIENCE_S) -> None:
        self._monado = monado
        self._patience_s = patience_s
        self._guard = threading.RLock()
        self._service: subprocess.Popen[bytes] | None = None
        self._control: headset_control.Control | None = None
        self.folder: Path  # from entering on
        self.port = 0

    def __enter__(self) -> SimulatedHeadset:
        # Not in $TMPDIR: the path of a socket has 107 characters at most.
        self.folder = Path(tempfile.mkdtemp(prefix="headset-", dir="/tmp"))
        try:
            self.port = _free_port()
            self._write_config()
            self._open_control()
            self.start()
        except BaseException:
            self._close()
            raise
        return self

    def __exit__(
        self, _kind: type[BaseException] | None, _error: BaseException | None, _trace: TracebackType | None
    ) -> None:
        self._close()

    @property
    def log(self) -> Path:
        """What the service prints; goes with the folder."""
        return self.folder / "service.log"

    @property
    def running(self) -> bool:
        """True while the service lives."""
        return self._service is not None and self._service.poll() is None

    def environment(self) -> dict[str, str]:
        """The variables that make a program use this headset."""
        values = {
            "XR_RUNTIME_JSON": str(self._monado.manifest),
            "XDG_RUNTIME_DIR": str(self.folder),
            "BLACKHOLE_HEADSET_PORT": str(self.port),
            "BLACKHOLE_HEADSET_CONTROL": str(self.folder / "headset-control"),
        }
        screen, session = os.environ.get("WAYLAND_DISPLAY"), os.environ.get("XDG_RUNTIME_DIR")
        if screen and session:  # a name alone would be looked for in the new XDG_RUNTIME_DIR
            values["WAYLAND_DISPLAY"] = str(Path(session) / screen)
        return values

    def start(self) -> None:
        """Starts the service and waits until it is ready; a Failure with the end of its log when it is not."""
        with self._guard:
            if self.running:
                return
            self._socket.unlink(missing_ok=True)  # of one that was killed
            before = self.log.stat().st_size if self.log.exists() else 0
            with self.log.open("ab") as sink:
                self._service = subprocess.Popen(
                    self._command(), env=self._service_environment(), cwd=self.folder,
                    stdin=subprocess.DEVNULL, stdout=sink, stderr=subprocess.STDOUT, start_new_session=True,
                )
            try:
                self._wait_until_ready(self._service, before)
            except BaseException:
                self.kill()
                raise

    def kill(self) -> None:
        """Ends the service with its children at once, as in a crash."""
        with self._guard:
            if self._service is None:
                return
            try:
                os.killpg(self._service.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            self._service.wait()
            self._service = None

    @property
    def _socket(self) -> Path:
        return self.folder / "monado_comp_ipc"

    def _command(self) -> list[str]:
        """The service; the kernel ends it should this process be ended without a word."""
        bound = ["setpriv", "--pdeathsig", "KILL", "--"] if shutil.which("setpriv") else []
        return [*bound, str(self._monado.service)]

    def _service_environment(self) -> dict[str, str]:
        own = {"XDG_RUNTIME_DIR": str(self.folder), "XDG_CONFIG_HOME": str(self.folder)}
        return os.environ | own | {"XRT_COMPOSITOR_NULL": "1", "XRT_NO_STDIN": "1"}

    def _write_config(self) -> None:
        config = {"active": "remote", "remote": {"version": 0, "port": self.port, "view_count": 2}}
        file = self.folder / "monado" / "config_v0.json"
        file.parent.mkdir()
        file.write_text(json.dumps(config), encoding="utf-8")

    def _open_control(self) -> None:
        address = self.folder / "control"
        self._control = headset_control.Control(address, {"kill": self.kill, "start": self.start})
        command = [sys.executable, "-I", str(Path(headset_control.__file__).resolve()), str(address)]
        script = self.folder / "headset-control"
        script.write_text(f'#!/bin/sh\nexec {shlex.join(command)} "$@"\n', encoding="utf-8")
        script.chmod(0o700)

    def _wait_until_ready(self, service: subprocess.Popen[bytes], before: int) -> None:
        deadline = time.monotonic() + self._patience_s
        while time.monotonic() < deadline and service.poll() is None:
            if self._socket.is_socket() and _LISTENS.encode() in self.log.read_bytes()[before:]:
                return
            time.sleep(0.05)
        state = f"was not ready after {self._patience_s:.0f} s"
        if service.poll() is not None:
            state = f"ended with status {service.poll()}"
        raise Failure(f"Monado's service {state}. The end of what it printed:\n{tail(self.log)}")

    def _close(self) -> None:
        if self._control:
            self._control.close()
            self._control = None
        with self._guard:
            if self._service:
                process.end_group(self._service)
            self.kill()  # what it left behind
        shutil.rmtree(self.folder, ignore_errors=True)


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("", 0))
        return int(probe.getsockname()[1])
