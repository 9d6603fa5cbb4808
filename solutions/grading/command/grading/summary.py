"""The class: a table for spreadsheets and a page for graders, from all records in the folder."""

from __future__ import annotations

import fcntl
import statistics
import urllib.parse
from html import escape
from pathlib import Path
from typing import Mapping, Sequence

from ..labs import Lab
from .files import RECORDS, csv_text, read_record, write
from .report import page
from .score import GRADED, MISSING, SANITIZERS, LabResult
from .verdicts import PASS

_BINS = 10
Class = Mapping[str, Mapping[str, LabResult]]
"""Student, then lab folder."""


def write_summary(out: Path, labs: Sequence[Lab]) -> None:
    """Shards that end together take turns, so the last one tells of all."""
    with open(out / RECORDS / "lock", "w", encoding="ascii") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        everyone = read_class(out, labs)
        write(out / "class.csv", csv_text(table(everyone, labs)))
        write(out / "index.html", class_page(everyone, labs))


def read_class(out: Path, labs: Sequence[Lab]) -> Class:
    folders = {lab.folder for lab in labs}
    students = sorted(file.stem for file in (out / RECORDS).glob("*.json"))
    records = {student: {folder: entry["result"] for folder, entry in
                         read_record(out, student).items() if folder in folders}
               for student in students}
    return {student: results for student, results in records.items() if results}


def table(everyone: Class, labs: Sequence[Lab]) -> list[list[object]]:
    columns: list[object] = ["student", "total", "out of"]
    for lab in labs:
        columns += [f"lab {lab.number}", f"lab {lab.number} status", *lab.steps()]
    rows = [[*columns, "remarks"]]
    for student, results in everyone.items():
        known = [results[lab.folder] for lab in labs if lab.folder in results]
        row: list[object] = [student, sum(result.score for result in known),
                             sum(result.most for result in known)]
        for lab in labs:
            result = results.get(lab.folder)
            if result is None:
                row += [""] * (2 + len(lab.steps()))
            else:
                row += [result.score, result.status, *(step.earned for step in result.steps)]
        rows.append([*row, remarks(known)])
    return rows


def remarks(results: Sequence[LabResult]) -> str:
    """On one line, what a human should look at."""
    words: list[str] = []
    for result in results:
        if result.problem and result.status != MISSING:
            words.append(result.problem)
        words += result.notes
        words += [result.flaw] if result.flaw else []
        words += [] if result.sandboxed else ["not sandboxed"]
        words += [remark.split("\n", 1)[0] for remark in result.remarks
                  if not remark.startswith(SANITIZERS)]
    return "; ".join(dict.fromkeys(words))


def class_page(everyone: Class, labs: Sequence[Lab]) -> str:
    seen = [lab for lab in labs if any(lab.folder in results for results in everyone.values())]
    charts = "".join(_lab_chart(lab, [results[lab.folder] for results in everyone.values()
                                      if lab.folder in results]) for lab in seen)
    body = (f'<h1>Class</h1><p class="lede">{len(everyone)} submissions. This page and class.csv '
            "are for graders; each student gets the folder of their name.</p>"
            f'<section><div class="charts">{charts}</div></section>'
            f'<section><div class="scroll">{_students(everyone, seen)}</div></section>')
    return page("Tumble: class", body).replace("<body>", '<body class="wide">')


def _lab_chart(lab: Lab, results: Sequence[LabResult]) -> str:
    scores = [result.score for result in results if result.status != MISSING]
    said = "nobody handed it in"
    if scores:
        said = (f"{len(scores)} handed in, median {statistics.median(scores):g}, "
                f"mean {statistics.fmean(scores):.1f} of {results[0].most} points")
    return (f"<div><h2>{escape(lab.heading)}</h2><p>{said}</p>{histogram(scores)}"
            f"<h3>Students who passed each step</h3>{_steps(results)}</div>")


def histogram(scores: Sequence[int]) -> str:
    """Ten columns of ten points; 100 and what is beyond stand in the last one."""
    counts = [0] * _BINS
    for score in scores:
        counts[min(score * _BINS // 100, _BINS - 1)] += 1
    tallest = max(counts + [1])
    label = ", ".join(f"{10 * i} to {10 * i + 9 if i < 9 else 100}: {count}"
                      for i, count in enumerate(counts))
    parts = [f'<svg viewBox="0 0 470 150" role="img" aria-label="Scores: {label}">',
             '<line x1="0" y1="120.5" x2="470" y2="120.5"/>']
    for i, count in enumerate(counts):
        height = 100.0 * count / tallest
        middle = 47 * i + 23
        if count:
            parts.append(f'<rect class="column" x="{47 * i + 3}" y="{120 - height:.1f}" width="41" '
                         f'height="{height:.1f}" rx="3"/><text class="count" x="{middle}" '
                         f'y="{115 - height:.1f}" text-anchor="middle">{count}</text>')
        parts.append(f'<text x="{middle}" y="138" text-anchor="middle">'
                     f'{10 * i}–{10 * i + 9 if i < 9 else 100}</text>')
    return "".join(parts) + "</svg>"


def _steps(results: Sequence[LabResult]) -> str:
    """Bars: the share of those who handed in that has each step."""
    handed_in = [result for result in results if result.status != MISSING]
    rows = handed_in[0].steps if handed_in else []
    parts = [f'<svg viewBox="0 0 420 {24 * len(rows) + 4}" role="img" aria-label="Steps done">']
    for i, row in enumerate(rows):
        done = sum(result.steps[i].word == PASS for result in handed_in)
        width = 320.0 * done / len(handed_in)
        parts.append(f'<text x="0" y="{24 * i + 17}">{row.step}</text>'
                     f'<rect class="column" x="40" y="{24 * i + 4}" width="{width:.1f}" '
                     f'height="16" rx="3"/>'
                     f'<text class="count" x="{46 + width:.1f}" y="{24 * i + 17}">'
                     f'{100 * done / len(handed_in):.0f} %</text>')
    return "".join(parts) + "</svg>"


def _students(everyone: Class, labs: Sequence[Lab]) -> str:
    heads = "".join(f'<th class="figure">Lab {lab.number}</th><th>Status</th>' for lab in labs)
    rows = []
    for student, results in everyone.items():
        link = urllib.parse.quote(student)
        cells = "".join(_cells(results.get(lab.folder)) for lab in labs)
        rows.append(f'<tr><td><a href="{link}/index.html">{escape(student)}</a></td>{cells}'
                    f'<td class="remarks">{escape(remarks(list(results.values())))}</td></tr>')
    return (f"<table><thead><tr><th>Student</th>{heads}<th>Remarks</th></tr></thead>"
            f"<tbody>{''.join(rows)}</tbody></table>")


def _cells(result: LabResult | None) -> str:
    if result is None:
        return '<td class="figure"></td><td></td>'
    status = "" if result.status == GRADED else result.status
    return f'<td class="figure">{result.score}</td><td>{escape(status)}</td>'
