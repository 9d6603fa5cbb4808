"""What the user sees: failures and progress in one line, colour and marks where they fit."""

from __future__ import annotations

import os
import shutil
import sys
import textwrap
import time

FAILED = 1
BAD_USAGE = 2

_QUIET_SECONDS = 5.0
_COLOURS = {"green": "32", "red": "31", "yellow": "33", "bold": "1", "dim": "2"}


class Failure(Exception):
    """Ends the command: one line for the user, with what there is to read beneath it."""

    def __init__(self, message: str, code: int = FAILED, details: str = ""):
        super().__init__(message)
        self.code = code
        self.details = details

    def __str__(self) -> str:
        line = f"tumble: {super().__str__()}"
        return f"{line}\n\n{self.details.rstrip()}\n" if self.details else line


def has_colour() -> bool:
    return sys.stdout.isatty() and not os.environ.get("NO_COLOR")


def has_utf8() -> bool:
    """Whether the user's locale says so. Python sets LC_CTYPE where none is set: no evidence."""
    for name in ("LC_ALL", "LC_CTYPE", "LANG"):
        value = os.environ.get(name, "")
        if value and (name, value) != ("LC_CTYPE", "C.UTF-8"):
            return "utf" in value.lower()
    return False


def coloured(text: str, colour: str) -> str:
    return f"\033[{_COLOURS[colour]}m{text}\033[0m" if has_colour() else text


def mark(kind: str) -> str:
    """A sign for done, wrong or open."""
    signs = {"done": ("✓", "+"), "wrong": ("✗", "x"), "open": ("·", "-")}
    return signs[kind][0 if has_utf8() else 1]


def width() -> int:
    return min(shutil.get_terminal_size((100, 24)).columns, 100)


def labelled(label: str, text: str, label_width: int, wrap: bool = True) -> list[str]:
    """The lines of `label  text`, the text aligned; unwrapped where it is to be pasted."""
    indent = " " * (label_width + 2)
    room = max(width() - len(indent), 30)
    lines = []
    for line in text.splitlines() or [""]:
        lines += textwrap.wrap(line, room, break_on_hyphens=False) if wrap else [line]
    first = f"{label:<{label_width}}  {lines[0] if lines else ''}".rstrip()
    return [first] + [(indent + line).rstrip() for line in lines[1:]]


def shortened(text: str, limit: int) -> str:
    """The text cut at a line's end near the limit: the first error is the one to read."""
    if len(text) <= limit:
        return text
    kept = text[:limit].rsplit("\n", 1)[0]
    left_out = text[len(kept):].strip().count("\n") + 1
    return f"{kept}\n... {left_out} more lines"


def say(*lines: str) -> None:
    for line in lines:
        print(line)


class Progress:
    """One line on stderr: rewritten on a terminal, elsewhere repeated only now and then."""

    def __init__(self) -> None:
        self._live = sys.stderr.isatty()
        self._last = time.monotonic()
        self._drawn = False

    def show(self, text: str) -> None:
        if self._live:
            sys.stderr.write("\r\033[K" + text[: width() - 1])
            self._drawn = True
        elif time.monotonic() - self._last >= _QUIET_SECONDS:
            sys.stderr.write(text + "\n")
            self._last = time.monotonic()
        sys.stderr.flush()

    def __enter__(self) -> Progress:
        return self

    def __exit__(self, *_: object) -> None:
        if self._drawn:
            sys.stderr.write("\r\033[K")
            sys.stderr.flush()
