# SPDX-License-Identifier: MIT
"""Movies, with a stand-in for ffmpeg: which encoder is taken, what is said, what is left when it fails."""

import os
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from setup import movie
from setup.console import Failure

_STAND_IN = """#!{python}
import sys
folder = {folder!r}
listed, broken = {listed!r}, {broken!r}
if "-encoders" in sys.argv:
    print("Encoders:\\n V..... = Video\\n ------")
    for name in listed:
        print(f" V....D {{name:<20}} the encoder {{name}}\\n A....D {{name}}_of_sound   sound")
    sys.exit(0)
with open(folder + "/calls", "a") as calls:
    print("\\t".join(sys.argv[1:]), file=calls)
with open(sys.argv[-1], "w") as out:
    out.write("movie")
sys.exit(1 if sys.argv[sys.argv.index("-c:v") + 1] in broken else 0)
"""


class Movie(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)
        self.bin = self.folder / "bin"
        self.bin.mkdir()
        self.pattern = self.folder / "ride%.frames" / "frame_%04d.png"
        for patch in (
            mock.patch.dict(os.environ, {"PATH": str(self.bin)}), mock.patch("setup.paths.LOGS", self.folder / "logs"),
        ):
            patch.start()
            self.addCleanup(patch.stop)

    def _ffmpeg(self, *listed: str, broken: tuple[str, ...] = ()) -> None:
        script = _STAND_IN.format(python=sys.executable, folder=str(self.folder), listed=listed, broken=broken)
        (self.bin / "ffmpeg").write_text(script, encoding="utf-8")
        (self.bin / "ffmpeg").chmod(0o755)

    def _calls(self) -> list[list[str]]:
        text = (self.folder / "calls").read_text(encoding="utf-8")
        return [line.split("\t") for line in text.splitlines()]

    def _write(self, name: str) -> str:
        """Writes a movie and returns what was said."""
        with mock.patch("setup.movie.say"), mock.patch("setup.movie.note") as note:
            movie.write(self.pattern, 23.976, self.folder / name)
        return " ".join(call.args[0] for call in note.call_args_list)

    def test_without_ffmpeg_the_remedy_is_named(self) -> None:
        with self.assertRaisesRegex(Failure, r"ride\.mp4: a movie takes ffmpeg.*folder.*ride/"):
            movie.encoders(Path("ride.mp4"))

    def test_without_an_encoder_those_that_would_do_are_named(self) -> None:
        self._ffmpeg("mjpeg", "libx264")
        with self.assertRaisesRegex(Failure, r"libvpx-vp9, libvpx, libaom-av1.*folder"):
            movie.encoders(Path("ride.webm"))

    def test_the_best_encoder_there_is(self) -> None:
        self._ffmpeg("mpeg4", "libx264", "libvpx-vp9", "mjpeg")
        for name, encoder in (("a.mp4", "libx264"), ("b.WEBM", "libvpx-vp9"), ("c.avi", "mjpeg")):
            self.assertEqual(self._write(name), "")
            self.assertEqual((self.folder / name).read_text(encoding="utf-8"), "movie")
            call = self._calls()[-1]
            self.assertEqual(call[call.index("-c:v") + 1], encoder)

    def test_frames_and_rate_are_the_sequences(self) -> None:
        self._ffmpeg("libx264")
        self._write("a.mp4")
        call = self._calls()[0]
        self.assertEqual(call[call.index("-framerate") + 1], "23.976")
        self.assertEqual(call[call.index("-i") + 1], f"{self.folder}/ride%%.frames/frame_%04d.png")

    def test_another_encoder_is_named(self) -> None:
        self._ffmpeg("mpeg4")
        self.assertEqual(self._write("a.mp4"), "with the encoder mpeg4: this ffmpeg has no libx264")

    def test_when_one_fails_the_next_has_a_go(self) -> None:
        self._ffmpeg("libx264", "mpeg4", broken=("libx264",))
        self.assertEqual(self._write("a.mp4"), "with the encoder mpeg4: libx264 failed")
        self.assertTrue((self.folder / "a.mp4").is_file())

    def test_when_all_fail_nothing_half_is_left(self) -> None:
        self._ffmpeg("libx264", "mpeg4", broken=("libx264", "mpeg4"))
        with self.assertRaisesRegex(Failure, r"failed with libx264, mpeg4.*the frames are in"):
            self._write("a.mp4")
        self.assertEqual(list(self.folder.glob("*a*.mp4")) + list(self.folder.glob(".a*")), [])
