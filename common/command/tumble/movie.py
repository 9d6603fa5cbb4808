"""A film's frames as one file, by ffmpeg."""

from __future__ import annotations

import json
import shlex
import shutil
import subprocess
from pathlib import Path

from .console import Failure, Progress, shortened

KINDS = ("gif", "mp4")

# One palette for the whole film, without the dots that stand for colours between; and what every
# player takes: even sides, and every second colour.
_FILTERS = {"gif": "split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=none",
            "mp4": "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white"}
_CODECS = {"gif": ["-f", "gif"], "mp4": ["-f", "mp4", "-c:v", "libx264", "-pix_fmt", "yuv420p",
                                         "-crf", "18", "-movflags", "+faststart"]}


def make(film: Path, kind: str) -> str:
    """Writes film.<kind> beside the folder of frames, whole or not at all. Returns a line for the
    user: where it is, or how to make it where ffmpeg is missing."""
    target = film.with_name(f"{film.name}.{kind}")
    fps = json.loads((film / "film.json").read_text(encoding="utf-8")).get("fps", 25)
    part = film.with_name(f".{film.name}-part.{kind}")
    command = ["ffmpeg", "-nostdin", "-loglevel", "error", "-y", "-framerate", f"{fps:g}",
               "-i", str(film / "frame_%04d.png"), "-vf", _FILTERS[kind], *_CODECS[kind]]
    if not shutil.which("ffmpeg"):
        return (f"{target.name} needs ffmpeg, which is missing: install the package ffmpeg, then "
                f"type the same command again, or: {shlex.join([*command, str(target)])}")
    with Progress() as progress:
        progress.show(f"ffmpeg writes {target.name}")
        done = subprocess.run([*command, str(part)], stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, errors="replace")
    if done.returncode != 0:
        part.unlink(missing_ok=True)
        raise Failure(f"ffmpeg could not make {target.name}", details=shortened(done.stderr, 2000))
    part.replace(target)
    return f"wrote {target}"
