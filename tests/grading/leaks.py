"""Finds answers in a folder: lines in a row that stand in a solution and not in its stub."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Iterator

ROW = 3
"""Two lines in a row may agree by chance, as a loop and its first line do."""

_COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)

Rows = dict[tuple[str, ...], set[str]]


def answers(root: Path) -> Rows:
    """Every row of every answer and mistake below solutions/, and which files hold it."""
    rows: Rows = {}
    for path in (root / "solutions").rglob("*.[ch]pp"):
        folder = path.relative_to(root / "solutions").parts[0]
        if not folder[0].isdigit():
            continue
        given = {line for contract in (root / "labs" / folder).glob(f"{folder.split('_', 1)[1]}.*")
                 for line in _code(contract)}
        for row in _rows(path):
            if not given.issuperset(row):
                rows.setdefault(row, set()).add(path.relative_to(root).as_posix())
    return rows


def leaks(folder: Path, known: Rows) -> dict[str, set[str]]:
    """Files below the folder with a row of an answer, and whose it is."""
    found: dict[str, set[str]] = {}
    for path in sorted(folder.rglob("*")):
        if path.suffix in (".cpp", ".hpp", ".md", ".txt", ".cmake", ".py"):
            for row in _rows(path):
                if row in known:
                    found.setdefault(path.relative_to(folder).as_posix(), set()).update(known[row])
    return found


def _rows(path: Path) -> Iterator[tuple[str, ...]]:
    lines = _code(path)
    return (tuple(lines[i:i + ROW]) for i in range(len(lines) - ROW + 1))


def _code(path: Path) -> list[str]:
    """Lines without comments, blanks, includes and brackets that stand alone."""
    text = _COMMENT.sub("", path.read_text(encoding="utf-8", errors="replace"))
    lines = (re.sub(r"\s+", "", line) for line in text.splitlines())
    return [line for line in lines if len(line) > 3 and not line.startswith(("#", "using"))]
