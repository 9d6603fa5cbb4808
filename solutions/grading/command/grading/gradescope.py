"""A student's results as Gradescope reads them: https://gradescope-autograders.readthedocs.io."""

from __future__ import annotations

from typing import Sequence

from .score import GRADED, LabResult, StepResult
from .verdicts import BLOCKED, NOT_WRITTEN, PASS

_UNBOXED = "Graded without the sandbox: this result is only a preview."


def results(labs: Sequence[LabResult]) -> dict:
    """One test a step. The top score is given, so that no number of tests has to add up."""
    tests = [_step(step, lab) for lab in labs for step in lab.steps]
    tests += [_deduction(lab) for lab in labs if lab.deduction]
    return {
        "score": sum(lab.score for lab in labs),
        "output": "\n\n".join(summary(lab) for lab in labs),
        "output_format": "text",
        "test_output_format": "text",
        "test_name_format": "text",
        "visibility": "visible",
        "stdout_visibility": "hidden",
        "tests": tests,
        "extra_data": {"labs": [{"folder": lab.folder, "score": lab.score, "status": lab.status,
                                 "sandboxed": lab.sandboxed} for lab in labs]},
    }


def summary(lab: LabResult) -> str:
    lines = [f"{lab.heading}: {lab.score} of {lab.most} points"]
    if lab.status != GRADED:
        lines.append(f"{lab.status}: {lab.problem}")
    lines += lab.notes
    if lab.flaw:
        lines.append(flaw_line(lab))
    if not lab.sandboxed:
        lines.append(_UNBOXED)
    if lab.diagnostics:
        lines += ["", "The compiler says:", lab.diagnostics]
    return "\n".join(lines)


def flaw_line(lab: LabResult) -> str:
    return (f"{lab.deduction} points: the sanitizers found undefined behaviour ({lab.flaw}). "
            "The answers of such a program are a matter of chance.")


def step_lines(step: StepResult) -> list[str]:
    """What became of the step, in words that are safe to show."""
    passed = sum(case.word == PASS for case in step.cases)
    if not step.cases or (step.word == NOT_WRITTEN and not passed):
        return [step.word]
    lines = [f"{passed} of {len(step.cases)} tests pass"]
    if step.word.startswith(BLOCKED):
        lines.append(f"{step.word}: correct that step first; this one may be right")
    told = {""}
    for case in step.cases:
        if case.word != PASS:
            signal = f" ({case.signal})" if case.signal else ""
            likely = f"; likely: {case.likely}" if case.likely not in told else ""
            told.add(case.likely)
            lines.append(f"{case.word}{signal}: {case.title}{likely}")
    return lines


def _step(step: StepResult, lab: LabResult) -> dict:
    return {
        "name": step.title + (" (bonus)" if step.bonus else ""),
        "number": step.step,
        "score": step.earned,
        "max_score": step.points,
        "status": "passed" if step.word == PASS else "failed",
        "output": "\n".join(step_lines(step)),
        "visibility": "visible",
        "tags": [lab.folder],
    }


def _deduction(lab: LabResult) -> dict:
    return {"name": "No undefined behaviour", "score": lab.deduction, "max_score": 0,
            "status": "failed", "output": flaw_line(lab), "visibility": "visible",
            "tags": [lab.folder]}
