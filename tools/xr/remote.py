#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Moves the simulated headset of `./run xr --simulated`: head, hands, buttons. What is not named stays as it is.

examples:
  remote.py --port 4242 --head 0,1.6,0.5 --yaw 30
  remote.py --trigger right 1 --stick left 0,1
  remote.py --script walk.txt        each line holds such options; # begins a remark; - reads standard input

Positions are metres in the play area: x right, y up, z backwards. Angles are degrees: yaw to the left, pitch up, roll
to the left. The service takes one client at a time.
"""

from __future__ import annotations

import argparse
import math
import os
import re
import shlex
import socket
import struct
import sys
import time
from collections.abc import Iterable
from dataclasses import dataclass, field

Vector = tuple[float, float, float]
Rotation = tuple[float, float, float, float]  # x y z w

BUTTONS = (
    "system", "system_touch", "a", "a_touch", "b", "b_touch", "trigger_click", "trigger_touch", "stick_click",
    "stick_touch", "trackpad_touch",
)
_HEADER = b"mndrmt3\0"
# Little endian. Pose: rotation x y z w, position x y z.
_HEAD = struct.Struct("<8s96s7f?3x")  # header, what each eye sees (kept as it comes), pose, are the eyes' data used
_CONTROLLER = struct.Struct("<7f 3f 3f 5f 3f 2f f 2f 13? 3x")
SIZE = _HEAD.size + 2 * _CONTROLLER.size


class RemoteError(Exception):
    """What was asked for cannot be done; the text says why."""


@dataclass
class Controller:
    """One hand."""

    rotation: Rotation = (0.0, 0.0, 0.0, 1.0)
    position: Vector = (0.0, 1.3, -0.5)
    velocity: Vector = (0.0, 0.0, 0.0)
    spin: Vector = (0.0, 0.0, 0.0)
    curl: tuple[float, ...] = (0.0,) * 5
    trigger: float = 0.0
    grip: float = 0.0
    grip_force: float = 0.0
    stick: tuple[float, float] = (0.0, 0.0)
    trackpad_force: float = 0.0
    trackpad: tuple[float, float] = (0.0, 0.0)
    hand_tracking: bool = False
    active: bool = True
    pressed: set[str] = field(default_factory=set)  # of BUTTONS

    def pack(self) -> bytes:
        """The bytes of the driver's struct."""
        return _CONTROLLER.pack(
            *self.rotation, *self.position, *self.velocity, *self.spin, *self.curl, self.trigger, self.grip,
            self.grip_force, *self.stick, self.trackpad_force, *self.trackpad, self.hand_tracking, self.active,
            *(button in self.pressed for button in BUTTONS),
        )

    @staticmethod
    def unpack(data: bytes) -> Controller:
        """The hand in such bytes."""
        v = _CONTROLLER.unpack(data)
        pressed = {button for button, down in zip(BUTTONS, v[28:], strict=True) if down}
        return Controller(
            v[0:4], v[4:7], v[7:10], v[10:13], v[13:18], v[18], v[19], v[20], v[21:23], v[23], v[24:26], v[26], v[27],
            pressed,
        )


@dataclass
class State:
    """Head and hands: all that the driver is told."""

    rotation: Rotation = (0.0, 0.0, 0.0, 1.0)
    position: Vector = (0.0, 1.6, 0.0)
    left: Controller = field(default_factory=lambda: Controller(position=(-0.2, 1.3, -0.5)))
    right: Controller = field(default_factory=lambda: Controller(position=(0.2, 1.3, -0.5)))
    eyes: bytes = bytes(96)
    eyes_used: bool = False

    def pack(self) -> bytes:
        """The bytes of the driver's struct."""
        head = _HEAD.pack(_HEADER, self.eyes, *self.rotation, *self.position, self.eyes_used)
        return head + self.left.pack() + self.right.pack()

    @staticmethod
    def unpack(data: bytes) -> State:
        """The state in such bytes; RemoteError when they are of another version of the driver."""
        header, eyes, *pose, eyes_used = _HEAD.unpack(data[:_HEAD.size])
        if header != _HEADER:
            raise RemoteError(f"this Monado speaks {header!r}, not {_HEADER!r}: take another version of it")
        left = Controller.unpack(data[_HEAD.size:-_CONTROLLER.size])
        right = Controller.unpack(data[-_CONTROLLER.size:])
        return State(tuple(pose[:4]), tuple(pose[4:]), left, right, eyes, eyes_used)

    def hand(self, side: str) -> Controller:
        """The left or the right one."""
        return {"left": self.left, "right": self.right}[side]


class Remote:
    """The line to the driver. `state` starts as what it is now and counts once it is sent."""

    def __init__(self, port: int, host: str = "127.0.0.1", timeout_s: float = 5.0) -> None:
        try:
            self._line = socket.create_connection((host, port), timeout_s)
        except OSError as error:
            raise _no_answer(port, error) from error
        try:
            self._line.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            hello = self._receive(2 * SIZE)
        except OSError as error:
            self._line.close()
            raise _no_answer(port, error) from error
        self.first = State.unpack(hello[:SIZE])
        self.state = State.unpack(hello[SIZE:])

    def __enter__(self) -> Remote:
        return self

    def __exit__(self, *_reason: object) -> None:
        self.close()

    def send(self) -> None:
        """Makes `state` the state of the headset."""
        try:
            self._line.sendall(self.state.pack())
        except OSError as error:
            raise RemoteError(f"the headset is gone: {error.strerror or error}") from error

    def close(self) -> None:
        """Hangs up; the headset stays as it is."""
        self._line.close()

    def _receive(self, size: int) -> bytes:
        data = b""
        while len(data) < size:
            piece = self._line.recv(size - len(data))
            if not piece:
                raise OSError("it hung up; is another client connected?")
            data += piece
        return data


