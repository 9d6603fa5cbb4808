"""The table of points of a lab, solutions/<N>_<name>/points.json:

    {"undefined_behaviour": -10,
     "steps": {"2.1": {"points": 12},
               "2.8": {"points": 15, "bonus": true, "depends_on": ["2.1"]}}}

The points of a lab are 100; those of a bonus step come on top. Where a step and one that it depends
on both fail, the later one is shown as blocked: it may be right. undefined_behaviour, zero or less,
is added where the sanitizers find something.
"""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Mapping, NamedTuple, Sequence

from ..console import Failure
from ..labs import Lab, find_labs

FULL = 100

_CASE = re.compile(r'TEST_CASE\(\s*"([^"]*)",\s*"\[([0-9.]+)\]"\s*\)')


class Step(NamedTuple):
    points: int
    bonus: bool = False
    depends_on: Sequence[str] = ()


class Table(NamedTuple):
    steps: Mapping[str, Step]
    undefined_behaviour: int = 0

    @property
    def bonus(self) -> int:
        return sum(step.points for step in self.steps.values() if step.bonus)


def table_file(root: Path, lab: Lab) -> Path:
    return root / "solutions" / lab.folder / "points.json"


def graded_labs(root: Path) -> list[Lab]:
    return [lab for lab in find_labs(root) if table_file(root, lab).exists()]


def read_table(root: Path, lab: Lab) -> Table:
    """Checked: a wrong table must not grade anyone."""
    file = table_file(root, lab)
    try:
        content = json.loads(file.read_text(encoding="utf-8"))
        steps = {number: Step(row.pop("points"), row.pop("bonus", False),
                              row.pop("depends_on", []), **row)
                 for number, row in content.pop("steps").items()}
        table = Table(steps, content.pop("undefined_behaviour", 0), **content)
    except (OSError, ValueError, KeyError, AttributeError, TypeError) as error:
        raise Failure(f"the table of points {file} cannot be read: {error}") from error
    flaw = _flaw(table, lab.steps())
    if flaw:
        raise Failure(f"the table of points {file} is wrong: {flaw}")
    return table


def _flaw(table: Table, titles: Mapping[str, str]) -> str:
    if list(table.steps) != list(titles):
        return f"it has the steps {', '.join(table.steps)}; the handout has {', '.join(titles)}"
    for number, step in table.steps.items():
        if not _is_count(step.points) or step.points == 0 or not isinstance(step.bonus, bool):
            return f"step {number} needs points above zero, and bonus true or false"
        for other in step.depends_on:
            if other not in table.steps or _order(other) >= _order(number):
                return f"step {number} depends on {other}, which is not an earlier step"
        if step.bonus != titles[number].startswith("Challenge"):
            return f"step {number} must be a bonus if the handout calls it a challenge, else not"
    total = sum(step.points for step in table.steps.values() if not step.bonus)
    if total != FULL:
        return f"its points add up to {total}, not to {FULL}"
    if not _is_count(-table.undefined_behaviour):
        return "undefined_behaviour must be a whole number, zero or less"
    return ""


def _is_count(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and value >= 0


def _order(step: str) -> list[int]:
    return [int(part) for part in step.split(".")]


def expected_cases(root: Path, lab: Lab) -> list[tuple[str, str]]:
    """Step and title of every test case, from the sources, as CMake reads them."""
    found = [(step, title) for file in sorted(root.glob(f"tests/{lab.name}/*_test.cpp"))
             for title, step in _CASE.findall(file.read_text(encoding="utf-8"))]
    if not found:
        raise Failure(f"there are no test cases in tests/{lab.name}")
    return sorted(found, key=lambda case: (_order(case[0]), case[1]))
