#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
import contextlib
import io
import math
import socket
import struct
import sys
import tempfile
import threading
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parent))

import remote  # noqa: E402

_LEFT, _RIGHT = 136, 256  # where the hands begin


def _floats(data: bytes, offset: int, count: int) -> tuple[float, ...]:
    return struct.unpack_from(f"<{count}f", data, offset)


class Packing(unittest.TestCase):
    """The layout of r_remote_data in Monado's src/xrt/drivers/remote/r_interface.h."""

    def test_size_and_header(self) -> None:
        data = remote.State().pack()
        self.assertEqual((len(data), remote.SIZE), (376, 376))
        self.assertEqual(data[:8], b"mndrmt3\0")

    def test_the_head(self) -> None:
        data = remote.State(position=(1.0, 2.0, 4.0), rotation=(0.0, 0.5, 0.0, 0.25), eyes_used=True).pack()
        self.assertEqual(_floats(data, 104, 7), (0.0, 0.5, 0.0, 0.25, 1.0, 2.0, 4.0))
        self.assertEqual(data[132], 1)

    def test_the_fields_of_a_hand(self) -> None:
        state = remote.State()
        state.right.position = (1.0, 2.0, 4.0)
        state.right.trigger, state.right.grip, state.right.grip_force = 0.5, 0.25, 0.125
        state.right.stick = (-1.0, 0.75)
        state.right.trackpad = (0.5, -0.5)
        data = state.pack()
        self.assertEqual(_floats(data, _RIGHT + 16, 3), (1.0, 2.0, 4.0))
        self.assertEqual(_floats(data, _RIGHT + 72, 5), (0.5, 0.25, 0.125, -1.0, 0.75))
        self.assertEqual(_floats(data, _RIGHT + 96, 2), (0.5, -0.5))
        self.assertEqual(data[_RIGHT + 104:_RIGHT + 106], b"\0\1", "no hand tracking, but a controller")
        self.assertEqual(_floats(data, _LEFT + 72, 5), (0.0,) * 5)

    def test_each_button_has_its_byte(self) -> None:
        for number, button in enumerate(remote.BUTTONS):
            with self.subTest(button):
                state = remote.State()
                state.left.pressed.add(button)
                expected = bytes(int(at == number) for at in range(len(remote.BUTTONS)))
                self.assertEqual(state.pack()[_LEFT + 106:_LEFT + 117], expected)

    def test_unpack_is_the_way_back(self) -> None:
        data = bytearray(remote.State().pack())
        data[8:104] = bytes(range(96))
        data[132] = 1
        for hand in (_LEFT, _RIGHT):
            struct.pack_into("<26f", data, hand, *(hand + number for number in range(26)))
            data[hand + 104:hand + 117] = bytes([1, 0] * 6 + [1])
        self.assertEqual(remote.State.unpack(bytes(data)).pack(), bytes(data))

    def test_another_version_of_the_driver(self) -> None:
        with self.assertRaisesRegex(remote.RemoteError, "mndrmt2"):
            remote.State.unpack(b"mndrmt2\0" + bytes(368))


class Rotations(unittest.TestCase):
    def test_about_one_axis(self) -> None:
        half = math.sqrt(0.5)
        for angles, expected in {
            (90.0, 0.0, 0.0): (0.0, half, 0.0, half),
            (0.0, 90.0, 0.0): (half, 0.0, 0.0, half),
            (0.0, 0.0, 90.0): (0.0, 0.0, half, half),
        }.items():
            with self.subTest(angles):
                for found, value in zip(remote.rotation(*angles), expected, strict=True):
                    self.assertAlmostEqual(found, value)

    def test_pitch_is_about_the_turned_axis(self) -> None:
        # Turned left and then looking up: forwards, which was -z, is between -x and y.
        x, y, z, w = remote.rotation(90.0, 45.0)
        forwards = (-2 * (x * z + w * y), -2 * (y * z - w * x), -(1 - 2 * (x * x + y * y)))
        for found, value in zip(forwards, (-math.sqrt(0.5), math.sqrt(0.5), 0.0), strict=True):
            self.assertAlmostEqual(found, value)


