"""./tumble watch N: the tests again on every save."""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path

from .checklist import test_lab
from .console import Failure, say
from .labs import Lab, find_lab

_POLL_SECONDS = 0.2


def run(root: Path, options: argparse.Namespace) -> int:
    lab = find_lab(root, options.lab)
    try:
        while True:
            seen = _stamp(lab)
            _test_once(root, lab)
            while _stamp(lab) == seen:
                time.sleep(_POLL_SECONDS)
    except KeyboardInterrupt:
        say("")
        return 0


def _test_once(root: Path, lab: Lab) -> None:
    if sys.stdout.isatty():
        sys.stdout.write("\033[H\033[2J\033[3J")
    try:
        test_lab(root, lab)
    except Failure as failure:  # a file that does not compile is the rule while one writes
        say(str(failure))
    say("", f"Watching labs/{lab.folder}/{lab.stub.name}; Ctrl-C ends it.")
    sys.stdout.flush()


def _stamp(lab: Lab) -> tuple[int, int]:
    """Changes on every save. An editor that replaces the file may show none for a moment."""
    try:
        status = lab.stub.stat()
        return status.st_mtime_ns, status.st_size
    except FileNotFoundError:
        return 0, 0
