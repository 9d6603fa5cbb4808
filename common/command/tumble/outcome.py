"""What became of one test, in a word, and what the test itself says about it."""

from __future__ import annotations

import re
from typing import NamedTuple, Optional, Sequence

from .ctest import Case

PASS = "pass"
WRONG = "wrong"
NOT_WRITTEN = "not written yet"
CRASHED = "crashed"
TIMED_OUT = "timed out"
EXCEPTION = "exception"
ENDED_EARLY = "ended early"
NOT_RUN = "not run"

_NOT_WRITTEN = re.compile(r"^\s*(\d+\.\d+ \w+) is not written yet\s*$", re.MULTILINE)
_EXCEPTION = re.compile(r"unexpected exception with message:\n +(.+)")
_SIGNAL = re.compile(r"fatal error condition:\n +(SIG\w+)")
_ASSERTION = re.compile(r"^.*Assertion [`'](.+)' failed\.?$", re.MULTILINE)
_CATCH_FAILURE = re.compile(r"^[^\n]+: FAILED:\n.*?(?=\n\n(?:[.=-]{20}|\S+: FAILED)|\Z)",
                            re.MULTILINE | re.DOTALL)
_EXPLANATION = re.compile(r"\| (\w+) *(.*)")
_VERDICT = re.compile(r"^(test cases:|All tests passed)", re.MULTILINE)
_CATCH_REPORT = re.compile(r"^(?:~{70,}|={70,}|-{70,})$", re.MULTILINE)
_OF_CATCH = re.compile(r"Filters: |Randomness seeded to: ")
_OTHER_REASONS = {"", "Failed", "Not Run"}


class Outcome(NamedTuple):
    word: str
    detail: str
    """The signal, the exception's message or the function that is not written yet."""


def outcome(case: Case) -> Outcome:
    if case.passed:
        return Outcome(PASS, "")
    if case.status in ("notrun", "disabled"):
        why = "three cases of this step ran out of time" if case.reason == "Hopeless" else ""
        return Outcome(NOT_RUN, why or case.output.strip().split("\n", 1)[0])
    if case.reason in ("Timeout", "Waits"):
        return Outcome(TIMED_OUT, case.reason)
    signal = _SIGNAL.search(case.output)
    if signal or case.reason not in _OTHER_REASONS:
        return Outcome(CRASHED, signal.group(1) if signal else case.reason)
    not_written = _NOT_WRITTEN.search(case.output)
    if not_written and not explanation(case.output):
        return Outcome(NOT_WRITTEN, not_written.group(1))
    exception = _EXCEPTION.search(case.output)
    if exception and not not_written:
        return Outcome(EXCEPTION, exception.group(1))
    if not _VERDICT.search(case.output):
        return Outcome(ENDED_EARLY, "")
    return Outcome(WRONG, "")


def explanation(output: str) -> list[tuple[str, str]]:
    """The first block of `| label  text` lines: the test's own words on what is wrong."""
    block: list[tuple[str, str]] = []
    for line in output.splitlines():
        match = _EXPLANATION.fullmatch(line.rstrip())
        if match and match.group(1) == "step" and block:
            break
        if match:
            block.append((match.group(1), match.group(2)))
    return block


def printed(output: str) -> list[str]:
    """What the student's code printed: all that is neither the test's words nor Catch2's."""
    before = _CATCH_REPORT.split(output, 1)[0]
    return [line for line in before.strip("\n").splitlines()
            if not any(words.match(line) for words in (_EXPLANATION, _OF_CATCH, _ASSERTION))]


def assertion(output: str) -> Optional[str]:
    """The condition of an assert that did not hold."""
    match = _ASSERTION.search(output)
    return match.group(1) if match else None


def catch_failure(output: str) -> Sequence[str]:
    """Catch2's own words on the first check that failed, for tests that say no more."""
    match = _CATCH_FAILURE.search(output)
    return match.group(0).rstrip().splitlines() if match else []
