"""What the compiler and the linker say, as far as it is about the student's file."""

from __future__ import annotations

import re
from typing import NamedTuple, Sequence

from .console import shortened
from .labs import Lab

_MESSAGE = re.compile(r"(\S[^:]*):(\d+):(?:\d+:)? (warning|(?:fatal )?error|note): (.+)")
_BEGINS = re.compile(r"In file included from |In .*(?:function|constructor|destructor)|"
                     r"\S+: (?:In |At global scope)")
_UNDEFINED = re.compile(r"undefined (?:reference to|symbol:|reference due to [^:]+:) *[`']?"
                        r"(?:\w+::)*(\w+)\(")
_SHOWN = 5
_LONG = 120
_BESIDE = 1200


class Remark(NamedTuple):
    """A warning or an error, and the line of the student's file that it comes from."""

    line: int
    text: str


def remarks(diagnostics: str, stub: str) -> list[Remark]:
    """Each once, in order. Where a remark is about a header, the line is the one that used it: the
    last of the student's that stands before the remark, as "inlined from", or after it, as a note.

    stub  the file's name, as in impulse_response.cpp
    """
    of_stub = re.compile(rf"(?:^|[\s/]){re.escape(stub)}:(\d+)")
    found: list[Remark] = []
    used_at = 0
    homeless = ""
    for text in diagnostics.splitlines():
        message = _MESSAGE.match(text)
        place = of_stub.search(text)
        if message and message.group(3) != "note":
            own = place if place and place.start() < message.start(2) else None
            line = int(own.group(1)) if own else used_at
            homeless = "" if line else f"{message.group(3)}: {message.group(4)}"
            if line:
                found.append(Remark(line, f"{message.group(3)}: {message.group(4)}"))
            used_at = 0
        elif _BEGINS.match(text):
            used_at = 0
            homeless = ""
        elif place and message and homeless:
            found.append(Remark(int(place.group(1)), homeless))
            homeless = ""
        elif place and not message or place and "required from" in text:
            used_at = int(place.group(1))
    first = {(remark.line, _kind(remark.text)): remark for remark in reversed(found)}
    return list(first.values())[::-1]


def _kind(text: str) -> str:
    """Of a warning its flag, as one mistake may be told for each entry of a matrix."""
    flag = re.search(r"\[-W[^]]+\]$", text)
    return flag.group(0) if flag else text


def of_student(lab: Lab, diagnostics: str) -> list[str]:
    """Place, words and source line of what the student's own file is told, before all the rest."""
    try:
        source = lab.stub.read_text(encoding="utf-8", errors="replace").splitlines()
    except OSError:
        source = []
    lines = []
    all_of_them = remarks(diagnostics, lab.stub.name)
    for remark in all_of_them[:_SHOWN]:
        text = remark.text if len(remark.text) <= _LONG else f"... {remark.text[-_LONG:]}"
        lines.append(f"labs/{lab.folder}/{lab.stub.name}:{remark.line}: {text}")
        if 0 < remark.line <= len(source):
            lines.append(f"    {source[remark.line - 1].strip()}")
    if len(all_of_them) > _SHOWN:
        lines.append(f"and {len(all_of_them) - _SHOWN} more in {lab.stub.name}")
    return lines


def missing_functions(lab: Lab, diagnostics: str) -> list[str]:
    """A line for each function of the contract that the linker looked for in vain."""
    lines = []
    for function in dict.fromkeys(_UNDEFINED.findall(diagnostics)):
        declared = lab.declaration(function)
        step = lab.step_of(function)
        if declared and step:
            lines.append(f"{function} of step {step} is missing or differs from the header "
                         f"({declared})")
    return lines


def told(lab: Lab, diagnostics: str, limit: int) -> Sequence[str]:
    """The student's own lines first, then the rest, cut from the end; as the compiler says it where
    all of it is about the student's file."""
    messages = [match for match in map(_MESSAGE.match, diagnostics.splitlines())
                if match and match.group(3) != "note"]
    own: list[str] = []
    if any(not match.group(1).endswith(lab.stub.name) for match in messages):
        own = of_student(lab, diagnostics)
    if own:
        limit = _BESIDE
    rest = shortened(diagnostics, limit, "build/dev/build.log")
    return [*own, *([""] if own else []), rest]
