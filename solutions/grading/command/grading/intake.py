"""The submissions of a folder, and of each the files that are graded. See reader/ for how."""

from __future__ import annotations

import base64
import hashlib
import json
import re
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple, Optional, Sequence

from ..console import BAD_USAGE, Failure

_READER = Path(__file__).with_name("reader")
_SECONDS = 60
_SUFFIX = re.compile(r"\.(zip|tar|tgz|tbz2|txz|tar\.(gz|bz2|xz))$", re.IGNORECASE)
_PLAIN_NAME = re.compile(r"[\w@+-][\w .@+,-]{0,79}")
_RESERVED = {"index.html", "class.csv", "secret"}
_LONGEST = 120
_BOM = b"\xef\xbb\xbf"
_NOT_UTF8 = ((b"\xff\xfe", "UTF-16"), (b"\xfe\xff", "UTF-16"))


class Submission(NamedTuple):
    """One student's: what was handed in, and why it cannot be read where that is so."""

    student: str
    """A name that is safe as the name of a folder."""
    path: Path
    problem: str = ""


class Taken(NamedTuple):
    """One file of a submission. Without a text there is a problem; missing files are told apart."""

    text: Optional[bytes]
    problem: str = ""
    notes: Sequence[str] = ()
    missing: bool = False


def submissions(folder: Path) -> list[Submission]:
    """One for each folder or archive, by name. Two of one student are graded neither way."""
    if not folder.is_dir():
        raise Failure(f"there is no folder {folder}", BAD_USAGE)
    paths: dict[str, list[Path]] = {}
    for path in sorted(folder.iterdir()):
        if not path.name.startswith("."):
            paths.setdefault(_student(path), []).append(path)
    if not paths:
        raise Failure(f"there is no submission in {folder}", BAD_USAGE)
    return [Submission(student, same[0], _twice(same)) for student, same in sorted(paths.items())]


def _student(path: Path) -> str:
    name = path.name if path.is_dir() else _SUFFIX.sub("", path.name)
    as_bytes = name.encode("utf-8", "surrogateescape")
    if (_PLAIN_NAME.fullmatch(name) and not name.endswith((" ", ".")) and name not in _RESERVED
            and len(as_bytes) <= _LONGEST):
        return name
    return "odd-name-" + hashlib.sha256(as_bytes).hexdigest()[:12]


def _twice(same: Sequence[Path]) -> str:
    if len(same) == 1:
        return ""
    names = " and ".join(ascii(path.name) for path in same)
    return f"there are {len(same)} submissions with one name, {names}: keep one of them"


def take(submission: Submission, names: Sequence[str]) -> dict[str, Taken]:
    """The wanted files. Whatever is wrong with the submission ends as a problem of each."""
    answer = ({"problem": submission.problem} if submission.problem else
              _read(submission.path, names))
    if "problem" in answer:
        return {name: Taken(None, str(answer["problem"])) for name in names}
    return {name: _taken(answer["files"][name], answer["notes"]) for name in names}


def _read(path: Path, names: Sequence[str]) -> dict:
    command = [sys.executable, "-I", "-S", "-B", str(_READER), str(path), *names]
    try:
        done = subprocess.run(command, capture_output=True, timeout=_SECONDS,
                              stdin=subprocess.DEVNULL)
        return json.loads(done.stdout)
    except subprocess.TimeoutExpired:
        return {"problem": f"reading it takes more than {_SECONDS} s"}
    except ValueError:  # the reader was ended by its limits
        return {"problem": "reading it takes too much time or memory"}


def _taken(file: dict[str, str], notes: Sequence[str]) -> Taken:
    if "missing" in file:
        return Taken(None, file["missing"], notes, missing=True)
    if "problem" in file:
        return Taken(None, file["problem"], notes)
    return checked(base64.b64decode(file["text"]), notes)


def checked(text: bytes, notes: Sequence[str] = ()) -> Taken:
    """Source text is UTF-8. A byte-order mark before it is noted and dropped."""
    for mark, name in _NOT_UTF8:
        if text.startswith(mark):
            return Taken(None, f"it is {name} text: save it as UTF-8", notes)
    if text.startswith(_BOM):
        text = text[len(_BOM):]
        notes = [*notes, "the byte-order mark was ignored: save the file as UTF-8 without it"]
    if b"\0" in text:
        return Taken(None, f"it is not text: byte {text.index(0) + 1} is zero", notes)
    try:
        text.decode("utf-8")
    except UnicodeDecodeError as error:
        line = text.count(b"\n", 0, error.start) + 1
        return Taken(None, f"it is not UTF-8: line {line} has the byte 0x{text[error.start]:02X}",
                     notes)
    return Taken(text, "", notes)
