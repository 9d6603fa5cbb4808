"""./tumble test N --case: one case, as it runs."""

import unittest

from fake_kit import LAB, KitTestCase


class OneCase(KitTestCase):
    def setUp(self) -> None:
        super().setUp()
        self.kit.write(f"build/dev/labs/{LAB}/cases.txt",
                       "1.1|A turn\n1.1|A turn about x\n1.2|A far point\n")
        for kind in ("", "debug_"):
            self.kit.add_program(self.kit.root / f"build/dev/labs/{LAB}/spin_student_{kind}test",
                                 'echo "here: $*"; [ "$*" != "A far point" ]\n')

    def test_it_runs_alone_and_all_that_it_prints_is_shown(self) -> None:
        done = self.kit.tumble("test", "1", "--case", "ABOUT")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout, "step 1.1: A turn about x\n\nhere: A turn about x\n")
        self.assertEqual(self.kit.tumble("test", "1", "--case", "far").returncode, 1)
        self.assertIn("here: A turn\n", self.kit.tumble("test", "1", "--case", "A turn").stdout)

    def test_words_of_none_or_of_many_are_refused(self) -> None:
        self.assert_one_line(self.kit.tumble("test", "1", "--case", "near"), 2)
        done = self.kit.tumble("test", "1", "--case", "a ")
        self.assertEqual(done.returncode, 2)
        self.assertIn("3 cases match 'a ': give more of one title\n\n  1.1  A turn\n", done.stderr)

    def test_debug_opens_gdb_at_the_functions_of_the_step(self) -> None:
        self.kit.write(f"labs/{LAB}/spin.hpp", "Mat3 skew(const Vec3& w);\nVec3 far(double x);\n")
        self.kit.write("tests/spin/skew_test.cpp", 'Trial("1.1 skew") Trial("1.2 far")')
        self.kit.add_tool("gdb", 'echo "gdb $*"\n')
        done = self.kit.tumble("test", "1", "--case", "about", "--debug")
        self.assertIn("gdb -q -ex break lab::spin::skew -ex run --args "
                      f"{self.kit.root}/build/dev/labs/{LAB}/spin_student_debug_test "
                      "A turn about x\n", done.stdout)

    def test_debug_wants_gdb_and_a_case(self) -> None:
        done = self.kit.tumble("test", "1", "--case", "far", "--debug")
        self.assert_one_line(done, 1)
        self.assertIn("gdb is missing", done.stderr)
        self.assert_one_line(self.kit.tumble("test", "1", "--debug"), 2)


if __name__ == "__main__":
    unittest.main()
