"""What the user sees: failures and progress in one line, colour and marks where they fit."""

from __future__ import annotations

import contextlib
import os
import shutil
import sys
import tempfile
import textwrap
import threading
import time
from pathlib import Path
from typing import Iterator

FAILED = 1
BAD_USAGE = 2

_QUIET_SECONDS = 5.0
_LONG_SECONDS = 3.0
_COLOURS = {"green": "32", "red": "31", "yellow": "33", "bold": "1", "dim": "2"}


class Failure(Exception):
    """Ends the command: one line for the user, one for what helps where there is a command that
    does, and beneath them what there is to read."""

    def __init__(self, message: str, code: int = FAILED, details: str = "", remedy: str = ""):
        super().__init__(message)
        self.code = code
        self.details = details
        self.remedy = remedy

    def __str__(self) -> str:
        lines = f"tumble: {super().__str__()}"
        if self.remedy:
            lines += f"\ntumble: {self.remedy}"
        return f"{lines}\n\n{self.details.rstrip()}\n" if self.details else lines


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


def shortened(text: str, limit: int, where: str = "") -> str:
    """The text cut at a line's end near the limit: the first error is the one to read.

    where  the file that has all of it
    """
    if len(text) <= limit:
        return text
    kept = text[:limit].rsplit("\n", 1)[0]
    left_out = text[len(kept):].strip().count("\n") + 1
    return f"{kept}\n... {left_out} more lines{where and f' in {where}'}"


def require_writable(folder: Path) -> None:
    """Before the long work: can it be written to? Root may write anywhere, so it is tried."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        tempfile.TemporaryFile(dir=folder).close()  # without a name: others may try as well
    except OSError as error:
        raise Failure(f"cannot write to {folder}: {error.strerror}") from error


def say(*lines: str) -> None:
    with _line.away():
        for line in lines:
            print(line)
        sys.stdout.flush()


def complain(text: str) -> None:
    """A line on stderr that stays."""
    with _line.away():
        print(text, file=sys.stderr, flush=True)


class _Line:
    """The one line on stderr that all open Progress share."""

    def __init__(self) -> None:
        self._lock = threading.RLock()
        self._open: list[Progress] = []
        self._drawn = False
        self._said = 0.0
        self._busy = threading.Event()
        self._ticker = threading.Thread(target=self._tick, daemon=True)

    def add(self, progress: Progress) -> None:
        with self._lock:
            if not self._open:
                self._said = time.monotonic()
            self._open.append(progress)
            self._busy.set()
            if not self._ticker.is_alive():
                self._ticker.start()

    def remove(self, progress: Progress) -> None:
        with self._lock:
            self._open.remove(progress)
            if not self._open:
                self._busy.clear()
            self._clear()

    def show(self) -> None:
        with self._lock:
            now = time.monotonic()
            text = " | ".join(progress.told(now) for progress in self._open if progress.text)
            if sys.stderr.isatty():
                sys.stderr.write("\r\033[K" + text[: width() - 1])
                self._drawn = True
            elif text and now - self._said >= _QUIET_SECONDS:
                sys.stderr.write(text + "\n")
                self._said = now
            sys.stderr.flush()

    @contextlib.contextmanager
    def away(self) -> Iterator[None]:
        """Room for lines that stay."""
        with self._lock:
            self._clear()
            yield

    def _clear(self) -> None:
        if self._drawn:
            sys.stderr.write("\r\033[K")
            sys.stderr.flush()
        self._drawn = False

    def _tick(self) -> None:
        """Nothing may look as if it hung: what takes long is told with its seconds."""
        while self._busy.wait():
            time.sleep(1.0)
            with self._lock:
                if self._open:
                    self.show()


_line = _Line()


class Progress:
    """A line on stderr: rewritten on a terminal, elsewhere repeated every few seconds. All that are
    open at a time, as of a build and of a film that is drawn meanwhile, share it."""

    def __init__(self) -> None:
        self.text = ""
        self._since = 0.0

    def show(self, text: str) -> None:
        if text != self.text:
            self.text = text
            self._since = time.monotonic()
        _line.show()

    def told(self, now: float) -> str:
        seconds = int(now - self._since)
        return f"{self.text} ({seconds} s)" if seconds >= _LONG_SECONDS else self.text

    def __enter__(self) -> Progress:
        _line.add(self)
        return self

    def __exit__(self, *_: object) -> None:
        _line.remove(self)
