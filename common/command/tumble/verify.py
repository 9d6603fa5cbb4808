"""./tumble verify: the proof that the kit's tests accept right answers and nothing else."""

from __future__ import annotations

import argparse
import shutil
from pathlib import Path
from typing import NamedTuple, Sequence

from . import build, ctest, packages
from .console import FAILED, coloured, mark, say, shortened
from .labs import Lab, find_labs, plain

COLUMNS = ("stub fails", "right passes", "NaN fails", "mistakes caught")
_KIND_OF = {"stub": 0, "nan": 2, "mistake": 3}
_RIGHT = 1
_OUTPUT_LIMIT = 3000
_WITHOUT_SANITIZERS = "^kit/(architecture|command|grading)/"
"""Python and CMake: sanitizers do not see into them. The preset `sanitize` leaves them out, too."""


class Count(NamedTuple):
    good: int = 0
    all: int = 0

    def __str__(self) -> str:
        return f"{self.good}/{self.all}" if self.all else "-"

    def plus(self, other: Count) -> Count:
        return Count(self.good + other.good, self.all + other.all)


Row = Sequence[Count]


def run(root: Path, options: argparse.Namespace) -> int:
    if not options.no_install:
        packages.install_missing(root)
    code = _prove(root, "ci", ["-LE", "^student$" if options.all else "^(student|long)$"])
    if not options.all:
        return code
    return _prove_by_sanitizers(root) or code


def _prove_by_sanitizers(root: Path) -> int:
    if not shutil.which("clang++"):
        say("The sanitizers were not run, because clang++ is missing: install clang, and "
            "libclang-rt-14-dev or libclang-rt-19-dev.")
        return FAILED
    say(coloured("Under clang's address and undefined-behaviour sanitizers", "bold"))
    return _prove(root, "sanitize", ["-L", "^(right|kit)$", "-E", _WITHOUT_SANITIZERS])


def _prove(root: Path, preset: str, selection: Sequence[str]) -> int:
    with build.locked(root, preset):
        build.configure(root, preset, again=True)  # no-gl shares the folder of ci and proves less
        build.require(root, preset)
        tests = ctest.run_tests(build.build_folder(root, preset), selection)
    say(*table(find_labs(root), tests.cases), *kit_lines(tests.cases),
        *failure_lines(tests.cases), tests.summary)
    return tests.code


def table(labs: Sequence[Lab], cases: Sequence[ctest.Case]) -> list[str]:
    """A block a lab, a row a step; each cell counts how many tests did what they must."""
    lines: list[str] = []
    for lab in labs:
        counts = _count_steps(lab, cases)
        titles = lab.steps()
        rows = [(f"{step}  {titles.get(step, '')}".rstrip(), counts[step]) for step in sorted(
            counts, key=lambda step: [int(part) for part in step.split(".")])]
        if rows:
            rows.append(("all", _total([row for _, row in rows])))
            lines += _block(lab.heading, rows)
    return lines


def _count_steps(lab: Lab, cases: Sequence[ctest.Case]) -> dict[str, Row]:
    counts: dict[str, list[Count]] = {}
    for case in cases:
        folder, _, rest = case.name.partition("/")
        parts = rest.split("/", 2)
        if folder == lab.folder and len(parts) == 3:
            row = counts.setdefault(parts[1], [Count()] * len(COLUMNS))
            column = _KIND_OF.get(parts[0], _RIGHT)
            row[column] = row[column].plus(Count(int(case.passed), 1))
    return dict(counts)


def _total(rows: Sequence[Row]) -> Row:
    total = [Count()] * len(COLUMNS)
    for row in rows:
        total = [sum_.plus(count) for sum_, count in zip(total, row)]
    return total


def _block(heading: str, rows: Sequence[tuple[str, Row]]) -> list[str]:
    name_width = max([len(name) for name, _ in rows] + [len(heading)])
    columns = "".join(f"  {name}" for name in COLUMNS)
    lines = [coloured(f"{heading:<{name_width}}", "bold") + columns]
    for name, row in rows:
        cells = [f"  {str(count):>{len(column)}}" for count, column in zip(row, COLUMNS)]
        marked = [cell if count.good == count.all else coloured(cell, "red")
                  for cell, count in zip(cells, row)]
        lines.append(f"{name:<{name_width}}" + "".join(marked) + f"  {_sign(row)}")
    return lines + [""]


def _sign(row: Row) -> str:
    whole = all(count.good == count.all for count in row)
    return coloured(mark("done"), "green") if whole else coloured(mark("wrong"), "red")


def kit_lines(cases: Sequence[ctest.Case]) -> list[str]:
    """One line a group of the kit's own tests, named kit/<group>/<case>."""
    groups: dict[str, Count] = {}
    for case in cases:
        parts = case.name.split("/", 2)
        if parts[0] == "kit" and not case.skipped:
            group = parts[1] if len(parts) > 1 else ""
            groups[group] = groups.get(group, Count()).plus(Count(int(case.passed), 1))
    if not groups:
        return []
    name_width = max(map(len, groups))
    return [coloured("The kit's own tests", "bold")] + [
        f"  {name:<{name_width}}  {str(count):>7}  {_sign([count])}"
        for name, count in sorted(groups.items())] + skipped_lines(cases) + [""]


def skipped_lines(cases: Sequence[ctest.Case]) -> list[str]:
    return [f"  skipped: {case.name}" for case in cases if case.skipped]


def failure_lines(cases: Sequence[ctest.Case]) -> list[str]:
    lines = []
    for case in cases:
        if not case.passed and not case.skipped:
            why = case.reason or case.status
            lines += [coloured(f"{case.name} ({plain(why)})", "red"),
                      shortened(case.output.strip(), _OUTPUT_LIMIT), ""]
    return lines
