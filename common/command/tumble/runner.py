"""Runs the cases of a lab, each in a child process of its test program (tests/support/run_each)."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import tempfile
from pathlib import Path
from types import MappingProxyType
from typing import BinaryIO, Iterator, Mapping, NamedTuple, Optional, Sequence

from .console import Failure, Progress, shortened
from .ctest import Case

_HEAD = re.compile(rb"case (\d+) (exit|signal|timeout|waits|skipped) (\d+) (\S+) (\d+)\n")
_PASSED = re.compile(r"All tests passed [(][1-9]")
_OUTPUT_LIMIT = 1 << 20

TIMEOUT = "Timeout"
WAITS = "Waits"
SKIPPED = "Hopeless"
"""Reasons of a case that did not end by itself, and of one that is not run in a hopeless step."""


class Ended(NamedTuple):
    """How a case ended, as the program records it."""

    line: int
    end: str
    value: int
    seconds: float
    output: str


def run_cases(program: Path, prefix: str, apart: bool = False,
              environment: Mapping[str, str] = MappingProxyType({})) -> list[Case]:
    """All cases of cases.txt beside the program, which CMake reads from the sources of the tests.

    A case is named <prefix>/<step>/<name>.
    apart        each in a process of its own, and not those alone that fail: that takes longer
    environment  what the program finds set, beside all the rest
    """
    listed = program.with_name("cases.txt")
    names = listed.read_text(encoding="utf-8").splitlines()
    jobs = str(os.cpu_count() or 1) if apart else "together"
    command = [str(program), "--each", str(listed), jobs]
    ended: dict[int, Ended] = {}
    with Progress() as progress, tempfile.TemporaryFile() as errors, subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=errors,
            env={**os.environ, **environment}) as process:
        for record in records(process.stdout):
            ended[record.line] = record
            progress.show(f"testing: {len(ended)} of {len(names)}")
        errors.seek(0)
        said = errors.read(_OUTPUT_LIMIT).decode("utf-8", errors="replace")
    if not ended:
        raise Failure("the program ended before its first test: is there a static object whose "
                      "constructor crashes, or calls exit()?", details=shortened(said, 2000))
    return cases(names, ended, prefix)


def cases(names: Sequence[str], ended: Mapping[int, Ended], prefix: str) -> list[Case]:
    """Catch2's own words decide: an exit code of 0 alone would pass an answer that calls exit(0),
    and a case that asserts nothing."""
    return [_case(f"{prefix}/{name.replace('|', '/', 1)}", ended.get(line))
            for line, name in enumerate(names)]


def _case(name: str, ended: Optional[Ended]) -> Case:
    if ended is None:
        return Case(name, "notrun", "", "the program ended before this test")
    good = (ended.end, ended.value) == ("exit", 0) and _PASSED.search(ended.output)
    status = "run" if good else "notrun" if ended.end == "skipped" else "fail"
    reason = {"timeout": TIMEOUT, "waits": WAITS, "skipped": SKIPPED}.get(ended.end, "")
    if ended.end == "signal":
        reason = _signal_name(ended.value)
    return Case(name, status, reason, ended.output, ended.seconds)


def _signal_name(number: int) -> str:
    try:
        return signal.Signals(number).name
    except ValueError:
        return f"signal {number}"


def records(stream: BinaryIO) -> Iterator[Ended]:
    while True:
        head = _HEAD.fullmatch(stream.readline())
        if not head:
            return
        size = int(head.group(5))
        output = stream.read(size)[:_OUTPUT_LIMIT].decode("utf-8", errors="replace")
        stream.read(1)
        yield Ended(int(head.group(1)), head.group(2).decode(), int(head.group(3)),
                    float(head.group(4)), output)
