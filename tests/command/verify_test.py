"""./tumble verify: the table counts what CTest found, and CTest's own summary comes last."""

import unittest

from fake_kit import LAB, KitTestCase

SUMMARY = ("97% tests passed, 2 tests failed out of 9\n\nLabel Time Summary:\n"
           "right      =   0.01 sec*proc (2 tests)\n\nTotal Test time (real) =   0.10 sec\n")
TESTS = {
    f"{LAB}/stub/1.1/Skew": "run", f"{LAB}/stub/1.2/Point": "run",
    f"{LAB}/reference/1.1/Skew": "run", f"{LAB}/by_matrices/1.1/Skew": "run",
    f"{LAB}/reference/1.2/Point": "fail",
    f"{LAB}/nan/1.1/Skew": "run", f"{LAB}/mistake/1.1/transposed": "run",
    f"{LAB}/mistake/1.1/sign": "notrun",
    "kit/render/A frame is drawn": "run", "kit/command/checklist": "run",
    "kit/grading/slurm": "notrun", "kit/grading/points": "run",
}


def junit() -> str:
    return "<testsuite>" + "".join(
        f'<testcase name="{name}" status="{status}">'
        f"<system-out>output of {name}</system-out></testcase>"
        for name, status in TESTS.items()) + "</testsuite>"


class Verify(KitTestCase):
    def setUp(self) -> None:
        super().setUp()
        self.kit.write("fake/junit.xml", junit())
        self.kit.write("fake/console.txt", f" 1/10 Test  #1: x ....   Passed\n\n{SUMMARY}\n"
                       "The following tests FAILED:\n"
                       f"\t  5 - {LAB}/reference/1.2/Point (SEGFAULT)\n"
                       "The following tests did not run:\n"
                       "\t 11 - kit/grading/slurm (Skipped)\n"
                       "Errors while running CTest\n")
        self.kit.write("fake/ctest_fails", "")

    def test_each_cell_counts_its_tests(self) -> None:
        text = self.kit.tumble("verify").stdout
        rows = [line.split() for line in text.splitlines()]
        self.assertIn("Lab 1: spin & <turn> stub fails right passes NaN fails mistakes caught",
                      [" ".join(row) for row in rows])
        self.assertIn("1.1 The cross product as a matrix 1/1 2/2 1/1 1/2 ✗".split(), rows)
        self.assertIn("1.2 Points of the body 1/1 0/1 - - ✗".split(), rows)
        self.assertIn("all 2/2 2/3 1/1 1/2 ✗".split(), rows)
        self.assertIn("render 1/1 ✓".split(), rows)
        self.assertIn("command 1/1 ✓".split(), rows)

    def test_what_was_skipped_is_named_and_no_failure(self) -> None:
        text = self.kit.tumble("verify").stdout
        self.assertIn("grading 1/1 ✓".split(), [line.split() for line in text.splitlines()])
        self.assertIn("  skipped: kit/grading/slurm\n", text)
        self.assertNotIn("output of kit/grading/slurm", text)

    def test_ctests_summary_comes_last_and_failures_before_it(self) -> None:
        done = self.kit.tumble("verify")
        self.assertEqual(done.returncode, 8)
        self.assertTrue(done.stdout.endswith(SUMMARY))
        self.assertIn(f"{LAB}/reference/1.2/Point (SEGFAULT)\noutput of", done.stdout)
        self.assertNotIn("output of kit", done.stdout)

    def test_it_leaves_the_students_own_tests_out_and_what_takes_long(self) -> None:
        self.kit.tumble("verify")
        self.assertEqual(len(self.kit.calls("ctest")), 1)
        self.assertIn("-LE ^(student|long)$", self.kit.calls("ctest")[0])

    def test_all_of_it_takes_in_what_takes_long_and_the_sanitizers(self) -> None:
        done = self.kit.tumble("verify", "--all")
        self.assertEqual(done.returncode, 1)
        self.assertIn("clang++ is missing", done.stdout)
        self.kit.add_tool("clang++", "")
        self.assertEqual(self.kit.tumble("verify", "--all").returncode, 8)
        for call, words in zip(self.kit.calls("ctest"), ("build/ci -LE ^student$",) * 2 +
                               ("build/sanitize -L ^(right|kit)$",)):
            self.assertIn(words, call)

    def test_a_handout_says_that_it_has_no_solutions(self) -> None:
        (self.kit.root / "solutions" / LAB / "spin.cpp").unlink()
        for arguments in (["verify"], ["frames", "1", "--solution"], ["handout", "x.tar.gz"],
                          ["grade", "."]):
            done = self.kit.tumble(*arguments)
            self.assert_one_line(done, 1)
            self.assertIn("needs the solutions, but this is a hand-out, which has none",
                          done.stderr)


if __name__ == "__main__":
    unittest.main()
