"""Writes a class of submissions to grade: right, wrong, hostile and mixed, the same each time.

usage: python3 -B tests/grading/generate_class.py DIR [--labs 1,2] [--students 100]

Beside DIR it writes DIR.expected.json: of each student and lab the least and the most points that
may be given. Answers are those of solutions/, mistakes are made as mistakes.cmake says.
"""

from __future__ import annotations

import argparse
import io
import json
import random
import re
import sys
import tarfile
import zipfile
from pathlib import Path
from typing import Callable

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common" / "command"))

from tumble.grading.points import FULL, graded_labs, read_table  # noqa: E402
from tumble.labs import Lab  # noqa: E402

from mistake_bank import handed_in, mistakes  # noqa: E402

_FUNCTION = re.compile(r"^\w[^\n;{}]*?\b(\w+)\([^;{}]*\)[^;{}]*\{\n.*?^\}\n",
                       re.MULTILINE | re.DOTALL)

Made = tuple[bytes, int, int]
"""The file, and the least and the most points for it."""


def reference(lab: Lab) -> str:
    return (ROOT / "solutions" / lab.folder / lab.stub.name).read_text(encoding="utf-8")


def right(lab: Lab, draw: random.Random) -> Made:
    """The reference, or a right answer built otherwise."""
    answers = sorted((ROOT / "solutions" / lab.folder).glob("*.cpp"))
    full = FULL + read_table(ROOT, lab).bonus
    return handed_in(draw.choice(answers)).encode(), full, full


def wrong(lab: Lab, draw: random.Random) -> Made:
    """One mistake of the bank: its step fails, others may."""
    table = read_table(ROOT, lab)
    mistake = draw.choice(mistakes(lab))
    most = FULL + table.bonus - table.steps[mistake.step].points
    return mistake.wrong_answer().encode("utf-8"), 0, most


def partial(lab: Lab, draw: random.Random) -> Made:
    """The reference without the functions of some steps, as the stub has them."""
    stub = lab.stub.read_text(encoding="utf-8")
    table = read_table(ROOT, lab)
    written = {step for step in table.steps if draw.random() < 0.6}
    answer = {match.group(1): match.group(0) for match in _FUNCTION.finditer(reference(lab))}
    text = reference(lab)
    for step, function in re.findall(r'NotImplemented\("([\d.]+) (\w+)"\)', stub):
        if step not in written and function in answer:
            head = answer[function].split("{\n", 1)[0]
            body = f'{{\n  throw common::NotImplemented("{step} {function}");\n}}\n'
            text = text.replace(answer[function], head + body)
    include = '#include "common/course/not_implemented.hpp"\n'
    most = sum(table.steps[step].points for step in written)
    return text.replace("\n\n", f"\n\n{include}", 1).encode("utf-8"), 0, most


def untouched(lab: Lab, _draw: random.Random) -> Made:
    return lab.stub.read_bytes(), 0, 0


def unbuildable(lab: Lab, _draw: random.Random) -> Made:
    return reference(lab).replace(";", "", 1).encode("utf-8"), 0, 0


_CONSTRUCTOR = "__attribute__((constructor)) static void nasty()"
_HOSTILE = (
    "#include <cstdlib>\n@ { std::_Exit(0); }\n",
    "#include <unistd.h>\n@ { for (;;) pause(); }\n",
    "#include <unistd.h>\n@ {\n  for (int i = 0; i < 200; ++i) if (fork() == 0) for (;;) {}\n}\n",
    "#include <vector>\n@ {\n  std::vector<char*> all;\n"
    "  for (;;) { all.push_back(new char[1 << 24]); all.back()[0] = 1; }\n}\n",
    '#include <cstdio>\n@ {\n'
    '  for (;;) std::puts("All tests passed (1 assertion in 1 test case)");\n}\n',
    '#include <cstdio>\n#include <cstdlib>\n@ {\n'
    '  std::puts("All tests passed (21 assertions in 5 test cases)"); std::exit(0);\n}\n',
)


def hostile(lab: Lab, draw: random.Random) -> Made:
    """A stub with something nasty: no points, whatever it does."""
    nasty = draw.choice(_HOSTILE).replace("@", _CONSTRUCTOR)
    return (nasty + lab.stub.read_text(encoding="utf-8")).encode("utf-8"), 0, 0


def looping(lab: Lab, _draw: random.Random) -> Made:
    """Every function hangs."""
    stub = lab.stub.read_text(encoding="utf-8")
    return re.sub(r"throw common::NotImplemented\([^;]*;", "for (volatile int i = 0;; i = i) {}",
                  stub).encode("utf-8"), 0, 0


KINDS: list[tuple[int, Callable[[Lab, random.Random], Made]]] = [
    (30, right), (25, wrong), (20, partial), (6, untouched), (5, unbuildable), (12, hostile),
    (2, looping)]


def write(folder: Path, student: str, files: dict[str, bytes], draw: random.Random) -> None:
    """As a folder, a zip or a tar, with what else students leave in there."""
    files = {**files, "README.txt": b"my work\n", "build/a.o": b"\0" * 1000}
    kind = draw.choice(("folder", "zip", "tar"))
    if kind == "folder":
        for name, text in files.items():
            path = folder / student / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(text)
    elif kind == "zip":
        with zipfile.ZipFile(folder / f"{student}.zip", "w", zipfile.ZIP_DEFLATED) as archive:
            for name, text in files.items():
                archive.writestr(zipfile.ZipInfo(f"{student}/{name}"), text)
    else:
        with tarfile.open(folder / f"{student}.tar.gz", "w:gz") as archive:
            for name, text in files.items():
                member = tarfile.TarInfo(f"{student}/{name}")
                member.size = len(text)
                archive.addfile(member, io.BytesIO(text))


def main() -> int:
    parser = argparse.ArgumentParser(allow_abbrev=False)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--labs", default="1")
    parser.add_argument("--students", type=int, default=100)
    options = parser.parse_args()
    chosen = [lab for lab in graded_labs(ROOT) if str(lab.number) in options.labs.split(",")]
    options.folder.mkdir()
    draw = random.Random(20)
    weights = [weight for weight, _ in KINDS]
    expected: dict[str, dict[str, list[int]]] = {}
    for number in range(options.students):
        kind = draw.choices([make for _, make in KINDS], weights)[0]
        student = f"{kind.__name__}_{number:03}"
        made = {lab: kind(lab, draw) for lab in chosen}
        write(options.folder, student, {lab.stub.name: text for lab, (text, *_) in made.items()},
              draw)
        expected[student] = {lab.folder: due for lab, (_, *due) in made.items()}
    Path(f"{options.folder}.expected.json").write_text(json.dumps(expected, indent=1) + "\n",
                                                       encoding="utf-8")
    print(f"{options.students} submissions in {options.folder}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
