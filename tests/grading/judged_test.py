"""The judge on what is known: right answers pass, stubs are not written, mistakes fail their step.

It builds and takes minutes. Of each lab's bank of mistakes it takes one; with TUMBLE_ALL_MISTAKES=N
all of lab N.
"""

import os
import re
import shlex
import tempfile
import unittest
from pathlib import Path
from typing import NamedTuple, Sequence

from tumble.grading.judge import judge
from tumble.grading.points import expected_cases
from tumble.grading.verdicts import Judged
from tumble.labs import Lab, find_labs

from box import box_or_skip

ROOT = Path(__file__).resolve().parents[2]
SEEDS = (917465328104, 350912874663)
_WORD = r'"(?:[^"\\]|\\.)*"|[^\s"()]+'
_MUTANT = re.compile(rf"^ *add_mutant\(((?:\s*(?:{_WORD}))+)\s*\)", re.M | re.S)


class Mistake(NamedTuple):
    name: str
    step: str
    find: str
    replace: str
    words: str


def graded_labs() -> list[Lab]:
    return [lab for lab in find_labs(ROOT)
            if (ROOT / "solutions/grading" / lab.name / "proxy.cpp").exists()]


def mistakes(lab: Lab) -> list[Mistake]:
    text = (ROOT / "solutions" / lab.folder / "mistakes.cmake").read_text(encoding="utf-8")
    text = re.sub(r"^ *#.*$", "", text, flags=re.M)
    words = [[word.replace("\\n", "\n") for word in shlex.split(found)]
             for found in _MUTANT.findall(text)]
    return [Mistake(*each[1:6]) for each in words if len(each) == 6]


class EveryLab(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.box = box_or_skip()

    def judged(self, lab: Lab, source: bytes, sanitize: bool = False) -> Judged:
        with tempfile.TemporaryDirectory(prefix="tumble-") as work:
            result = judge(ROOT, lab, source, Path(work), SEEDS, self.box, sanitize)
        self.assertTrue(result.compiled, result.diagnostics)
        self.assertEqual([(case.step, case.case) for case in result.cases],
                         list(expected_cases(ROOT, lab)))
        return result

    def require_all(self, result: Judged, word: str) -> None:
        self.assertEqual([case for case in result.cases if case.word != word], [])
        self.assertEqual(result.sanitizer, "")
        self.assertEqual(result.notes, [])

    def test_right_answers_pass(self) -> None:
        for lab in graded_labs():
            folder = ROOT / "solutions" / lab.folder
            for answer in sorted(folder.glob("*.cpp")):
                with self.subTest(answer.name):
                    is_reference = answer.name == lab.stub.name
                    self.require_all(self.judged(lab, answer.read_bytes(), is_reference), "pass")

    def test_nothing_of_a_stub_is_written(self) -> None:
        for lab in graded_labs():
            with self.subTest(lab.name):
                self.require_all(self.judged(lab, lab.stub.read_bytes()), "not written yet")

    def test_mistakes_fail_their_step(self) -> None:
        for lab in graded_labs():
            text = (ROOT / "solutions" / lab.folder / lab.stub.name).read_text(encoding="utf-8")
            chosen: Sequence[Mistake] = mistakes(lab)
            self.assertGreaterEqual(len(chosen), 8)
            if os.environ.get("TUMBLE_ALL_MISTAKES") != str(lab.number):
                chosen = chosen[:1]
            for mistake in chosen:
                with self.subTest(f"{lab.name} {mistake.name}"):
                    self.assertIn(mistake.find, text)
                    wrong = text.replace(mistake.find, mistake.replace).encode()
                    self.require_caught(self.judged(lab, wrong), mistake)

    def require_caught(self, result: Judged, mistake: Mistake) -> None:
        own = [case for case in result.cases if case.step == mistake.step and case.word != "pass"]
        self.assertNotEqual(own, [])
        likely = {case.likely for case in own if case.likely}
        if mistake.words:
            self.assertTrue(any(mistake.words in story for story in likely), own)
        for story in likely:
            self.assertIn(mistake.words or "none may be named", story)


if __name__ == "__main__":
    unittest.main()