def _no_answer(port: int, error: OSError) -> RemoteError:
    return RemoteError(f"no headset answers at port {port}: {error.strerror or error}")


def rotation(yaw: float, pitch: float = 0.0, roll: float = 0.0) -> Rotation:
    """Turned by these degrees: roll first, then pitch, then yaw, as a neck does."""
    (sy, cy), (sp, cp), (sr, cr) = (
        (math.sin(half), math.cos(half)) for half in (math.radians(angle) / 2 for angle in (yaw, pitch, roll))
    )
    return (
        cy * sp * cr + sy * cp * sr,
        sy * cp * cr - cy * sp * sr,
        cy * cp * sr - sy * sp * cr,
        cy * cp * cr + sy * sp * sr,
    )


def apply(options: argparse.Namespace, state: State, first: State) -> State:
    """The state with the options' changes."""
    if options.reset:
        state = State.unpack(first.pack())
    if options.head:
        state.position = _numbers(options.head, 3)
    angles = (options.yaw, options.pitch, options.roll)
    if any(angle is not None for angle in angles):
        state.rotation = rotation(*(angle or 0.0 for angle in angles))
    for side, text in options.hand:
        state.hand(side).position = _numbers(text, 3)
    for side, text in options.aim:
        state.hand(side).rotation = rotation(*_numbers(text, 2))
    for side, text in options.trigger:
        state.hand(side).trigger = _numbers(text, 1)[0]
    for side, text in options.grip:
        state.hand(side).grip = state.hand(side).grip_force = _numbers(text, 1)[0]
    for side, text in options.stick:
        state.hand(side).stick = _numbers(text, 2)
    for side, button in options.press:
        state.hand(side).pressed.add(_button(button))
    for side, button in options.release:
        state.hand(side).pressed.discard(_button(button))
    for side in options.lose:
        state.hand(side).active = False
    for side in options.regain:
        state.hand(side).active = True
    return state


def parse(words: list[str]) -> argparse.Namespace:
    """The options; wrong ones end the program with 2."""
    parser = _parser()
    # A list of numbers that starts with a minus is no option: a blank tells argparse so.
    options = parser.parse_args([" " + word if re.match(r"-[\d.]", word) else word for word in words])
    for name in ("hand", "aim", "trigger", "grip", "stick", "press", "release"):
        for side, _ in getattr(options, name):
            if side not in ("left", "right"):
                parser.error(f"--{name} takes left or right first, not '{side}'")
    try:
        apply(options, State(), State())
    except RemoteError as error:
        parser.error(str(error))
    return options


def run(remote: Remote, options: argparse.Namespace) -> None:
    """Does what one line of options says."""
    remote.state = apply(options, remote.state, remote.first)
    remote.send()
    time.sleep(options.wait)


def main(words: list[str]) -> int:
    """The command line; 1 when there is no headset."""
    options = parse(words)
    try:
        with Remote(options.port) as remote:
            run(remote, options)
            if options.script:
                for line in _lines(options.script):
                    run(remote, parse(line))
    except (RemoteError, OSError) as error:
        print(f"remote: {error}", file=sys.stderr)
        return 1
    return 0


def _parser() -> argparse.ArgumentParser:
    port = os.environ.get("BLACKHOLE_HEADSET_PORT", "")
    parser = argparse.ArgumentParser(
        prog="remote.py", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter, allow_abbrev=False
    )
    parser.add_argument("--port", type=int, default=port or 4242, help="default: $BLACKHOLE_HEADSET_PORT, else 4242")
    parser.add_argument("--reset", action="store_true", help="all as at the start of the service, before the rest")
    parser.add_argument("--head", metavar="X,Y,Z", help="where the head is")
    for name in ("yaw", "pitch", "roll"):
        parser.add_argument(f"--{name}", type=float, metavar="DEGREES", help="of the head; those not named become 0")
    for name, value, text in (
        ("hand", "X,Y,Z", "where a hand is"),
        ("aim", "YAW,PITCH", "where a hand points"),
        ("trigger", "VALUE", "0 to 1"),
        ("grip", "VALUE", "0 to 1"),
        ("stick", "X,Y", "-1 to 1, to the right and forwards"),
        ("press", "BUTTON", ", ".join(BUTTONS)),
        ("release", "BUTTON", "the same"),
    ):
        parser.add_argument(f"--{name}", nargs=2, action="append", default=[], metavar=("SIDE", value), help=text)
    for name, text in (("lose", "switches a controller off"), ("regain", "switches it on again")):
        parser.add_argument(f"--{name}", choices=("left", "right"), action="append", default=[], help=text)
    parser.add_argument("--wait", type=float, default=0.0, metavar="SECONDS", help="stay connected so long afterwards")
    parser.add_argument("--script", metavar="FILE", help="more lines of such options")
    return parser


def _numbers(text: str, count: int) -> tuple[float, ...]:
    try:
        values = tuple(float(part) for part in text.split(","))
    except ValueError:
        values = ()
    if len(values) != count or not all(math.isfinite(value) for value in values):
        raise RemoteError(f"'{text.strip()}' should be {count} number(s), with commas between them")
    return values


def _button(name: str) -> str:
    if name not in BUTTONS:
        raise RemoteError(f"there is no button '{name}', but: {', '.join(BUTTONS)}")
    return name


def _lines(name: str) -> Iterable[list[str]]:
    source = sys.stdin if name == "-" else open(name, encoding="utf-8")
    with source:
        for line in source:
            words = shlex.split(line, comments=True)
            if words:
                yield words


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
