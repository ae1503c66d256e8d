# SPDX-License-Identifier: MIT
"""Movies from numbered frames, by the machine's own ffmpeg."""

from __future__ import annotations

import os
import re
import shutil
from pathlib import Path

from setup import frames, paths, process
from setup.console import Failure, note, say

_QUALITY = {
    "libx264": ["-crf", "17", "-preset", "medium", "-pix_fmt", "yuv420p"],
    "libopenh264": ["-b:v", "12M", "-pix_fmt", "yuv420p"],
    "mpeg4": ["-q:v", "2", "-pix_fmt", "yuv420p"],
    "libvpx-vp9": ["-crf", "18", "-b:v", "0", "-row-mt", "1", "-pix_fmt", "yuv420p"],
    "libvpx": ["-crf", "8", "-b:v", "20M", "-pix_fmt", "yuv420p"],
    "libaom-av1": ["-crf", "20", "-cpu-used", "6", "-pix_fmt", "yuv420p"],
    "mjpeg": ["-q:v", "2", "-pix_fmt", "yuvj420p"],
}
# Their streams do not say how colours are stored.
_UNTAGGED = ("mpeg4", "libvpx", "mjpeg")
# By ending: the encoders that will do, best first. mpeg4 and mjpeg are ffmpeg's own.
_ENCODERS = {
    ".mp4": ("libx264", "libopenh264", "mpeg4"),
    ".webm": ("libvpx-vp9", "libvpx", "libaom-av1"),
    ".avi": ("mjpeg",),
}


def encoders(out: Path) -> list[str]:
    """The encoders of this machine's ffmpeg for a movie, best first; a Failure when there is none."""
    ending = out.suffix.lower()
    remedy = f"; take a folder for the frames instead ({out.stem}/), or install ffmpeg"
    if shutil.which("ffmpeg") is None:
        raise Failure(f"capture: {out.name}: a movie takes ffmpeg, and there is none here{remedy}")
    listed = process.capture(["ffmpeg", "-hide_banner", "-encoders"]) or ""
    there = set(re.findall(r"(?m)^ V\S{5} (\S+)", listed))
    found = [name for name in _ENCODERS[ending] if name in there]
    if not found:
        wanted = ", ".join(_ENCODERS[ending])
        raise Failure(f"capture: {out.name}: this ffmpeg has no encoder for {ending} (one of {wanted}){remedy}")
    return found


def write(pattern: Path, fps: float, out: Path) -> None:
    """Puts the numbered frames together; the next encoder has a go when one fails. Under its name there never is half a movie."""
    part = out.with_name(f".{out.stem}.part{out.suffix}")
    log = paths.LOGS / f"movie-{out.name}.log"
    tried = []
    try:
        for encoder in encoders(out):
            best = _ENCODERS[out.suffix.lower()][0]
            say(f"Writing {out.name}")
            if encoder != best:
                note(f"with the encoder {encoder}: " + (f"{tried[-1]} failed" if tried else f"this ffmpeg has no {best}"))
            status = process.run_logged(_command(pattern, fps, encoder, part), log, append=bool(tried))
            if status == 0 and part.is_file():
                os.replace(part, out)
                log.unlink()
                return
            tried.append(encoder)
    finally:
        part.unlink(missing_ok=True)
    raise Failure(
        f"capture: {out.name}: ffmpeg failed with {', '.join(tried)} (its output is in {log}); "
        f"the frames are in {pattern.parent}"
    )


def _command(pattern: Path, fps: float, encoder: str, part: Path) -> list[str]:
    """One pass over the frames. Odd sizes get a black line, since colour is stored at half of the resolution."""
    escaped = str(pattern.parent).replace("%", "%%")
    # Players take what carries no tag for BT.601; JPEG pictures moreover have the full range.
    tagged = encoder not in _UNTAGGED
    levels = "full" if encoder == "mjpeg" else "limited"
    matrix = "bt709" if tagged else "bt601"
    video = f"pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix={matrix}:out_range={levels}"
    tags = ["-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "iec61966-2-1"] if tagged else []
    return [
        "ffmpeg", "-hide_banner", "-nostdin", "-y", "-framerate", repr(fps), "-start_number", "0",
        "-i", f"{escaped}/{frames.FRAME_NAME}", "-vf", video, "-c:v", encoder, *_QUALITY[encoder], *tags, str(part),
    ]
