"""./tumble frames N and ./tumble chart N: runs the lab's programs, then renews the page."""

from __future__ import annotations

import argparse
import re
import shlex
import subprocess
from pathlib import Path
from typing import Sequence

from . import build, gallery, movie, page
from .console import (BAD_USAGE, FAILED, Failure, Progress, complain, require_writable,
                      say)
from .gallery import CHART, FILM, STUDENT, command_file
from .labs import Lab, chosen_answers, find_lab

PROGRAMS = {"frames": "scene", "chart": "chart"}
FOLDERS = {"frames": FILM, "chart": CHART}
PEERS = "--peers"

_COUNT = re.compile(r"\w+ \d+ of \d+")


class Picture:
    """What is to be drawn: the program that draws it and the folder that it goes to."""

    def __init__(self, lab: Lab, command: str, variant: str, out: Path):
        self.lab = lab
        self.variant = variant
        self.kind = FOLDERS[command]
        self.target = f"{lab.name}_{variant}_{PROGRAMS[command]}"
        self.folder = out / lab.folder / variant / self.kind
        self.typed = ["./tumble", command, str(lab.number)]
        self.typed += gallery.of_answer(variant)

    def draw(self, root: Path, arguments: Sequence[str], out: Sequence[str] = ()) -> bool:
        """Runs the program, which says itself what is wrong; the command goes beside its work."""
        return self._ended(subprocess.run(self._command(root, arguments)).returncode,
                           shlex.join([*self.typed, *arguments, *out]))

    def draw_meanwhile(self, root: Path, arguments: Sequence[str] = ()) -> bool:
        """The same while other work goes on: its counter joins the line of progress. The command
        beside the pictures leaves the arguments out: it makes them in full."""
        what = f"lab {self.lab.number}'s {self.kind}"
        with Progress() as progress, subprocess.Popen(
                self._command(root, arguments), text=True, errors="replace",
                stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                stderr=subprocess.PIPE) as process:
            progress.show(what)
            for line in process.stderr or ():
                if _COUNT.fullmatch(line.strip()):
                    progress.show(f"{what}: {line.strip()}")
                elif not line.startswith("wrote "):
                    complain(line.rstrip())
        return self._ended(process.returncode, shlex.join(self.typed))

    def _command(self, root: Path, arguments: Sequence[str]) -> list[str]:
        program = build.build_folder(root, "release") / "labs" / self.lab.folder / self.target
        return [str(program), "--out", str(self.folder), *arguments]

    def _ended(self, code: int, command: str) -> bool:
        if code < 0:
            complain(f"tumble: {self.target} crashed (signal {-code})")
        if code == 0:
            command_file(self.folder).write_text(command + "\n", encoding="utf-8")
        return code == 0


def run(root: Path, options: argparse.Namespace) -> int:
    lab = find_lab(root, options.lab)
    arguments = _film_arguments(options) if options.command == "frames" else _peers(options)
    arguments += _meshes(lab, options.mesh)
    out = Path(options.out).absolute() if options.out else root / "out"
    names = [STUDENT] if options.answer is None else chosen_answers(root, lab, options.answer)
    pictures = [Picture(lab, options.command, name, out) for name in names]
    require_writable(out)
    if PEERS in arguments:  # CMake looks for them once; they may have come since
        build.configure(root, "release", again=True)
    build.require(root, "release", [picture.target for picture in pictures])
    where = ["--out", options.out] if options.out else []
    beside: list[str] = []
    for picture in reversed(pictures):  # the first is drawn last, with the others beside it
        if not picture.draw(root, arguments + beside * (picture is pictures[0]), where):
            return FAILED
        if options.command == "frames":
            for kind in movie.KINDS:
                if getattr(options, kind):
                    say(movie.make(picture.folder, kind))
        else:
            beside += ["--beside", picture.variant, str(picture.folder)]
    say(f"Look at {page.write(root, out)}, or at the files in {pictures[0].folder}")
    return 0


def _meshes(lab: Lab, files: Sequence[str]) -> list[str]:
    if not files:
        return []
    if not (lab.path / "own_meshes.hpp").exists():
        raise Failure(f"lab {lab.number} has no meshes: --mesh is for lab 5", BAD_USAGE)
    if len(files) > 2:
        raise Failure(f"--mesh: give one or two files, not {len(files)}", BAD_USAGE)
    return [part for file in files for part in ("--mesh", file)]


def _peers(options: argparse.Namespace) -> list[str]:
    return [PEERS] if options.peers else []


def _film_arguments(options: argparse.Namespace) -> list[str]:
    if options.start and options.end and float(options.start) > float(options.end):
        raise Failure(f"--from {options.start} is later than --to {options.end}", BAD_USAGE)
    values = (("--size", options.size), ("--fps", options.fps), ("--from", options.start),
              ("--to", options.end), ("--quality", options.quality))
    arguments = [part for name, value in values if value is not None for part in (name, value)]
    return arguments + (["--white"] if options.white else [])