class Words(unittest.TestCase):
    def _applied(self, *words: str) -> remote.State:
        first = remote.State(position=(9.0, 9.0, 9.0))
        return remote.apply(remote.parse(list(words)), remote.State(), first)

    def test_what_is_named_changes(self) -> None:
        state = self._applied(
            "--head", "-1,1.5,0", "--yaw", "-90", "--trigger", "right", "1", "--stick", "left", "-.5,1", "--press",
            "right", "a", "--lose", "left", "--hand", "left", "-0.3,1,-0.2", "--grip", "left", "0.5",
        )
        self.assertEqual(state.position, (-1.0, 1.5, 0.0))
        self.assertAlmostEqual(state.rotation[1], -math.sqrt(0.5))
        self.assertEqual((state.right.trigger, state.left.trigger), (1.0, 0.0))
        self.assertEqual(state.left.stick, (-0.5, 1.0))
        self.assertEqual((state.right.pressed, state.left.pressed), ({"a"}, set()))
        self.assertEqual((state.left.active, state.right.active), (False, True))
        self.assertEqual(state.left.position, (-0.3, 1.0, -0.2))
        self.assertEqual((state.left.grip, state.left.grip_force), (0.5, 0.5))

    def test_what_is_not_named_stays(self) -> None:
        self.assertEqual(self._applied("--press", "left", "b", "--release", "left", "b"), remote.State())

    def test_reset_comes_first(self) -> None:
        state = self._applied("--yaw", "10", "--reset")
        self.assertEqual(state.position, (9.0, 9.0, 9.0))
        self.assertGreater(state.rotation[1], 0.0)

    def test_wrong_words(self) -> None:
        for words in (
            ["--head", "1,2"], ["--head", "1,2,x"], ["--head", "1,2,nan"], ["--trigger", "up", "1"],
            ["--press", "left", "c"], ["--lose", "both"], ["--fly"],
        ):
            with self.subTest(words), contextlib.redirect_stderr(io.StringIO()):
                with self.assertRaises(SystemExit) as caught:
                    remote.parse(words)
                self.assertEqual(caught.exception.code, 2)

    def test_the_port_of_the_environment(self) -> None:
        with mock.patch.dict("os.environ", {"BLACKHOLE_HEADSET_PORT": "5000"}):
            self.assertEqual(remote.parse([]).port, 5000)
            self.assertEqual(remote.parse(["--port", "6000"]).port, 6000)


class Line(unittest.TestCase):
    """With a server that stands for the driver: it says what is, then takes what comes."""

    def setUp(self) -> None:
        self.server = socket.create_server(("127.0.0.1", 0))
        self.addCleanup(self.server.close)
        self.port = self.server.getsockname()[1]
        self.came = b""

    def _serve(self, hello: bytes) -> None:
        def serve() -> None:
            line, _ = self.server.accept()
            with line:
                line.sendall(hello)
                while piece := line.recv(4096):
                    self.came += piece

        self.thread = threading.Thread(target=serve)
        self.thread.start()
        self.addCleanup(self.thread.join, 5)

    def _serve_state(self, now: remote.State) -> None:
        self._serve(remote.State().pack() + now.pack())

    def test_begins_with_what_is(self) -> None:
        now = remote.State(position=(0.0, 1.0, 0.0))
        now.left.trigger = 0.5
        self._serve_state(now)
        self.assertEqual(remote.main(["--port", str(self.port), "--yaw", "20"]), 0)
        self.thread.join(5)
        sent = remote.State.unpack(self.came)
        self.assertEqual((sent.position, sent.left.trigger), ((0.0, 1.0, 0.0), 0.5))
        self.assertGreater(sent.rotation[1], 0.0)

    def test_a_script(self) -> None:
        self._serve_state(remote.State())
        with tempfile.TemporaryDirectory() as folder:
            script = Path(folder) / "walk.txt"
            script.write_text("--trigger left 1 --wait 0.01  # pull\n\n--trigger left 0\n", encoding="utf-8")
            self.assertEqual(remote.main(["--port", str(self.port), "--script", str(script)]), 0)
        self.thread.join(5)
        states = [self.came[at:at + remote.SIZE] for at in range(0, len(self.came), remote.SIZE)]
        self.assertEqual([remote.State.unpack(state).left.trigger for state in states], [0.0, 1.0, 0.0])

    def test_nobody_there_and_a_busy_driver(self) -> None:
        with socket.create_server(("127.0.0.1", 0)) as spare:
            nobody = spare.getsockname()[1]
        self._serve(b"")
        for port in (nobody, self.port):
            with self.subTest(port), self.assertRaisesRegex(remote.RemoteError, f"port {port}"):
                remote.Remote(port, timeout_s=0.3)


if __name__ == "__main__":
    unittest.main()
