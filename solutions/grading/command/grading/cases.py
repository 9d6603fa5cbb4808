"""Runs the lab's tests on a worker, a process a case, by CTest; and what became of each, in a word.

The tests are the lab's own, linked with a proxy: they never hold a student's code, so that what
they say and how they end can be believed. What a student's exceptions say comes through, but on one
line and without the letters that a line of a test begins with.
"""

from __future__ import annotations

import os
import re
import subprocess
from collections import Counter
from pathlib import Path
from typing import NamedTuple, Sequence

from .. import ctest, outcome
from ..console import Failure
from .compiling import Tools
from .verdicts import (BLOCKED, CRASH, FLOOD, GRADER_ERROR, NOT_WRITTEN, OUT_OF_MEMORY, PASS,
                       TIME_OUT, WRONG, CaseOutcome)

_SECONDS = 300
"""A case ends by itself long before: the worker's time is limited, and the rest is trusted."""

PATIENCE = 10
"""What a worker may compute in a case [s]; six times as long may it take, and sleep two seconds. A
second each once three of a submission have come to no end."""

_FATE = re.compile(r"^tumble-judge: ([^\n]+)$", re.MULTILINE)
_STEP = re.compile(r"\d+\.\d+")
_REPORT = re.compile(r"AddressSanitizer|runtime error:")


class Run(NamedTuple):
    """One way of running cases: which worker, which seed."""

    tools: Tools
    worker: Path
    """A file with the worker's command line, an argument a line."""
    boxed: bool
    seed: int
    folder: Path
    """A new one, for what CTest writes, and where the worker's own words go."""
    keeps_words: bool = False


def run_cases(run: Run, cases: Sequence[tuple[str, str]]) -> list[CaseOutcome]:
    """The outcome of each case, in the order given."""
    if not cases:
        return []
    names = [f"{step}/{title}" for step, title in cases]
    found = {case.name: case for case in _run_ctest(run, cases, names)}
    return [case_outcome(step, title, found[name]) for (step, title), name in zip(cases, names)]


def _run_ctest(run: Run, cases: Sequence[tuple[str, str]],
               names: Sequence[str]) -> list[ctest.Case]:
    run.folder.mkdir()
    (run.folder / "CTestTestfile.cmake").write_text("".join(
        _declaration(run, index, title, name)
        for index, ((_, title), name) in enumerate(zip(cases, names))), encoding="utf-8")
    junit = run.folder / "junit.xml"
    done = subprocess.run(
        ["ctest", "--test-dir", str(run.folder), "--no-tests=error", "--output-junit", str(junit),
         "--test-output-size-passed", "65536", "--test-output-size-failed", "65536"],
        text=True, errors="replace", env=_environment(run), stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if not junit.exists():
        raise Failure("CTest ran no tests", details=done.stdout[-2000:])
    found = ctest.read_junit(junit.read_bytes(), ctest.reasons(done.stdout.splitlines()))
    if Counter(case.name for case in found) != Counter(names):
        raise Failure(f"CTest ran {len(found)} cases instead of {len(names)}")
    return found


def _declaration(run: Run, index: int, title: str, name: str) -> str:
    settings = [f"TUMBLE_WORKER_LOG={run.folder / f'{index}.words'}"] if run.keeps_words else []
    words = (str(run.tools.test), title, *run.tools.strict)
    command = " ".join(f"[==[{word}]==]" for word in words)
    return (f"add_test([==[{name}]==] {command})\n"
            f"set_tests_properties([==[{name}]==] PROPERTIES TIMEOUT {_SECONDS} "
            f"ENVIRONMENT [==[{';'.join(settings)}]==])\n")


def _environment(run: Run) -> dict[str, str]:
    """Of the tests. The worker gets none of it."""
    return {**os.environ, "TUMBLE_WORKER": str(run.worker), "TUMBLE_SEED": str(run.seed),
            "TUMBLE_SANDBOX": "bubblewrap" if run.boxed else "",
            "TUMBLE_PATIENCE": str(PATIENCE),
            "TUMBLE_TIMEOUTS": str(run.worker.with_name("timeouts"))}


def case_outcome(step: str, title: str, case: ctest.Case) -> CaseOutcome:
    word, detail = _word(step, case)
    likely = ""
    if word == WRONG:
        stories = {text for label, text in outcome.explanation(case.output) if label == "likely"}
        likely = stories.pop() if len(stories) == 1 else ""
    return CaseOutcome(step, title, word, detail, likely, case.seconds)


def _word(step: str, case: ctest.Case) -> tuple[str, str]:
    if case.passed:
        return PASS, ""
    fates = _FATE.findall(case.output)
    if fates:
        return _word_of_fate(fates[-1])
    if case.reason == "Timeout" or case.status in ("notrun", "disabled"):
        return GRADER_ERROR, f"CTest says: {case.reason or case.status}"
    said = outcome.outcome(case)
    if said.word == NOT_WRITTEN:
        other = _STEP.match(said.detail)
        if other and other.group() != step:
            return BLOCKED + other.group(), ""
        return NOT_WRITTEN, said.detail
    if said.word in (outcome.CRASHED, outcome.ENDED_EARLY):
        return WRONG, "the test could not go on with this answer"
    if said.word == outcome.EXCEPTION:
        return WRONG, "an exception instead of an answer"
    return WRONG, ""


def _word_of_fate(fate: str) -> tuple[str, str]:
    if fate.startswith("crash "):
        return CRASH, fate.removeprefix("crash ")
    if fate == "malformed":
        return WRONG, "the answer is malformed"
    if fate in (TIME_OUT, FLOOD, OUT_OF_MEMORY):
        return fate, ""
    return GRADER_ERROR, fate


def report_of_sanitizers(run: Run, count: int) -> str:
    """The first that a worker wrote."""
    for index in range(count):
        try:
            with open(run.folder / f"{index}.words", "rb") as words:
                text = words.read(8192).decode("utf-8", errors="replace")
        except OSError:
            continue
        found = _REPORT.search(text)
        if found:
            begin = text.rfind("\n", 0, found.start()) + 1
            return text[begin:begin + 2000].strip()
    return ""
