"""A student's page: one file, no script, readable on a telephone and at night."""

from __future__ import annotations

from html import escape
from pathlib import Path
from typing import Sequence

from .gradescope import flaw_line, step_lines
from .score import GRADED, LabResult, StepResult
from .verdicts import NOT_WRITTEN, PASS

_HOW = """<footer><p>You get the points of a step if all its tests pass twice, each time with random
inputs other than those of <code>./tumble test</code>. The tests are the same.</p>
<p>If a test passes on your machine and fails here, the usual causes are numbers copied from a test,
memory that is read before it is written, and an index out of range.</p></footer>"""
_TEMPLATE = Path(__file__).with_name("page.html")


def page(title: str, body: str) -> str:
    template = _TEMPLATE.read_text(encoding="utf-8")
    return template.replace("<!-- title -->", escape(title)).replace("<!-- body -->", body)


def student_page(student: str, labs: Sequence[LabResult]) -> str:
    total = ""
    if len(labs) > 1:
        total = (f'<p class="lede">{sum(lab.score for lab in labs)} of '
                 f"{sum(lab.most for lab in labs)} points in {len(labs)} labs</p>")
    sections = "".join(_lab(lab) for lab in labs)
    return page(f"Tumble: {student}", f"<h1>{escape(student)}</h1>{total}{sections}{_HOW}")


def _lab(lab: LabResult) -> str:
    number = lab.heading.split(":", 1)[0]
    parts = [f'<section><header><div><p class="number">{escape(number)}</p>'
             f"<h2>{escape(_capital(lab.heading.split(':', 1)[-1].strip()))}</h2></div>",
             f'<p class="score"><b>{lab.score}</b> of {lab.most} points</p></header>',
             _bar(lab.steps)]
    if lab.status != GRADED:
        parts.append(f'<p class="alarm">{escape(_capital(lab.status))}: {escape(lab.problem)}.</p>')
    if not lab.sandboxed:
        parts.append('<p class="alarm">Graded without the sandbox: only a preview.</p>')
    parts += [f'<p class="alarm">{escape(_capital(note))}.</p>' for note in lab.notes]
    if lab.flaw:
        parts.append(f'<p class="alarm">{escape(flaw_line(lab)).replace("-", "−", 1)}</p>')
    if lab.diagnostics:
        parts.append("<h3>The compiler says</h3>"
                     f'<pre tabindex="0">{escape(lab.diagnostics)}</pre>')
    if lab.status == GRADED:
        parts.append('<ol class="steps">' + "".join(map(_step, lab.steps)) + "</ol>")
    return "".join(parts) + "</section>"


def _bar(steps: Sequence[StepResult]) -> str:
    """As wide as the points of each step; what is earned is filled."""
    parts = "".join(f'<i class="{"full" if step.word == PASS else "open"}" '
                    f'style="flex-grow:{step.points}"></i>' for step in steps)
    return f'<div class="bar" aria-hidden="true">{parts}</div>'


def _step(step: StepResult) -> str:
    done = step.word == PASS
    sign = "✓" if done else "·" if step.word == NOT_WRITTEN else "✗"
    bonus = ' <span class="bonus">bonus</span>' if step.bonus else ""
    lines = step_lines(step)
    more = "".join(f"<li>{_with_likely(line)}</li>" for line in lines[1:])
    said = "" if done else f'<p class="word">{escape(lines[0])}</p>'
    return (f'<li class="{"done" if done else "failed"}"><span class="sign">{sign}</span>'
            f'<div><p class="title"><span class="number">{escape(step.step)}</span> '
            f"{escape(step.title)}{bonus}</p>{said}"
            + (f"<ul>{more}</ul>" if more else "") + "</div>"
            f'<p class="points"><b>{step.earned}</b>/{step.points}</p></li>')


def _with_likely(line: str) -> str:
    said, _, likely = line.partition("; likely: ")
    hint = f'<span class="likely">Likely: {escape(likely)}</span>' if likely else ""
    return f"{escape(_capital(said))}{hint}"


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]
