"""Runs CTest and reads its record: the JUnit file, and the reasons that only its console gives."""

from __future__ import annotations

import re
import subprocess
import xml.etree.ElementTree as xml
from pathlib import Path
from typing import Mapping, NamedTuple, Sequence

from .console import Failure, Progress, shortened

_PROGRESS = re.compile(r" *(\d+)/(\d+) Test +#\d+: ")
_FAILED = re.compile(r"\t *\d+ - (.+?) \(([^()]+)\)(?: {2,}.*)?$")
_SUMMARY_BEGINS = re.compile(r"\d+% tests passed")
_SUMMARY_ENDS = "Total Test time"


class Case(NamedTuple):
    """One test: status (run, fail, notrun, disabled) and reason (Timeout, SEGFAULT, ...)."""

    name: str
    status: str
    reason: str
    output: str
    seconds: float = 0.0

    @property
    def passed(self) -> bool:
        return self.status == "run"

    @property
    def skipped(self) -> bool:
        """It found that this machine cannot run it."""
        return self.reason == "Skipped"


class TestRun(NamedTuple):
    code: int
    cases: Sequence[Case]
    summary: str


def run_tests(folder: Path, selection: Sequence[str]) -> TestRun:
    junit = folder / "tumble-junit.xml"
    junit.unlink(missing_ok=True)
    command = ["ctest", "--test-dir", str(folder), *selection, "--output-junit", str(junit),
               "-j2", "--no-tests=error"]
    lines = []
    with Progress() as progress, subprocess.Popen(
            command, text=True, errors="replace", stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as process:
        for line in process.stdout or ():
            lines.append(line.rstrip("\n"))
            done = _PROGRESS.match(line)
            if done:
                progress.show(f"testing: {done.group(1)} of {done.group(2)}")
    if not junit.exists():
        raise Failure("CTest ran no tests", details=shortened("\n".join(lines[-20:]), 2000))
    return TestRun(process.returncode, read_junit(junit.read_bytes(), reasons(lines)),
                   summary(lines))


def reasons(lines: Sequence[str]) -> dict[str, str]:
    """Why each failed test failed. CTest 3.25 leaves crashes and timeouts out of its JUnit file."""
    matches = (_FAILED.match(line) for line in lines)
    return {match.group(1): match.group(2) for match in matches if match}


def read_junit(text: bytes, why: Mapping[str, str]) -> list[Case]:
    try:
        suite = xml.fromstring(text)
    except xml.ParseError as error:
        raise Failure(f"CTest's record of the tests cannot be read: {error}") from error
    return [Case(name=test.get("name", ""), status=test.get("status", ""),
                 reason=why.get(test.get("name", ""), ""), output=test.findtext("system-out") or "",
                 seconds=float(test.get("time") or 0.0))
            for test in suite.iter("testcase")]


def summary(lines: Sequence[str]) -> str:
    """CTest's last words, from "100% tests passed" to "Total Test time"."""
    kept: list[str] = []
    for line in lines:
        if kept or _SUMMARY_BEGINS.match(line):
            kept.append(line)
        if line.startswith(_SUMMARY_ENDS):
            break
    return "\n".join(kept)
