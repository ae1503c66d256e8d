# SPDX-License-Identifier: MIT
import tempfile
import unittest
from pathlib import Path

from setup import frames


class Names(unittest.TestCase):
    def test_a_slash_at_the_end_means_a_folder_of_frames(self) -> None:
        base = Path("/here")
        self.assertEqual(frames.named(base, "film/"), Path("/here/film/frame_%04d.png"))
        self.assertEqual(frames.named(base, "/there/film/"), Path("/there/film/frame_%04d.png"))
        self.assertEqual(frames.named(base, "film.png"), Path("/here/film.png"))

    def test_frames_of_a_pattern(self) -> None:
        for pattern, number, name in (
            ("/a/frame_%04d.png", 12, "/a/frame_0012.png"), ("/a/f%d.exr", 12, "/a/f12.exr"),
            ("/a/f%2d.png", 3, "/a/f03.png"), ("/a%d/f%03d.png", 1234, "/a%d/f1234.png"), ("/a/still.png", 0, "/a/still.png"),
        ):
            with self.subTest(pattern):
                self.assertEqual(frames.file(Path(pattern), number), Path(name))

    def test_the_frames_of_a_movie_are_beside_it(self) -> None:
        for ending in (".mp4", ".WEBM", ".avi"):
            movie = Path("/a/ride" + ending)
            self.assertTrue(frames.is_movie(movie))
            self.assertEqual(frames.drawn(movie), Path(f"/a/ride{ending}.frames/frame_%04d.png"))
            self.assertEqual(frames.first(movie).name, "frame_0000.png")
        self.assertFalse(frames.is_movie(Path("/a/ride.png")))
        self.assertEqual(frames.drawn(Path("/a/ride.png")), Path("/a/ride.png"))


class Files(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name) / "film"
        self.folder.mkdir()
        self.pattern = self.folder / "frame_%04d.png"

    def _touch(self, *names: str) -> None:
        for name in names:
            (self.folder / name).touch()

    def test_frames_in_a_row_are_written(self) -> None:
        self.assertEqual(frames.written(self.pattern), [])
        self._touch("frame_0000.png", "frame_0001.png", "frame_0003.png")
        self.assertEqual([path.name for path in frames.written(self.pattern)], ["frame_0000.png", "frame_0001.png"])
        self.assertEqual(len(frames.written(self.folder / "frame_0003.png")), 1)

    def test_removed_are_frames_alone_and_the_empty_folder(self) -> None:
        self._touch("frame_0000.png", "frame_0007.png", "frame_12345.png", "frame_0001.png.part", "frame_a.png", "mine.txt")
        frames.remove(self.pattern)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["frame_a.png", "mine.txt"])
        for path in self.folder.iterdir():
            path.unlink()
        frames.remove(self.pattern)
        self.assertFalse(self.folder.exists())
        frames.remove(self.pattern)

    def test_half_a_frame_goes_and_whole_ones_stay(self) -> None:
        self._touch("frame_0000.png", "frame_0001.png.part", "other.png.part")
        frames.remove_half_written(self.pattern)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["frame_0000.png", "other.png.part"])

    def test_a_still_has_no_frames_to_remove(self) -> None:
        self._touch("still.png")
        frames.remove(self.folder / "still.png")
        self.assertTrue((self.folder / "still.png").exists())
