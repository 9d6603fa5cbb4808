"""The mistakes of a lab, read from solutions/N_name/mistakes.cmake as CMake reads them."""

import re
import shlex
from pathlib import Path
from typing import NamedTuple

from tumble.labs import Lab

ROOT = Path(__file__).resolve().parents[2]
_WORD = r'"(?:[^"\\]|\\.)*"|[^\s"()]+'
_OWN_HEADER = re.compile(r'^#include "([^"/]+)"$', re.M)
_MUTANT = re.compile(rf"^ *add_mutant\(((?:\s*(?:{_WORD}))+)\s*\)", re.M | re.S)


def handed_in(answer: Path) -> str:
    """The answer as the one file that is handed in, with the headers of its own put into it."""
    def included(found: re.Match[str]) -> str:
        header = answer.parent / found[1]
        if not header.exists():
            return found[0]
        return header.read_text(encoding="utf-8").replace("#pragma once\n", "")

    return _OWN_HEADER.sub(included, answer.read_text(encoding="utf-8"))


class Mistake(NamedTuple):
    answer: Path
    """The right answer in which it is made: the reference, or what OF names."""
    name: str
    step: str
    find: str
    replace: str
    words: str

    def wrong_answer(self) -> str:
        """The text of the answer with the mistake in it."""
        right = handed_in(self.answer)
        if self.find not in right:
            raise ValueError(f"{self.name}: '{self.find}' is not in {self.answer}")
        return right.replace(self.find, self.replace)


def mistakes(lab: Lab) -> list[Mistake]:
    solutions = ROOT / "solutions" / lab.folder
    text = (solutions / "mistakes.cmake").read_text(encoding="utf-8")
    text = re.sub(r"^ *#.*$", "", text, flags=re.M)
    bank = []
    for found in _MUTANT.findall(text):
        _, *words = [word.replace("\\n", "\n") for word in shlex.split(found)]
        of = words[5:]
        if len(words) < 5 or of and (len(of) != 2 or of[0] != "OF"):
            raise ValueError(f"add_mutant({found}): want six arguments, or OF an answer too")
        answer = solutions / (f"{of[1]}.cpp" if of else lab.stub.name)
        bank.append(Mistake(answer, *words[:5]))
    return bank
