"""The mistakes of a lab, read from solutions/N_name/mistakes.cmake as CMake reads them."""

import re
import shlex
from pathlib import Path
from typing import NamedTuple

from tumble.labs import Lab

ROOT = Path(__file__).resolve().parents[2]
_WORD = r'"(?:[^"\\]|\\.)*"|[^\s"()]+'
_MUTANT = re.compile(rf"^ *add_mutant\(((?:\s*(?:{_WORD}))+)\s*\)", re.M | re.S)


class Mistake(NamedTuple):
    name: str
    step: str
    find: str
    replace: str
    words: str


def mistakes(lab: Lab) -> list[Mistake]:
    text = (ROOT / "solutions" / lab.folder / "mistakes.cmake").read_text(encoding="utf-8")
    text = re.sub(r"^ *#.*$", "", text, flags=re.M)
    words = [[word.replace("\\n", "\n") for word in shlex.split(found)]
             for found in _MUTANT.findall(text)]
    return [Mistake(*each[1:6]) for each in words if len(each) == 6]
