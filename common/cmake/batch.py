"""Puts mistakes together, so that the compiler reads headers and templates once for many of them.

usage: batch.py write CONTRACT RIGHT FOLDER OUT
       batch.py split NM OBJCOPY RIGHT.o BATCH.o OUT_FOLDER MISTAKE...

`write` makes OUT of the wrong answers FOLDER/<mistake>.cpp. In OUT each mistake has a namespace of
its own, with the contract and with what only_affected.py keeps of the answer. All that they include
comes first. A file that does not change is not written.

`split` makes OUT_FOLDER/<mistake>.o from the compiled OUT: in it the mistake's functions have the
names that they have in RIGHT.o. The functions of the other mistakes keep their own names. Nobody
calls them, so the linker leaves them out (-ffunction-sections, --gc-sections).
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Iterator, Sequence

from only_affected import only_affected

_INCLUDE = re.compile(r"^#include [^\n]*$|^#pragma once$", re.M)
_SYMBOL = re.compile(r"^[0-9a-f ]*([A-Za-z]) (.*)$", re.M)
_NAMESPACE = "mistake_"


def batch(contract: str, contract_name: str, answers: dict[str, str]) -> str:
    """One text of many answers, by the name of the mistake."""
    includes: dict[str, None] = {}

    def without_includes(text: str) -> str:
        includes.update(dict.fromkeys(_INCLUDE.findall(text)))
        return _INCLUDE.sub("", text)

    found = []
    for mistake, text in answers.items():
        parts = (f'#line 1 "{contract_name}"\n', without_includes(contract),
                 f'\n#line 1 "{mistake}.cpp"\n', without_includes(text))
        found.append(f"namespace {_NAMESPACE}{mistake} {{\n{''.join(parts)}\n}}\n")
    first = [line for line in includes if line not in ("#pragma once", f'#include "{contract_name}"')]
    return "\n".join([*first, "", *found])


def write(contract: Path, right: Path, folder: Path, out: Path) -> None:
    right_text = right.read_text(encoding="utf-8")
    answers = {file.stem: only_affected(right_text, file.read_text(encoding="utf-8"))
               for file in sorted(folder.glob("*.cpp"))}
    text = batch(contract.read_text(encoding="utf-8"), contract.name, answers)
    out.parent.mkdir(parents=True, exist_ok=True)
    if not out.exists() or out.read_text(encoding="utf-8") != text:
        out.write_text(text, encoding="utf-8")


def symbols(nm: str, file: str) -> Iterator[tuple[str, str, str]]:
    """Kind, name and readable name of each symbol."""
    plain, readable = (
        _SYMBOL.findall(subprocess.run([nm, "--no-sort", *options, file], check=True,
                                       stdout=subprocess.PIPE, text=True).stdout)
        for options in ([], ["--demangle"]))
    for (kind, name), (_, read) in zip(plain, readable, strict=True):
        yield kind, name, read


def renamed(mistake: str, real: dict[str, str],
            found: Sequence[tuple[str, str, str]]) -> dict[str, str]:
    """The real name for each of the mistake's functions, and for those of the answer it calls."""
    own = f"{_NAMESPACE}{mistake}::"
    names = {}
    for kind, name, read in found:
        if kind not in "TU" or not read.startswith(own):  # of an inline function each keeps its own
            continue
        shown = read.replace(own, "")
        if shown in real:
            names[name] = real[shown]
        elif kind == "U":
            raise SystemExit(f"{mistake} calls {shown}, which the right answer does not define")
    return names


def split(nm: str, objcopy: str, right: str, batch_object: str, out: Path,
          mistakes: Sequence[str]) -> None:
    real = {read: name for kind, name, read in symbols(nm, right) if kind == "T"}
    found = list(symbols(nm, batch_object))
    out.mkdir(parents=True, exist_ok=True)
    for mistake in mistakes:
        with tempfile.NamedTemporaryFile("w", suffix=".txt") as names:
            for before, after in renamed(mistake, real, found).items():
                names.write(f"{before} {after}\n")
            names.flush()
            subprocess.run([objcopy, f"--redefine-syms={names.name}", batch_object,
                            str(out / f"{mistake}.o")], check=True)


def main() -> None:
    what, *arguments = sys.argv[1:]
    if what == "write":
        write(*map(Path, arguments))
    else:
        nm, objcopy, right, batch_object, out, *mistakes = arguments
        split(nm, objcopy, right, batch_object, Path(out), mistakes)


if __name__ == "__main__":
    main()
