"""Meets every entry of a submission and keeps the wanted files."""

from __future__ import annotations

import base64
import re
from typing import BinaryIO, Callable

FILE_LIMIT = 256 * 1024
_ENTRY_LIMIT = 20000


class Problem(Exception):
    """Why a submission, or one file of it, cannot be taken."""


def shown(name: str) -> str:
    """A name as it stands in a message: on one line, whatever it holds."""
    plain = "".join(c if c.isprintable() and c not in "\u202e\u202d" else "?" for c in name)
    return f"'{plain if len(plain) <= 80 else plain[:77] + '...'}'"


class Finder:
    """Meets every entry of a submission and keeps those that bear a wanted name."""

    def __init__(self, names: list[str]):
        self.found: dict[str, list[tuple[str, bytes, str]]] = {name: [] for name in names}
        self.others: list[str] = []
        self.odd: list[str] = []
        self.count = 0

    def meet(self, where: str, problem: str, read: Callable[[], bytes]) -> None:
        self.count += 1
        if self.count > _ENTRY_LIMIT:
            raise Problem(f"it has more than {_ENTRY_LIMIT} entries")
        parts = re.split(r"[/\\]", where.rstrip("/\\"))
        leads_out = where.startswith(("/", "\\")) or ".." in parts
        if leads_out:
            self.odd.append(where)
            problem = problem or "its path leads out of the archive"
        if parts[-1] in self.found:
            self._keep(parts[-1], where, problem, read)
        elif parts[-1].lower().endswith((".cpp", ".cc", ".hpp", ".h", ".txt")):
            self.others.append(where)

    def _keep(self, name: str, where: str, problem: str, read: Callable[[], bytes]) -> None:
        text = b""
        if not problem:
            try:
                text = read()
            except Problem as error:
                problem = str(error)
        self.found[name].append((where, text, problem))

    def result(self) -> dict[str, object]:
        files = {name: self._one(name) for name in self.found}
        notes = []
        if self.odd:
            notes.append(f"paths that lead out of the archive were ignored: {shown(self.odd[0])}"
                         + (f" and {len(self.odd) - 1} more" if len(self.odd) > 1 else ""))
        return {"files": files, "notes": notes}

    def _one(self, name: str) -> dict[str, str]:
        found = self.found[name]
        if not found:
            near = [path for path in self.others if path.lower().endswith(name.lower())]
            hint = f"; there is {shown(near[0])}" if near else ""
            return {"missing": f"there is no {name} in the submission{hint}"}
        if len(found) > 1:
            places = " and ".join(shown(where) for where, _, _ in found[:2])
            return {"problem": f"the submission has {name} {len(found)} times: {places}"}
        where, text, problem = found[0]
        if problem:
            return {"problem": f"{shown(where)}: {problem}"}
        return {"text": base64.b64encode(text).decode("ascii")}


def bounded(stream: BinaryIO, size: int = -1) -> bytes:
    """All of it, or the problem; of a file that claims to be small, too, no more is read."""
    if size > FILE_LIMIT:
        raise Problem(f"it is longer than {FILE_LIMIT // 1024} KiB")
    text = stream.read(FILE_LIMIT + 1)
    if len(text) > FILE_LIMIT:
        raise Problem(f"it is longer than {FILE_LIMIT // 1024} KiB")
    if 0 <= size != len(text):
        raise Problem("it is cut short")
    return text
