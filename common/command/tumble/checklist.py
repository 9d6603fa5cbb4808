"""./tumble test N: the student's answer, step by step, then the first failure explained.

With --case it is one case, as it runs: see look_into.py.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Mapping, NamedTuple, Optional, Sequence

from . import answer, build, ctest, look_into, runner, sanitized
from .console import BAD_USAGE, FAILED, Failure, coloured, labelled, mark, say
from .labs import Lab, find_lab
from .outcome import (CRASHED, ENDED_EARLY, EXCEPTION, NOT_RUN, NOT_WRITTEN, PASS, TIMED_OUT,
                      Outcome, assertion, catch_failure, explanation, outcome, printed)

_PROSE = {"bound", "likely", "note", "error"}
_ASKED = {"step", "case", "input"}
_LABEL_WIDTH = 7
_TAIL_LINES = 12
_PRINTED_LINES = 20
_USUAL_CRASH = ("usual causes are an index out of range, a reference kept while its vector grows, an "
                "order for std::sort that is true for equals (<=), a function that calls itself "
                "without end, and a missing return")


class Checked(NamedTuple):
    """A test of the student's answer."""

    step: str
    title: str
    case: ctest.Case
    outcome: Outcome


def run(root: Path, options: argparse.Namespace) -> int:
    lab = find_lab(root, options.lab)
    if options.debug and options.case is None:
        raise Failure("--debug looks into one case: add --case WORDS", BAD_USAGE)
    if options.case is not None:
        return look_into.run_one(root, lab, options.case, options.debug)
    return test_lab(root, lab, options.all)


def test_lab(root: Path, lab: Lab, explain_all: bool = False) -> int:
    with build.locked(root, "dev"):
        program = answer.compiled(root, lab)
        cases = runner.run_cases(program, f"{lab.folder}/student")
        checked = [_checked(case) for case in cases]
        say(*checklist(lab, checked), "")
        if all(check.outcome.word == PASS for check in checked):
            return _look_closer(root, lab)
    say(*what_next(lab, checked, explain_all))
    return FAILED


def _look_closer(root: Path, lab: Lab) -> int:
    sys.stdout.flush()
    looked_at, findings = sanitized.first_finding(root, lab)
    if not findings:
        say(coloured("All done.", "green") + f" Look at it: ./tumble frames {lab.number}"
            f" and ./tumble chart {lab.number}")
        if not looked_at:
            say("(No sanitizers here: undefined behaviour was not looked for.)")
        return 0
    found = findings[0]
    check = _checked(found.case)
    lines = [coloured("All tests pass, but by undefined behaviour: ", "bold") + check.title]
    for label, text in explanation(check.case.output):
        if label in _ASKED:
            lines += labelled(label, text, _LABEL_WIDTH, wrap=False)
    if found.line:
        source = lab.stub.read_text(encoding="utf-8", errors="replace").splitlines()
        where = f"labs/{lab.folder}/{lab.stub.name}:{found.line}"
        lines += labelled("at", f"{where}\n{source[found.line - 1].strip()}", _LABEL_WIDTH, wrap=False)
    lines += labelled("note", found.what, _LABEL_WIDTH)
    say(*lines, *_help_lines(lab, check.step))
    return FAILED


def _checked(case: ctest.Case) -> Checked:
    _, _, step, title = case.name.split("/", 3)
    return Checked(step, title, case, outcome(case))


def checklist(lab: Lab, checked: Sequence[Checked]) -> list[str]:
    """One line a step: its sign, number, title, passed/all and the word for it."""
    titles: Mapping[str, str] = {**{check.step: "" for check in checked}, **lab.steps()}
    longest = max((len(title) for title in titles.values()), default=0)
    lines = [f"{coloured(lab.heading, 'bold')}    {coloured(lab.where_to_write(''), 'dim')}", ""]
    for step in sorted(titles, key=_by_number):
        words = [check.outcome.word for check in checked if check.step == step]
        if words:
            lines.append(_step_line(step, f"{titles[step]:<{longest}}", words))
    return lines


def _by_number(step: str) -> list[int]:
    return [int(part) for part in step.split(".")]


def _step_line(step: str, title: str, words: Sequence[str]) -> str:
    word = _word_for(words)
    looks = {"done": ("done", "green"), NOT_WRITTEN: ("open", "dim")}
    kind, colour = looks.get(word, ("wrong", "red"))
    passed = f"{words.count(PASS)}/{len(words)}"
    sign = coloured(mark(kind), colour)
    return f"  {sign} {step}  {title}  {passed:>5}  {coloured(word, colour)}"


def _word_for(words: Sequence[str]) -> str:
    """A step is what its first failure is; "not written yet" only where nothing else fails."""
    failures = [word for word in words if word != PASS]
    told = [word for word in failures if word != NOT_WRITTEN]
    return told[0] if told else failures[0] if failures else "done"


