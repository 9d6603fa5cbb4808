"""./tumble demo: from a bare machine to every picture of the course, the first of them early."""

from __future__ import annotations

import argparse
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Sequence

from . import build, packages, page
from .console import FAILED, coloured, require_writable, say
from .gallery import REFERENCE
from .labs import find_labs, is_handout
from .pictures import Picture

SHORT = "--short"


def run(root: Path, options: argparse.Namespace) -> int:
    if is_handout(root):
        return _prepare_handout(root, options)
    demo = Demo(root)
    require_writable(demo.out)
    if not options.no_install:
        packages.install_missing(root, proof=False)
    labs = find_labs(root)
    films, charts = ([Picture(lab, command, REFERENCE, demo.out) for lab in labs]
                     for command in ("frames", "chart"))
    known = build.targets(root, "release")
    demo.draw([film for film in films if film.target in known],
              [chart for chart in charts if chart.target in known])
    index = page.write(root, demo.out)
    missing = [picture.target for picture in films + charts if picture not in demo.drawn]
    if missing:
        say("", f"Not drawn: {', '.join(missing)}. ./tumble doctor lists what is missing.",
            f"All other pictures: {index}")
        return FAILED
    say("", coloured("Done.", "green") + f" Look at {index}",
        "The charts come from short runs; ./tumble chart N --solution measures one in full.")
    return 0


def _prepare_handout(root: Path, options: argparse.Namespace) -> int:
    """A student's copy has no reference to draw, but needs the same packages."""
    if not options.no_install:
        packages.install_missing(root, proof=False)
    say("This is a hand-out: it can draw your answer, but has no reference to draw.",
        "Begin with ./tumble test 1; ./tumble doctor lists what is installed.")
    return 0


class Demo:
    """Draws what is built while the next is being built; every picture renews the page."""

    def __init__(self, root: Path) -> None:
        self.root = root
        self.out = root / "out"
        self.drawn: list[Picture] = []
        self._start = time.monotonic()

    def draw(self, films: Sequence[Picture], charts: Sequence[Picture]) -> None:
        """Builds one lab's film after the other, then all charts. These want a quiet machine, so
        they are measured once nothing else is left to do, and in short."""
        with ThreadPoolExecutor(1) as painter:
            begun = []
            try:
                for film in films:
                    build.require(self.root, "release", [film.target])
                    begun.append(painter.submit(self._show, film))
                if charts:
                    build.require(self.root, "release", [chart.target for chart in charts])
            except KeyboardInterrupt:
                painter.shutdown(cancel_futures=True)
                raise
            for film in begun:
                film.result()
        for chart in charts:
            self._show(chart, [SHORT])

    def _show(self, picture: Picture, arguments: Sequence[str] = ()) -> None:
        if not picture.draw_meanwhile(self.root, arguments):
            return
        index = page.write(self.root, self.out)
        say(f"{self._clock()}  {picture.lab.heading}: {picture.kind}")
        self.drawn.append(picture)
        if len(self.drawn) == 1:
            say(f"      Open {index} now. Reload it to see more while the rest is built.")

    def _clock(self) -> str:
        minutes, seconds = divmod(int(time.monotonic() - self._start), 60)
        return f"{minutes}:{seconds:02d}"
