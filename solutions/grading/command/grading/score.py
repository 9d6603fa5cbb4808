"""From what the judge saw to points by step. No word of the student's program gets through here."""

from __future__ import annotations

import re
from typing import Mapping, NamedTuple, Sequence

from ..labs import Lab
from .points import FULL, Table
from .verdicts import (BLOCKED, CRASH, GRADER_ERROR, NO_BUILD, NOT_WRITTEN, PASS, WORDS,
                       CaseOutcome, Judged)

GRADED = "graded"
MISSING = "not handed in"
REFUSED = "cannot be read"
SANITIZERS = "sanitizers"

_SIGNAL = re.compile(r"\bSIG[A-Z]{2,6}\b")
_BLOCKED = re.compile(re.escape(BLOCKED) + r"\d+\.\d+")
_TEXT_LIMIT = 4096
_FLAWS = (
    "heap-buffer-overflow", "stack-buffer-overflow", "global-buffer-overflow",
    "container-overflow", "heap-use-after-free", "stack-use-after-scope",
    "stack-use-after-return", "double-free", "stack-overflow", "signed integer overflow",
    "division by zero", "null pointer", "out of bounds", "misaligned address",
    "outside the range of representable values", "not a valid value", "shift exponent",
    "reached the end of a value-returning function", "leaked")
_LINE = re.compile(r"\b(\w+\.cpp):(\d{1,5})\b")


class Case(NamedTuple):
    title: str
    word: str
    signal: str = ""
    likely: str = ""


class StepResult(NamedTuple):
    step: str
    title: str
    points: int
    bonus: bool
    word: str
    cases: Sequence[Case]

    @property
    def earned(self) -> int:
        return self.points if self.word == PASS else 0


class LabResult(NamedTuple):
    """What a student may see of one lab, and beneath it what only graders may."""

    folder: str
    heading: str
    status: str
    problem: str
    steps: Sequence[StepResult]
    deduction: int = 0
    flaw: str = ""
    """What the sanitizers found, in fixed words."""
    diagnostics: str = ""
    notes: Sequence[str] = ()
    sandboxed: bool = True
    remarks: Sequence[str] = ()
    """For graders alone."""

    @property
    def score(self) -> int:
        return max(0, sum(step.earned for step in self.steps) + self.deduction)

    @property
    def most(self) -> int:
        return FULL


def ungraded(lab: Lab, table: Table, status: str, problem: str, notes: Sequence[str] = (),
             remarks: Sequence[str] = ()) -> LabResult:
    """No case was run: no points, and the reason."""
    return LabResult(lab.folder, lab.heading, status, problem, _no_steps(lab, table, status),
                     notes=list(notes), remarks=list(remarks))


def _no_steps(lab: Lab, table: Table, word: str) -> list[StepResult]:
    titles = lab.steps()
    return [StepResult(number, titles[number], step.points, step.bonus, word, [])
            for number, step in table.steps.items()]


def graded(lab: Lab, table: Table, expected: Sequence[tuple[str, str]], judged: Judged,
           seeds: int, notes: Sequence[str] = ()) -> LabResult:
    """Points for a step if every case of it passed under every seed."""
    remarks = list(judged.notes)
    if not judged.compiled:
        return ungraded(lab, table, NO_BUILD, "no test could be run", notes, remarks)._replace(
            diagnostics=clean(judged.diagnostics), sandboxed=judged.sandboxed)
    error = disagreement(expected, judged.cases, seeds)
    if error:
        return ungraded(lab, table, GRADER_ERROR,
                        "the grader failed on this file; this is not your mistake", notes,
                        [*remarks, error])._replace(sandboxed=judged.sandboxed)
    if judged.sanitizer:
        remarks.append(f"{SANITIZERS}: {clean(judged.sanitizer)}")
    flaw = fixed_words(judged.sanitizer, lab.stub.name)
    return LabResult(lab.folder, lab.heading, GRADED, "", _steps(lab, table, judged.cases),
                     table.undefined_behaviour if judged.sanitizer else 0, flaw,
                     clean(judged.diagnostics), list(notes), judged.sandboxed, remarks)


