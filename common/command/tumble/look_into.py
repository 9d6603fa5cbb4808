"""./tumble test N --case "words" [--debug]: one case, with all that the student's code prints."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

from . import answer, build
from .console import BAD_USAGE, FAILED, Failure, say
from .labs import Lab, printable

_SHOWN = 8


def run_one(root: Path, lab: Lab, words: str, debug: bool) -> int:
    """The case runs as it is, without a limit of time: Ctrl-C ends it."""
    if debug and not shutil.which("gdb"):
        raise Failure("gdb is missing, and --debug needs it: install the package gdb")
    with build.locked(root, "dev"):
        program = answer.compiled(root, lab, "debug" if debug else "")
    step, title = find_case(program.with_name("cases.txt").read_text(encoding="utf-8"), words)
    say(f"step {step}: {title}", "")
    sys.stdout.flush()
    if debug:
        places = [text for function in lab.functions_of(step)
                  for text in ("-ex", f"break lab::{lab.name}::{function}")]
        os.execvp("gdb", ["gdb", "-q", *places, "-ex", "run", "--args", str(program), title])
    code = subprocess.run([str(program), title], cwd=root).returncode
    if code < 0:
        say("", f"The program ended by signal {-code}. To see where, add --debug.")
    return 0 if code == 0 else FAILED


def find_case(listed: str, words: str) -> tuple[str, str]:
    """The case whose step and title hold the words, whatever their case; a whole title wins."""
    cases = [tuple(line.split("|", 1)) for line in listed.splitlines()]
    found = [(step, title) for step, title in cases if title == words] or [
        (step, title) for step, title in cases if words.lower() in f"{step} {title}".lower()]
    if len(found) == 1:
        return found[0]
    if not found:
        raise Failure(f"no case matches {printable(words)}: give a failure's title or a part",
                      BAD_USAGE)
    listing = [f"  {step}  {title}" for step, title in found[:_SHOWN]]
    more = [f"  and {len(found) - _SHOWN} more"] if len(found) > _SHOWN else []
    raise Failure(f"{len(found)} cases match {printable(words)}: give more of one title", BAD_USAGE,
                  details="\n".join(listing + more))
