"""The sanitizers' look at an answer that passes its tests, as what C++ does not define may do."""

from __future__ import annotations

import hashlib
import re
from pathlib import Path
from typing import NamedTuple, Sequence

from . import answer, build, runner
from .console import Failure, Progress
from .ctest import Case
from .labs import Lab

_ADDRESS = re.compile(r"ERROR: AddressSanitizer: ([\w-]+)")
_UNDEFINED = re.compile(r"^(\S+?):(\d+):\d+: runtime error: (.+)$", re.MULTILINE)
_OPTIONS = {"ASAN_OPTIONS": "detect_leaks=0:detect_stack_use_after_return=1"}
_MEANING = {
    "heap-use-after-free": "your code uses memory that was freed: do you keep a reference into a "
                           "vector that has grown since?",
    "stack-use-after-scope": "your code uses a variable whose block has ended: does an auto "
                             "refer to what a function returned?",
    "stack-use-after-return": "your code uses a variable whose function has returned: do you "
                              "return a reference to it?",
    "heap-buffer-overflow": "an index is past the end of a vector",
    "stack-buffer-overflow": "an index is past the end of an array",
    "global-buffer-overflow": "an index is past the end of an array",
    "stack-overflow": "a function calls itself without end",
}


class Finding(NamedTuple):
    """A case that fails now, and what of it a sanitizer says."""

    case: Case
    line: int
    """Of the student's file; 0 where none is named."""
    what: str


def first_finding(root: Path, lab: Lab) -> tuple[bool, list[Finding]]:
    """Whether it has been looked at, here or before, and what was found; nothing is a good answer.

    An object file that was found clean is not looked at again: a changed comment costs nothing.
    """
    seen = build.build_folder(root, "dev") / "labs" / lab.folder / "sanitized-and-clean"
    now = _fingerprint(root, lab)
    if now and seen.exists() and seen.read_text(encoding="utf-8") == now:
        return True, []
    with Progress() as progress:
        progress.show("looking for undefined behaviour")
        try:
            cases = runner.run_cases(answer.compiled(root, lab, "sanitized"),
                                     f"{lab.folder}/student", apart=True, environment=_OPTIONS)
        except (Failure, OSError):  # without them it has been compiled, and it ran: none are here
            return False, []
    findings = [_finding(lab, case) for case in cases
                if not case.passed and case.reason not in (runner.TIMEOUT, runner.SKIPPED)]
    if not findings and now:
        seen.write_text(now, encoding="utf-8")
    return True, findings[:1]


def _fingerprint(root: Path, lab: Lab) -> str:
    folder = build.build_folder(root, "dev") / "labs" / lab.folder
    files = [folder / "CMakeFiles" / f"{lab.name}_student.dir" / f"{lab.name}.cpp.o",
             folder / f"lib{lab.name}_tests.so"]
    if not all(file.exists() for file in files):
        return ""
    return "".join(hashlib.sha256(file.read_bytes()).hexdigest() + "\n" for file in files)


def _finding(lab: Lab, case: Case) -> Finding:
    address = _ADDRESS.search(case.output)
    if address:
        return Finding(case, _line_of(lab, case.output[address.start():].splitlines()),
                       _MEANING.get(address.group(1), address.group(1).replace("-", " ")))
    undefined = _UNDEFINED.search(case.output)
    if undefined:
        own = undefined.group(1).endswith(f"/{lab.stub.name}")
        return Finding(case, int(undefined.group(2)) if own else 0, undefined.group(3))
    return Finding(case, 0, "compiled with other options, it gives another answer: is a variable "
                            "never set, or does a function lack its return?")


def _line_of(lab: Lab, report: Sequence[str]) -> int:
    for text in report:
        frame = re.match(rf" *#\d+ .*/{re.escape(lab.stub.name)}:(\d+)", text)
        if frame:
            return int(frame.group(1))
    return 0
