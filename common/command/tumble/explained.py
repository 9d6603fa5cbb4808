"""What is said of a test that failed: the test's own words, and what can be said from outside."""

from __future__ import annotations

from typing import NamedTuple, Optional, Sequence

from . import ctest, runner
from .console import coloured, labelled
from .labs import Lab
from .outcome import (CRASHED, ENDED_EARLY, EXCEPTION, NOT_RUN, TIMED_OUT, Outcome, assertion,
                      catch_failure, explanation, printed)

_PROSE = {"bound", "likely", "note", "error"}
ASKED = {"step", "case", "input"}
LABEL_WIDTH = 7
_TAIL_LINES = 12
_PRINTED_LINES = 20
_USUAL_CRASH = ("usual causes are an index out of range, a reference kept while its vector grows, "
                "a comparison for std::sort that is true for equals (<=), a function "
                "that calls itself without end, and a missing return")


class Checked(NamedTuple):
    """A test of the student's answer."""

    step: str
    title: str
    case: ctest.Case
    outcome: Outcome


def what_it_prints(lab: Lab, failure: Checked) -> list[str]:
    lines = printed(failure.case.output)
    if not lines:
        return []
    kept = lines[:_PRINTED_LINES]
    if len(lines) > len(kept):
        kept.append(f"... {len(lines) - len(kept)} more lines: ./tumble test {lab.number} "
                    f'--case "{failure.title}"')
    return labelled("prints", "\n".join(kept), LABEL_WIDTH, wrap=False)


def what_was_not_run(failure: Checked, failures: Sequence[Checked]) -> list[str]:
    """What became of a step's other cases once three of them had run out of time."""
    if failure.outcome.word != TIMED_OUT:
        return []
    count = sum(other.step == failure.step and other.outcome.word == NOT_RUN for other in failures)
    text = (f"{count} more cases of step {failure.step} were not run, because three ran out of "
            "time")
    return labelled("", text, LABEL_WIDTH) if count else []


def explained(failure: Checked) -> list[str]:
    """The test's own explanation, or else what can be said from outside."""
    block = explanation(failure.case.output) or [("step", failure.step)]
    if all(label in ASKED for label, _ in block):  # the answer did not return
        block += _from_outside(failure)
    lines = []
    previous = ""
    for label, text in block:
        shown = "" if label == previous else label
        lines += labelled(shown, text, LABEL_WIDTH, wrap=label in _PROSE)
        previous = label
    return [coloured(line, "yellow") if line.startswith("likely ") else line for line in lines]


def _from_outside(failure: Checked) -> list[tuple[str, str]]:
    word, detail = failure.outcome
    if word == TIMED_OUT and detail == runner.WAITS:
        return [("note", "your code sleeps or waits for input, which no step needs: "
                         "remove the call that waits")]
    if word == TIMED_OUT:
        return [("note", "it did not end in time: look for a loop that never ends, a "
                         "missing return, or far too much work, such as a copy in each call")]
    if word == CRASHED:
        broken: Optional[str] = assertion(failure.case.output)
        why = f"this assert did not hold: {broken}; {_USUAL_CRASH}" if broken else _USUAL_CRASH
        return [("note", f"the program crashed ({detail}); {why}")]
    if word == ENDED_EARLY:
        return [("note", "the program ended before the test did: does your code call exit()?")]
    if word == EXCEPTION:
        return [("note", f"an exception was thrown: {detail}")]
    if word == NOT_RUN:
        return [("note", f"the test could not be run: {detail}")]
    output = failure.case.output
    words = catch_failure(output) or output.strip().splitlines()[-_TAIL_LINES:]
    return [("said", line) for line in words]


def help_lines(lab: Lab, step: str) -> list[str]:
    again = f"./tumble test {lab.number}   or on every save: ./tumble watch {lab.number}"
    lines = labelled("again", again, LABEL_WIDTH)
    if (lab.path / "hints.md").exists():
        lines += labelled("stuck?", f"./tumble hint {step}", LABEL_WIDTH)
    return lines
