"""./tumble test N: the student's answer, step by step, then the first failure explained.

With --case it is one case, as it runs: see look_into.py.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Mapping, Sequence

from . import answer, build, ctest, look_into, runner, sanitized
from .console import BAD_USAGE, FAILED, Failure, coloured, labelled, mark, say
from .explained import (ASKED, LABEL_WIDTH, Checked, explained, help_lines, what_it_prints,
                        what_was_not_run)
from .labs import Lab, chosen_answers, find_lab
from .outcome import NOT_WRITTEN, PASS, explanation, outcome


def run(root: Path, options: argparse.Namespace) -> int:
    lab = find_lab(root, options.lab)
    if options.debug and options.case is None:
        raise Failure("--debug runs one case: add --case WORDS", BAD_USAGE)
    if options.answer is not None:
        if options.case is not None:
            raise Failure("--case runs your own answer: leave out --answer", BAD_USAGE)
        return test_answers(root, lab, options)
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


def test_answers(root: Path, lab: Lab, options: argparse.Namespace) -> int:
    """Right answers of the kit, each in a checklist of its own."""
    passed = True
    with build.locked(root, "dev"):
        for name in chosen_answers(root, lab, options.answer):
            target = f"{lab.name}_{name}_test"
            build.require(root, "dev", [target])
            program = build.build_folder(root, "dev") / "labs" / lab.folder / target
            checked = [_checked(case) for case in
                       runner.run_cases(program, f"{lab.folder}/{name}")]
            say(*checklist(lab, checked, f"answer {name}"), "")
            failures = [check for check in checked if check.outcome.word != PASS]
            passed = passed and not failures
            if failures:
                say(*_first_of(lab, failures, options.all), "")
    return 0 if passed else FAILED


def _look_closer(root: Path, lab: Lab) -> int:
    sys.stdout.flush()
    looked_at, findings = sanitized.first_finding(root, lab)
    if not findings:
        say(coloured("All done.", "green") + f" Look at it: ./tumble frames {lab.number}"
            f" and ./tumble chart {lab.number}")
        if not looked_at:
            say("(The sanitizers do not run here, so undefined behaviour was not looked for.)")
        return 0
    found = findings[0]
    check = _checked(found.case)
    lines = [coloured("All tests pass, but with undefined behaviour: ", "bold") + check.title]
    for label, text in explanation(check.case.output):
        if label in ASKED:
            lines += labelled(label, text, LABEL_WIDTH, wrap=False)
    if found.line:
        source = lab.stub.read_text(encoding="utf-8", errors="replace").splitlines()
        where = f"labs/{lab.folder}/{lab.stub.name}:{found.line}"
        lines += labelled("at", f"{where}\n{source[found.line - 1].strip()}", LABEL_WIDTH,
                          wrap=False)
    lines += labelled("note", found.what, LABEL_WIDTH)
    say(*lines, *help_lines(lab, check.step))
    return FAILED


def _checked(case: ctest.Case) -> Checked:
    _, _, step, title = case.name.split("/", 3)
    return Checked(step, title, case, outcome(case))


def checklist(lab: Lab, checked: Sequence[Checked], whose: str = "") -> list[str]:
    """One line a step: its sign, number, title, passed/all and the word for it."""
    titles: Mapping[str, str] = {**{check.step: "" for check in checked}, **lab.steps()}
    longest = max((len(title) for title in titles.values()), default=0)
    whose = whose or lab.where_to_write("")
    lines = [f"{coloured(lab.heading, 'bold')}    {coloured(whose, 'dim')}", ""]
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
        return _first_of(lab, failures, explain_all)
    first = min(open_cases, key=lambda check: _by_number(check.step))
    begun = len(open_cases) < len(checked)
    lines = ["So far, so good." if begun else "Nothing is written yet."]
    function = first.outcome.detail.split(" ")[-1]
    place = lab.where_to_write(first.outcome.detail)
    handout = f"labs/{lab.folder}/{lab.handout.name}"
    lines += labelled("next", f"write {function} of step {first.step} in {place}", LABEL_WIDTH)
    lines += labelled("read", f"step {first.step} of {handout}", LABEL_WIDTH)
    return lines + help_lines(lab, first.step)


def _first_of(lab: Lab, failures: Sequence[Checked], explain_all: bool) -> list[str]:
    shown = failures if explain_all else failures[:1]
    lines = []
    for number, failure in enumerate(shown):
        opening = "First failure: " if number == 0 else "Next failure: "
        lines += [coloured(opening + failure.title, "bold"), *explained(failure),
                  *what_it_prints(lab, failure), *what_was_not_run(failure, failures), ""]
    lines += help_lines(lab, failures[0].step)
    rest = len(failures) - len(shown)
    if rest:
        text = f"./tumble test {lab.number} --all   explains the other {rest}, too"
        lines += labelled("more", text, LABEL_WIDTH)
    return lines
