"""./tumble hint N.S: one hint more each time, from labs/<N>_<name>/hints.md."""

from __future__ import annotations

import argparse
import json
import os
import re
from pathlib import Path
from typing import Mapping, NamedTuple, Sequence

from .console import BAD_USAGE, Failure, coloured, require_writable, say
from .labs import Lab, find_lab, plain, printable

KINDS = ("Idea", "Formula", "Line")

_STEP = re.compile(r"[0-9]+\.[0-9]+")
_SECTION = re.compile(r"^## +(\d+\.\d+) *(.*)$", re.MULTILINE)
_ITEM = re.compile(r"^(\d)\. \*\*(\w+)\.\*\* *", re.MULTILINE)


class Hint(NamedTuple):
    kind: str
    text: str


class Section(NamedTuple):
    title: str
    hints: Sequence[Hint]


def run(root: Path, options: argparse.Namespace) -> int:
    if not _STEP.fullmatch(options.step):
        raise Failure(f"{printable(options.step)} is not a step: give one as in 1.2", BAD_USAGE)
    lab = find_lab(root, options.step.split(".")[0])
    sections = read_hints(lab)
    if options.step not in sections:
        known = ", ".join(sections) or "none yet"
        raise Failure(f"there are no hints for step {options.step}; lab {lab.number} has them for: "
                      f"{known}", BAD_USAGE)
    memory = root / "build" / "hints.json"
    section = sections[options.step]
    shown = _shown_before(memory, options.step)
    if options.reset:
        require_writable(memory.parent)
        _remember(memory, options.step, 0)
        say(f"The hints of step {options.step} are hidden again.")
        return 0
    if not options.again:
        shown = min(shown + 1, len(section.hints))
        try:
            _remember(memory, options.step, shown)
        except OSError:
            say(*_texts(options.step, section, len(section.hints)),
                "All hints are shown, because build/ cannot be written to note what you saw.")
            return 0
    say(*_told(options.step, section, shown))
    return 0


def read_hints(lab: Lab) -> Mapping[str, Section]:
    """The sections of the lab's hints.md by step."""
    try:
        text = (lab.path / "hints.md").read_text(encoding="utf-8")
    except FileNotFoundError:
        return {}
    heads = list(_SECTION.finditer(text))
    ends = [head.start() for head in heads[1:]] + [len(text)]
    return {head.group(1): Section(plain(head.group(2)), _items(text[head.end():end]))
            for head, end in zip(heads, ends)}


def flaws(lab: Lab) -> list[str]:
    """What keeps hints.md from holding an idea, a formula and a line for every step."""
    sections = read_hints(lab)
    found = [f"{lab.folder}/hints.md: no section for step {step}"
             for step in lab.steps() if step not in sections]
    found += [f"{lab.folder}/hints.md: step {step} is not in the handout"
              for step in sections if step not in lab.steps()]
    for step, section in sections.items():
        kinds = tuple(hint.kind for hint in section.hints)
        if kinds != KINDS or not all(hint.text for hint in section.hints):
            found.append(f"{lab.folder}/hints.md: step {step} has {kinds}, needs {KINDS} with text")
    return found


def _items(text: str) -> list[Hint]:
    heads = list(_ITEM.finditer(text))
    ends = [head.start() for head in heads[1:]] + [len(text)]
    return [Hint(head.group(2), text[head.end():end].strip("\n").rstrip())
            for head, end in zip(heads, ends)]


def _texts(step: str, section: Section, shown: int) -> list[str]:
    lines = [coloured(f"Step {step}: {section.title}", "bold"), ""]
    for hint in section.hints[:shown]:
        first, *rest = hint.text.split("\n")
        label = coloured(f"{hint.kind}.", "bold")
        lines += [f"{label} {first}", *(line.rstrip() for line in rest), ""]
    return lines


def _told(step: str, section: Section, shown: int) -> list[str]:
    lines = _texts(step, section, shown)
    count = f"{shown} of {len(section.hints)}"
    if shown < len(section.hints):
        return lines + [f"{count} hints shown; the next one: ./tumble hint {step}"]
    return lines + [f"{count} hints shown; hide them again: ./tumble hint {step} --reset"]


def _read_memory(memory: Path) -> dict[str, int]:
    try:
        content = json.loads(memory.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return content if isinstance(content, dict) else {}


def _shown_before(memory: Path, step: str) -> int:
    count = _read_memory(memory).get(step, 0)
    return min(max(count, 0), len(KINDS)) if isinstance(count, int) else 0


def _remember(memory: Path, step: str, shown: int) -> None:
    content = _read_memory(memory)
    content[step] = shown
    memory.parent.mkdir(exist_ok=True)
    draft = memory.with_suffix(".draft")
    draft.write_text(json.dumps(content, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    os.replace(draft, memory)
