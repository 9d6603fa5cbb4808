"""What the judge says of a file, and the words that it says it in."""

from __future__ import annotations

from typing import NamedTuple

from ..outcome import NOT_WRITTEN, PASS, WRONG

BLOCKED = "blocked by step "
CRASH = "crash with signal"
TIME_OUT = "time out"
OUT_OF_MEMORY = "out of memory"
FLOOD = "flood"
NO_BUILD = "does not compile"
GRADER_ERROR = "grader error"
WORDS = (PASS, NOT_WRITTEN, WRONG, CRASH, TIME_OUT, OUT_OF_MEMORY, FLOOD, NO_BUILD, GRADER_ERROR)
"""Of a case; BLOCKED comes with a step."""


class CaseOutcome(NamedTuple):
    """detail: never a number that a test asked with or got; likely: the mistake, where known."""

    step: str
    case: str
    word: str
    detail: str
    likely: str
    seconds: float


class Judged(NamedTuple):
    """notes: for graders alone; cases: each once, the worse of its seeds."""

    compiled: bool
    diagnostics: str
    cases: list[CaseOutcome]
    sanitizer: str
    notes: list[str]
    sandboxed: bool
