"""The labs there are: folders labs/<N>_<name>, their titles and steps as their handouts say."""

from __future__ import annotations

import re
from pathlib import Path
from typing import NamedTuple

from .console import BAD_USAGE, Failure

_FOLDER = re.compile(r"([1-9][0-9]*)_([a-z0-9_]+)")
_TITLE = re.compile(r"^# (?:Lab \d+: *)?(.+)$", re.MULTILINE)
_STEP = re.compile(r"^##+ Step (\d+\.\d+)[:.]? *(.*)$", re.MULTILINE)


class Lab(NamedTuple):
    number: int
    name: str
    path: Path

    @property
    def folder(self) -> str:
        return self.path.name

    @property
    def stub(self) -> Path:
        """The only file that a student edits."""
        return self.path / f"{self.name}.cpp"

    @property
    def handout(self) -> Path:
        return self.path / "README.md"

    @property
    def heading(self) -> str:
        return f"Lab {self.number}: {self.title}"

    @property
    def title(self) -> str:
        match = _TITLE.search(self._handout_text())
        return plain(match.group(1)) if match else self.name.replace("_", " ")

    def steps(self) -> dict[str, str]:
        """Step numbers and titles, in the handout's order."""
        return {number: plain(title) for number, title in _STEP.findall(self._handout_text())}

    def where_to_write(self, step_and_function: str) -> str:
        """The stub, with the line of the function that is not written yet where it is known."""
        stub = f"labs/{self.folder}/{self.stub.name}"
        for number, line in enumerate(_text(self.stub).splitlines(), 1):
            if f'NotImplemented("{step_and_function}")' in line:
                return f"{stub}:{number}"
        return stub

    @property
    def header(self) -> Path:
        return self.path / f"{self.name}.hpp"

    def step_of(self, function: str) -> str:
        """The step that asks for a function of the contract, as its tests say; "" if none does."""
        tests = [_text(path) for path in
                 sorted((self.path.parents[1] / "tests" / self.name).glob("*.[ch]pp"))]
        for text in tests:
            named = re.search(rf'"(\d+\.\d+) {re.escape(function)}\b', text)
            if named:
                return named.group(1)
        for text in tests:
            tag = re.search(r'"\[(\d+\.\d+)\]"', text)
            if tag and f'"{function}"' in text:
                return tag.group(1)
        return ""

    def declaration(self, function: str) -> str:
        """Where the header declares it, or ""."""
        for number, line in enumerate(_text(self.header).splitlines(), 1):
            if re.match(rf"[A-Za-z].*\b{re.escape(function)}\(", line):
                return f"labs/{self.folder}/{self.header.name}:{number}"
        return ""

    def functions_of(self, step: str) -> list[str]:
        """What a step asks for, in the header's order."""
        declared = re.findall(r"^[A-Za-z].*?\b(\w+)\(", _text(self.header), re.MULTILINE)
        return [name for name in dict.fromkeys(declared) if self.step_of(name) == step]

    def _handout_text(self) -> str:
        return _text(self.handout)


def find_labs(root: Path) -> list[Lab]:
    labs = []
    for path in root.glob("labs/*/"):
        match = _FOLDER.fullmatch(path.name)
        if match:
            labs.append(Lab(int(match.group(1)), match.group(2), path))
    return sorted(labs)


def find_lab(root: Path, number: str) -> Lab:
    labs = find_labs(root)
    for lab in labs:
        if number == str(lab.number):
            return lab
    known = ", ".join(f"{lab.number} ({lab.title})" for lab in labs) or "none"
    raise Failure(f"there is no lab {printable(number)}; the labs are: {known}", BAD_USAGE)


def is_handout(root: Path) -> bool:
    """A students' hand-out ships without solutions/."""
    return not any(root.glob("solutions/*/*.cpp"))


def answers(root: Path, lab: Lab) -> list[str]:
    """The names of the kit's right answers, the reference first."""
    others = sorted(path.stem for path in (root / "solutions" / lab.folder).glob("*.cpp"))
    return ["reference", *(name for name in others if name != lab.name)]


def chosen_answers(root: Path, lab: Lab, names: str) -> list[str]:
    """From "NAME,NAME" as typed; "student" is the stub as it is filled in."""
    require_solutions(root, "another answer")
    known = ["student", *answers(root, lab)]
    chosen = names.split(",")
    for name in chosen:
        if name not in known:
            raise Failure(f"--answer: lab {lab.number} has no {printable(name)}; it has "
                          + ", ".join(known), BAD_USAGE)
    if len(set(chosen)) < len(chosen):
        raise Failure(f"--answer: {printable(names)} names an answer twice", BAD_USAGE)
    return chosen


def require_solutions(root: Path, what: str) -> None:
    if is_handout(root):
        raise Failure(f"{what} needs the solutions, but this is a hand-out, which has none")


def printable(text: str) -> str:
    """What the user typed, quoted, on one line and not too long."""
    return repr(text if len(text) <= 40 else text[:40] + "...")


def plain(markdown: str) -> str:
    return re.sub(r"[`*$]", "", markdown).strip()


def _text(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8", errors="replace")
    except FileNotFoundError:
        return ""