def what_next(lab: Lab, checked: Sequence[Checked], explain_all: bool) -> list[str]:
    open_cases = [check for check in checked if check.outcome.word == NOT_WRITTEN]
    failures = [check for check in checked if check.outcome.word not in (PASS, NOT_WRITTEN)]
    failures.sort(key=lambda check: _by_number(check.step))
    if failures:
        return _explained(lab, failures, explain_all)
    first = min(open_cases, key=lambda check: _by_number(check.step))
    begun = len(open_cases) < len(checked)
    lines = ["So far, so good." if begun else "Nothing is written yet."]
    function = first.outcome.detail.split(" ")[-1]
    place = lab.where_to_write(first.outcome.detail)
    handout = f"labs/{lab.folder}/{lab.handout.name}"
    lines += labelled("next", f"write {function} of step {first.step} in {place}", _LABEL_WIDTH)
    lines += labelled("read", f"step {first.step} of {handout}", _LABEL_WIDTH)
    return lines + _help_lines(lab, first.step)


def _explained(lab: Lab, failures: Sequence[Checked], explain_all: bool) -> list[str]:
    shown = failures if explain_all else failures[:1]
    lines = []
    for number, failure in enumerate(shown):
        opening = "First failure: " if number == 0 else "Next failure: "
        lines += [coloured(opening + failure.title, "bold"), *_explain(failure),
                  *_printed(lab, failure), *_not_run(failure, failures), ""]
    lines += _help_lines(lab, failures[0].step)
    rest = len(failures) - len(shown)
    if rest:
        text = f"./tumble test {lab.number} --all   explains the other {rest}, too"
        lines += labelled("more", text, _LABEL_WIDTH)
    return lines


def _printed(lab: Lab, failure: Checked) -> list[str]:
    lines = printed(failure.case.output)
    if not lines:
        return []
    kept = lines[:_PRINTED_LINES]
    if len(lines) > len(kept):
        kept.append(f"... {len(lines) - len(kept)} more lines: ./tumble test {lab.number} "
                    f'--case "{failure.title}"')
    return labelled("prints", "\n".join(kept), _LABEL_WIDTH, wrap=False)


def _not_run(failure: Checked, failures: Sequence[Checked]) -> list[str]:
    """What became of a step's other cases once three of them had run out of time."""
    if failure.outcome.word != TIMED_OUT:
        return []
    count = sum(other.step == failure.step and other.outcome.word == NOT_RUN for other in failures)
    text = (f"{count} more cases of step {failure.step} were not run, since three had run out of "
            "time")
    return labelled("", text, _LABEL_WIDTH) if count else []


def _explain(failure: Checked) -> list[str]:
    """The test's own explanation, or else what can be said from outside."""
    block = explanation(failure.case.output) or [("step", failure.step)]
    if all(label in _ASKED for label, _ in block):  # the answer did not return
        block += _from_outside(failure)
    lines = []
    previous = ""
    for label, text in block:
        shown = "" if label == previous else label
        lines += labelled(shown, text, _LABEL_WIDTH, wrap=label in _PROSE)
        previous = label
    return [coloured(line, "yellow") if line.startswith("likely ") else line for line in lines]


def _from_outside(failure: Checked) -> list[tuple[str, str]]:
    word, detail = failure.outcome
    if word == TIMED_OUT and detail == runner.WAITS:
        return [("note", "it sleeps or waits for input; nothing here does: what does it wait for?")]
    if word == TIMED_OUT:
        return [("note", "it did not end in time: look for a loop that cannot end, a "
                         "missing return, or far too much work, as a copy at each call")]
    if word == CRASHED:
        broken: Optional[str] = assertion(failure.case.output)
        why = f"this assert did not hold: {broken}" if broken else _USUAL_CRASH
        return [("note", f"the program crashed ({detail}); {why}")]
    if word == ENDED_EARLY:
        return [("note", "the program ended before the test did, as after a call of exit()")]
    if word == EXCEPTION:
        return [("note", f"an exception came out: {detail}")]
    if word == NOT_RUN:
        return [("note", f"the test could not be run: {detail}")]
    output = failure.case.output
    words = catch_failure(output) or output.strip().splitlines()[-_TAIL_LINES:]
    return [("said", line) for line in words]


def _help_lines(lab: Lab, step: str) -> list[str]:
    again = f"./tumble test {lab.number}   or on every save: ./tumble watch {lab.number}"
    lines = labelled("again", again, _LABEL_WIDTH)
    if (lab.path / "hints.md").exists():
        lines += labelled("stuck?", f"./tumble hint {step}", _LABEL_WIDTH)
    return lines
