# SPDX-License-Identifier: MIT
"""Starting other programs: quietly into a log, with a time limit, without leaving children behind."""

from __future__ import annotations

import os
import signal
import subprocess
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from setup.console import Failure, tail

Command = Sequence[object]  # of str and Path, which a list display mixes


def capture(command: Command, env: Mapping[str, str] | None = None) -> str | None:
    """Standard output of a short command, or None when it fails or does not exist."""
    try:
        done = subprocess.run(
            [str(part) for part in command],
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
            text=True, errors="replace", env=env, timeout=60, check=False,
        )
    except (OSError, subprocess.TimeoutExpired):
        return None
    return done.stdout if done.returncode == 0 else None


def run_logged(
    command: Command,
    log: Path,
    *,
    cwd: Path | None = None,
    env: Mapping[str, str] | None = None,
    timeout_s: float | None = None,
    on_line: Callable[[str], None] | None = None,
    append: bool = False,
) -> int:
    """Runs a command with all its output in `log` and returns its exit status.

    A command that outlives timeout_s is ended with its children and returns 124. on_line sees each line.
    """
    log.parent.mkdir(parents=True, exist_ok=True)
    with log.open("ab" if append else "wb") as sink:
        try:
            child = subprocess.Popen(
                [str(part) for part in command],
                cwd=cwd, env=env, stdin=subprocess.DEVNULL, stderr=subprocess.STDOUT,
                stdout=subprocess.PIPE if on_line else sink, start_new_session=True,
            )
        except OSError as error:
            sink.write(f"{command[0]}: {error.strerror}\n".encode())
            return 127
        try:
            if on_line and child.stdout:
                for raw in child.stdout:
                    sink.write(raw)
                    on_line(raw.decode(errors="replace").rstrip("\n"))
            return _shell_status(child.wait(timeout_s))
        except subprocess.TimeoutExpired:
            sink.write(f"\nended after {timeout_s:.0f} s without an answer\n".encode())
            return 124
        finally:
            end_group(child)


def require(command: Command, log: Path, what: str, **options: object) -> None:
    """run_logged for a step that must work: otherwise a Failure with the end of the log."""
    status = run_logged(command, log, **options)  # type: ignore[arg-type]
    if status != 0:
        raise Failure(f"{what} failed (exit status {status}). The end of {log}:\n{tail(log)}")


def end_group(child: subprocess.Popen[bytes]) -> None:
    """Ends a child that was started in its own session, with what it started."""
    if child.poll() is None:
        for sign in (signal.SIGTERM, signal.SIGKILL):
            try:
                os.killpg(child.pid, sign)
                child.wait(5)
                break
            except subprocess.TimeoutExpired:
                continue
            except ProcessLookupError:
                break
    if child.stdout:
        child.stdout.close()


def _shell_status(status: int) -> int:
    """A death by signal as the shell counts it: 128 + signal."""
    return 128 - status if status < 0 else status
