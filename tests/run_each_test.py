"""The runner of a lab's cases: however a case ends, it costs itself alone and is told.

usage: run_each_test.py PROGRAM, which holds the cases of run_each_victims.cpp
"""

import re
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "common" / "command"))

from tumble.runner import Ended, records  # noqa: E402

PROGRAM = sys.argv.pop()
PATIENCE = 1.5  # [s] of computing; students' cases have 6


def run(*cases: str, jobs: str = "2") -> dict[int, Ended]:
    with tempfile.TemporaryDirectory() as folder:
        listed = Path(folder) / "cases.txt"
        listed.write_text("\n".join(cases) + "\n", encoding="utf-8")
        with subprocess.Popen([PROGRAM, "--each", str(listed), jobs, str(PATIENCE)],
                              stdout=subprocess.PIPE) as process:
            return {record.line: record for record in records(process.stdout)}


class Runner(unittest.TestCase):
    def ends(self, *cases: str) -> list[tuple[str, int]]:
        ended = run(*cases)
        self.assertEqual(sorted(ended), list(range(len(cases))))
        return [(ended[line].end, ended[line].value) for line in range(len(cases))]

    def test_a_crash_or_an_exit_ends_one_case_only(self) -> None:
        ends = self.ends("1.1|It crashes", "1.1|It passes", "1.2|It leaves", "1.2|It fails")
        self.assertEqual(ends[:3], [("signal", signal.SIGSEGV), ("exit", 0), ("exit", 0)])
        self.assertIn(ends[3], [("exit", 1), ("exit", 42)])  # as Catch2 2 and 3 end

    def test_what_a_case_prints_is_kept_with_it(self) -> None:
        ended = run("1.1|It prints", "1.1|It passes")
        self.assertIn("these words\n", ended[0].output)
        self.assertNotIn("these words", ended[1].output)
        self.assertRegex(ended[1].output, r"All tests passed \(1 assertion")

    def test_what_was_asked_is_told_however_it_ends(self) -> None:
        ways = ("crashes", "aborts", "overflows the stack", "leaves", "loops", "sleeps")
        ended = run(*(f"1.{number}|Asked it {way}" for number, way in enumerate(ways)))
        self.assertEqual([ended[line].end for line in range(6)],
                         ["signal"] * 3 + ["exit", "timeout", "waits"])
        self.assertEqual(ended[2].value, signal.SIGSEGV)
        for record in ended.values():
            told = [line for line in record.output.splitlines() if line.startswith("| ")]
            self.assertEqual(told, ["| step    1.1 answer", "| case    2 of 5",
                                    "| input   depth = 0.1;"], ways[record.line])

    def test_a_call_outside_of_trials_is_named_by_its_function(self) -> None:
        output = run("1.2|Asked by no trial it crashes")[0].output
        self.assertIn("| step    1.2 answer\n", output)

    def test_endless_output_and_hunger_for_memory_are_bounded(self) -> None:
        ended = run("1.1|It prints without end", "1.1|It takes all memory")
        self.assertEqual((ended[0].end, ended[0].value), ("signal", signal.SIGXFSZ))
        self.assertEqual(ended[1].end, "exit")
        self.assertIn("bad_alloc", ended[1].output)

    def test_after_three_loops_the_rest_of_the_step_is_not_run(self) -> None:
        ended = run(*["1.1|It loops"] * 6, "1.1|It passes", "1.2|It passes", "1.2|It loops")
        words = [ended[line].end for line in range(9)]
        # The fourth was under way when the third had run out of time.
        self.assertEqual(words[:4], ["timeout"] * 4)
        self.assertEqual(words[4:], ["skipped"] * 3 + ["exit", "timeout"])
        # Two with all the time there is, three with half a second.
        self.assertLess(sum(record.seconds for record in ended.values()), 2 * PATIENCE + 3 * 0.5 + 1.0)

    def test_a_case_that_sleeps_is_ended(self) -> None:
        ended = run("1.1|It sleeps", "1.1|It passes")
        self.assertEqual((ended[0].end, ended[1].end), ("waits", "exit"))
        self.assertLess(ended[0].seconds, 1.0)

    def test_together_what_passes_shares_a_process(self) -> None:
        ended = run("1.1|It tells its process", "1.1|It passes", "1.2|It tells its process again",
                    jobs="together")
        self.assertEqual([ended[line].end for line in range(3)], ["exit"] * 3)
        for line in range(3):
            self.assertRegex(ended[line].output, r"All tests passed \(1 assertion")
        first, second = (re.findall(r"process (\d+)", ended[line].output) for line in (0, 2))
        self.assertEqual(len(first), 1)
        self.assertEqual(first, second)

    def test_together_each_case_ends_as_it_does_alone(self) -> None:
        names = ("passes", "crashes", "leaves", "fails", "prints without end", "sleeps", "loops",
                 "prints", "takes all memory", "passes after all", "tells its process")
        cases = [f"1.{number}|It {name}" for number, name in enumerate(names)]
        alone, together = run(*cases), run(*cases, jobs="together")
        self.assertEqual(sorted(together), list(range(len(cases))))
        for line, name in enumerate(names):
            self.assertEqual((together[line].end, together[line].value),
                             (alone[line].end, alone[line].value), name)
        for line in (1, 3, 5, 6, 7, 8):
            told = [re.sub(r"seeded to: \d+", "", ended[line].output)  # anew by Catch2 3
                    for ended in (together, alone)]
            self.assertEqual(*told, names[line])

    def test_together_what_another_case_spoils_is_asked_again_alone(self) -> None:
        ended = run("1.1|It passes once in a process", "1.2|It passes once in a process too",
                    jobs="together")
        for line in range(2):
            self.assertEqual((ended[line].end, ended[line].value), ("exit", 0))
            self.assertIn("All tests passed (1", ended[line].output)

    def test_together_after_three_loops_the_rest_of_the_step_is_not_run(self) -> None:
        loops = [f"1.1|It loops{number}" for number in ("", " twice", " thrice", " still")]
        ended = run(*loops, "1.2|It passes", jobs="together")
        self.assertEqual([ended[line].end for line in range(5)],
                         ["timeout"] * 3 + ["skipped", "exit"])
        self.assertLess(sum(record.seconds for record in ended.values()), PATIENCE + 2 * 0.5 + 1.0)

    def test_a_name_that_fits_no_case_does_not_pass(self) -> None:
        self.assertNotIn("All tests passed", run("1.1|It is nowhere")[0].output)


if __name__ == "__main__":
    unittest.main()
