# SPDX-License-Identifier: MIT
"""Lets another program, such as a test inside Godot, kill and restart the service of a simulated headset.

The one who keeps the headset runs a Control; this file is also the other end: headset_control.py SOCKET kill|start
"""

from __future__ import annotations

import socket
import socketserver
import sys
import threading
from collections.abc import Callable, Mapping
from pathlib import Path

_DONE = "done"


class Control:
    """Waits at a Unix socket for words and does what they stand for, one at a time."""

    def __init__(self, address: Path, actions: Mapping[str, Callable[[], None]]) -> None:
        class Handler(socketserver.StreamRequestHandler):
            def handle(self) -> None:
                word = self.rfile.readline().decode(errors="replace").strip()
                self.wfile.write(_answer(word, actions).encode())

        self._server = socketserver.UnixStreamServer(str(address), Handler)
        # One thread for all requests: what it starts is bound to end with it.
        self._thread = threading.Thread(target=self._server.serve_forever, args=(0.1,), daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Ends the waiting, after what is being done."""
        self._server.shutdown()
        self._thread.join()
        self._server.server_close()


def _answer(word: str, actions: Mapping[str, Callable[[], None]]) -> str:
    if word not in actions:
        return f"there is no '{word}'; say one of: {', '.join(actions)}"
    try:
        actions[word]()
    except Exception as error:  # whatever it is, the one who asked must hear of it
        return str(error) or type(error).__name__
    return _DONE


def ask(address: str, word: str) -> str:
    """Says a word at the socket; the answer, empty when it was done."""
    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as line:
        line.connect(address)
        line.sendall(f"{word}\n".encode())
        with line.makefile(encoding="utf-8", errors="replace") as reader:
            answer = reader.read()
    return "" if answer == _DONE else answer or "no answer"


def main(arguments: list[str]) -> int:
    """The other end: 0 when the word was done, else 1 and the reason."""
    if len(arguments) != 2:
        print("usage: headset_control.py SOCKET kill|start", file=sys.stderr)
        return 2
    try:
        wrong = ask(*arguments)
    except OSError as error:
        wrong = f"the headset at {arguments[0]} does not answer: {error.strerror}"
    if wrong:
        print(f"headset-control: {wrong}", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
