"""./tumble demo: from a bare machine to every picture of the course."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from . import build, packages, page, pictures
from .console import FAILED, coloured, say
from .gallery import REFERENCE
from .labs import find_labs, is_handout


def run(root: Path, options: argparse.Namespace) -> int:
    if is_handout(root):
        return _prepare_handout(root, options)
    out = root / "out"
    pictures.prepare(out)
    if not options.no_install:
        packages.install_missing(root)
    wanted = [pictures.Picture(lab, command, REFERENCE, out)
              for lab in find_labs(root) for command in pictures.PROGRAMS]
    known = build.targets(root, "release")
    possible = [picture for picture in wanted if picture.target in known]
    if possible:
        build.require(root, "release", [picture.target for picture in possible])
    drawn = [picture for picture in possible if _draw(root, picture)]
    index = page.write(root, out)
    if len(drawn) < len(wanted):
        missing = ", ".join(picture.target for picture in wanted if picture not in drawn)
        say("", f"Not drawn: {missing}. ./tumble doctor says what this machine lacks.",
            f"All the rest: {index}")
        return FAILED
    say("", coloured("Done.", "green") + f" Look at {index}")
    return 0


def _prepare_handout(root: Path, options: argparse.Namespace) -> int:
    """A student's copy has no reference to draw, but needs the same packages."""
    if not options.no_install:
        packages.install_missing(root)
    say("This is a hand-out: it has no reference pictures to draw, only yours.",
        "Begin with ./tumble test 1; ./tumble doctor says what is installed.")
    return 0


def _draw(root: Path, picture: pictures.Picture) -> bool:
    say(f"{picture.lab.heading}: {picture.command}")
    sys.stdout.flush()
    return picture.draw(root, [])
