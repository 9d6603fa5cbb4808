"""What a test program records of its cases, and the word that each gets."""

import io
import unittest

from fake_kit import LAB
from student_records import NAMES, PASSED, RECORDS, record
from tumble import ctest, runner
from tumble.outcome import outcome


def cases() -> list:
    ended = {record.line: record for record in runner.records(io.BytesIO(RECORDS))}
    return runner.cases(NAMES.splitlines(), ended, f"{LAB}/student")


class Outcomes(unittest.TestCase):
    def test_every_kind_of_end_has_its_word(self) -> None:
        self.assertEqual([outcome(case).word for case in cases()], [
            "pass", "pass", "pass", "wrong", "wrong", "not written yet", "crashed", "crashed",
            "timed out", "exception"])

    def test_the_detail_says_which_function_signal_or_message(self) -> None:
        details = [outcome(case).detail for case in cases()]
        self.assertEqual(details[5], "1.3 net_wrench")
        self.assertEqual(details[6], "SIGSEGV")
        self.assertTrue(details[9].startswith("vector::_M_range_check"))

    def test_a_record_that_breaks_off_leaves_its_case_and_the_rest_not_run(self) -> None:
        ended = {case.line: case for case in runner.records(io.BytesIO(RECORDS[:-30] + b"case 8 "))}
        got = runner.cases([f"1.1|{number}" for number in range(12)], ended, f"{LAB}/student")
        self.assertEqual([case.status for case in got[10:]], ["notrun", "notrun"])
        self.assertEqual(outcome(got[11]), ("not run", "the program ended before this test"))

    def test_only_what_catch_calls_passed_has_passed(self) -> None:
        for output, end in (("Filters: b\n", "exit 0"), (PASSED, "exit 1"), (PASSED, "signal 11"),
                            ("All tests passed (0 assertions in 1 test case)\n", "exit 0")):
            stream = io.BytesIO(record(0, output, end))
            ended = {case.line: case for case in runner.records(stream)}
            self.assertFalse(runner.cases(["1.1|b"], ended, "a/student")[0].passed, (output, end))

    def test_a_case_that_sleeps_and_one_that_is_not_run_say_so(self) -> None:
        self.assertEqual(outcome(ctest.Case("a/student/1.1/b", "fail", "Waits", "")).word,
                         "timed out")
        self.assertIn("three cases", outcome(
            ctest.Case("a/student/1.1/b", "notrun", "Hopeless", "")).detail)

    def test_a_crash_without_a_word_is_still_a_crash(self) -> None:
        case = ctest.Case("a/student/1.1/b", "fail", "ILLEGAL", "")
        self.assertEqual(outcome(case), ("crashed", "ILLEGAL"))

    def test_a_wrong_value_beside_an_unwritten_function_is_wrong(self) -> None:
        case = ctest.Case("a/student/1.1/b", "fail", "Failed",
                          "| step 1.1 skew\n| got 1\n  1.2 world_point is not written yet\n"
                          "test cases: 1 | 1 failed\n")
        self.assertEqual(outcome(case).word, "wrong")

    def test_an_answer_that_calls_exit_has_not_passed(self) -> None:
        case = ctest.Case("a/student/1.1/b", "fail", "Failed", "Filters: b\n")
        self.assertEqual(outcome(case).word, "ended early")


if __name__ == "__main__":
    unittest.main()