def disagreement(expected: Sequence[tuple[str, str]], cases: Sequence[CaseOutcome],
                 seeds: int) -> str:
    """Each expected case once, or once a seed, and nothing else; or what is wrong."""
    counts: dict[tuple[str, str], int] = {case: 0 for case in expected}
    for case in cases:
        if (case.step, case.case) not in counts:
            return f"the judge reports a case that the tests do not have: {case.step} {case.case}"
        if case.word not in WORDS and not _BLOCKED.fullmatch(case.word):
            return f"the judge gives the unknown word '{case.word}': {case.step} {case.case}"
        if case.word == GRADER_ERROR:
            return f"the judge failed on {case.step} {case.case}: {case.detail}"
        counts[case.step, case.case] += 1
    if len(set(counts.values())) != 1 or not set(counts.values()) <= {1, seeds}:
        odd = next((f"{step} {title}: {count}" for (step, title), count in counts.items()
                    if count not in (1, seeds)), "some once, some several times")
        return f"the judge does not have every case once or {seeds} times: {odd}"
    return ""


def _steps(lab: Lab, table: Table, outcomes: Sequence[CaseOutcome]) -> list[StepResult]:
    words: dict[str, str] = {}
    steps = []
    titles = lab.steps()
    for number, step in table.steps.items():
        cases = _cases([outcome for outcome in outcomes if outcome.step == number])
        words[number] = _word(cases, step.depends_on, words)
        steps.append(StepResult(number, titles[number], step.points, step.bonus, words[number],
                                cases))
    return steps


def _cases(outcomes: Sequence[CaseOutcome]) -> list[Case]:
    """One line a case; of its seeds, the first that does not pass."""
    chosen: dict[str, CaseOutcome] = {}
    for outcome in outcomes:
        if outcome.case not in chosen or chosen[outcome.case].word == PASS:
            chosen[outcome.case] = outcome
    return [Case(title, outcome.word, _signal(outcome), clean(outcome.likely, 300))
            for title, outcome in sorted(chosen.items())]


def _signal(outcome: CaseOutcome) -> str:
    match = _SIGNAL.search(outcome.detail)
    return match.group() if match and outcome.word == CRASH else ""


def _word(cases: Sequence[Case], depends_on: Sequence[str], earlier: Mapping[str, str]) -> str:
    """The first failure; "not written yet" only where nothing else fails."""
    failures = [case.word for case in cases if case.word != PASS]
    if not failures:
        return PASS if cases else GRADER_ERROR
    told = [word for word in failures if word != NOT_WRITTEN]
    blocking = [step for step in depends_on if earlier.get(step) != PASS]
    if told and blocking:
        return BLOCKED + blocking[0]
    return told[0] if told else NOT_WRITTEN


def fixed_words(report: str, stub: str) -> str:
    """The kind of flaw and the line, and nothing that a program could write into its report."""
    if not report:
        return ""
    kind = next((flaw for flaw in _FLAWS if flaw in report), "undefined behaviour")
    line = next((match for match in _LINE.finditer(report) if match.group(1) == stub), None)
    return kind + (f", {stub} line {line.group(2)}" if line else "")


def clean(text: str, limit: int = _TEXT_LIMIT) -> str:
    """Printable, the same at each run, and not too long."""
    text = re.sub(r"\x1b\[[0-9;]*[A-Za-z]", "", text)
    text = "".join(c if c.isprintable() or c in "\n\t" else "?" for c in text)
    text = re.sub(r"0x[0-9a-f]{6,}", "0x...", re.sub(r"==\d+==", "==", text)).strip()
    return text if len(text) <= limit else text[:limit] + "\n... and more"
