"""The judge on what is known: right answers pass, stubs are not written, mistakes fail their step.

It builds and takes minutes. Of each lab's bank of mistakes it takes one; all of labs 1 and 4 with
TUMBLE_ALL_MISTAKES=1,4 in the environment.
"""

import os
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Sequence

from tumble.grading.judge import judge
from tumble.grading.points import FULL, Table, expected_cases, read_table
from tumble.grading.score import graded
from tumble.grading.verdicts import NOT_WRITTEN, PASS, Judged
from tumble.labs import Lab, find_labs

from box import box_or_skip
from mistake_bank import Mistake, handed_in, mistakes

ROOT = Path(__file__).resolve().parents[2]
SEEDS = (917465328104, 350912874663)


def graded_labs() -> list[Lab]:
    return [lab for lab in find_labs(ROOT)
            if (ROOT / "solutions/grading" / lab.name / "remote.hpp").exists()]


def resting_on(table: Table, step: str) -> set[str]:
    """The step, and those that depend on it, be it by others between."""
    found = {step}
    for number, row in table.steps.items():
        if found & set(row.depends_on):
            found.add(number)
    return found


class EveryLab(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.box = box_or_skip()

    def judged(self, lab: Lab, source: bytes, sanitize: bool) -> Judged:
        with tempfile.TemporaryDirectory(prefix="tumble-") as work:
            result = judge(ROOT, lab, source, Path(work), SEEDS, self.box, sanitize)
        self.assertTrue(result.compiled, result.diagnostics)
        self.assertEqual([(case.step, case.case) for case in result.cases],
                         list(expected_cases(ROOT, lab)))
        return result

    def all_judged(self, files: Sequence[tuple[Lab, bytes, bool]]) -> list[Judged]:
        """Of each the lab, the text, and whether the sanitizers are asked, too."""
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            return list(pool.map(lambda file: self.judged(*file), files))

    def require_all(self, result: Judged, word: str) -> None:
        self.assertEqual([case for case in result.cases if case.word != word], [])
        self.assertEqual(result.sanitizer, "")
        self.assertEqual(result.notes, [])

    def test_right_answers_pass(self) -> None:
        answers = [(lab, answer) for lab in graded_labs()
                   for answer in sorted((ROOT / "solutions" / lab.folder).glob("*.cpp"))]
        results = self.all_judged([(lab, handed_in(answer).encode(), answer.name == lab.stub.name)
                                   for lab, answer in answers])
        for (_, answer), result in zip(answers, results):
            with self.subTest(answer.name):
                self.require_all(result, PASS)

    def test_nothing_of_a_stub_is_written(self) -> None:
        labs = graded_labs()
        results = self.all_judged([(lab, lab.stub.read_bytes(), False) for lab in labs])
        for lab, result in zip(labs, results):
            with self.subTest(lab.name):
                self.require_all(result, NOT_WRITTEN)

    def test_mistakes_lose_their_step_and_what_rests_on_it(self) -> None:
        whole = os.environ.get("TUMBLE_ALL_MISTAKES", "").split(",")
        chosen = []
        files = []
        for lab in graded_labs():
            bank = mistakes(lab)
            self.assertGreaterEqual(len(bank), 8)
            for mistake in bank if str(lab.number) in whole else bank[:1]:
                chosen.append((lab, mistake))
                files.append((lab, mistake.wrong_answer().encode(), False))
        for (lab, mistake), result in zip(chosen, self.all_judged(files)):
            with self.subTest(f"{lab.name} {mistake.name}"):
                self.require_caught(result, mistake)
                self.require_points(lab, result, mistake.step)

    def require_caught(self, result: Judged, mistake: Mistake) -> None:
        own = [case for case in result.cases if case.step == mistake.step and case.word != PASS]
        self.assertNotEqual(own, [])
        likely = {case.likely for case in own if case.likely}
        if mistake.words:
            self.assertTrue(any(mistake.words in story for story in likely), own)
        for story in likely:
            self.assertIn(mistake.words or "none may be named", story)

    def require_points(self, lab: Lab, result: Judged, step: str) -> None:
        table = read_table(ROOT, lab)
        marks = graded(lab, table, expected_cases(ROOT, lab), result, len(SEEDS))
        lost = {each.step for each in marks.steps if each.word != PASS}
        self.assertLessEqual(lost, resting_on(table, step))
        self.assertEqual(marks.score, FULL + table.bonus - sum(
            table.steps[each].points for each in lost))


if __name__ == "__main__":
    unittest.main()
