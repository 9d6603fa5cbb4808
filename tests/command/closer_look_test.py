"""./tumble test: what the sanitizers find where all passes, what compiler and linker say."""

import unittest

from fake_kit import LAB
from recorded_tests import RecordedTests
from student_records import PASSED, record


class Sanitized(RecordedTests):
    def found(self, output: str) -> str:
        """What is said where all passes, but for this under the sanitizers."""
        self.record_steps("", "")
        (self.kit.fake / "found").write_bytes(record(0, PASSED, "exit 0")
                                              + record(1, output, "exit 1"))
        done = self.kit.tumble("test", "1")
        self.assertEqual((done.returncode, done.stderr), (1, ""))
        self.assertNotIn("All done.", done.stdout)
        self.assertIn("All tests pass, but with undefined behaviour: Case 2", done.stdout)
        return " ".join(done.stdout.split())

    def test_undefined_behaviour_is_found_where_all_passes(self) -> None:
        text = self.found(
            "| step    1.2 turned\n| input   w = 1;\n==7==ERROR: AddressSanitizer: "
            "heap-use-after-free on address 0x1 at pc 0x2\nREAD of size 8\n"
            "    #0 0x1 in std::vector<int>::at /usr/include/vector:9\n"
            f"    #1 0x2 in lab::spin::skew() /kit/labs/{LAB}/spin.cpp:2\n")
        self.assertIn("step 1.2 turned input w = 1; at "
                      f'labs/{LAB}/spin.cpp:2', text)
        self.assertIn("your code uses memory that was freed", text)

    def test_so_are_overflow_and_numbers_that_are_never_set(self) -> None:
        text = self.found(f"/kit/labs/{LAB}/spin.cpp:1:8: runtime error: index 3 out of bounds\n")
        self.assertIn(f"at labs/{LAB}/spin.cpp:1", text)
        self.assertIn("index 3 out of bounds", text)
        self.assertIn("compiled with other options, it gives another answer",
                      self.found("| step    1.2 turned\n| got     1\n"))

    def test_the_same_object_file_is_looked_at_once(self) -> None:
        self.record_steps("", "")
        objects = f"build/dev/labs/{LAB}/CMakeFiles/spin_student.dir/spin.cpp.o"
        self.kit.write(f"build/dev/labs/{LAB}/libspin_tests.so", "tests")
        for code, runs in (("a", 1), ("a", 1), ("b", 2)):
            self.kit.write(objects, code)
            self.assertIn("All done.", self.kit.tumble("test", "1").stdout)
            self.assertEqual(len(self.kit.calls("sanitized")), runs)

    def test_without_sanitizers_it_is_done_and_that_is_said(self) -> None:
        self.record_steps("", "")
        (self.kit.root / f"build/dev/labs/{LAB}/spin_student_sanitized_test").unlink()
        done = self.kit.tumble("test", "1")
        self.assertEqual(done.returncode, 0)
        self.assertIn("The sanitizers do not run here", done.stdout)


class Diagnosis(RecordedTests):
    def test_a_function_that_the_linker_misses_is_named_with_its_step(self) -> None:
        self.kit.write(f"labs/{LAB}/spin.hpp", "/// Turns.\nVec3 turned(const Vec3& v);\n")
        self.kit.write("tests/spin/turned_test.cpp", 'Trial("1.2 turned")')
        for words in ("/usr/bin/ld: libspin_tests.so: undefined reference to "
                      "`lab::spin::turned(Eigen::Matrix<double, 3, 1> const&)'",
                      "ld.lld: error: undefined symbol: lab::spin::turned(int)\n>>> referenced by"):
            self.kit.write("fake/build_error", words + "\ncollect2: error\n")
            done = self.kit.tumble("test", "1")
            self.assert_one_line(done, 1)
            self.assertIn("spin.cpp: turned of step 1.2 is missing or differs from the header "
                          f"(labs/{LAB}/spin.hpp:2)", done.stderr)

    def test_the_students_line_stands_before_the_templates(self) -> None:
        self.kit.write("fake/build_error", (
            "In file included from /usr/include/Eigen/Core:1,\n"
            "In member function ‘void copy()’,\n"
            + "    inlined from ‘void deep()’ at /usr/include/Eigen/a.h:1:2,\n" * 200
            + f"    inlined from ‘Vec3 skew()’ at {self.kit.root}/labs/{LAB}/spin.cpp:2:9:\n"
            "/usr/include/Eigen/a.h:6:5: warning: ‘x’ is used uninitialized [-Wuninitialized]\n"
            f"{self.kit.root}/labs/{LAB}/spin.cpp:1:3: note: ‘x’ declared here\n"
            "/usr/include/Eigen/b.h:6:5: error: no match\n"))
        error = self.kit.tumble("test", "1").stderr
        source = (self.kit.root / f"labs/{LAB}/spin.cpp").read_text().splitlines()[1].strip()
        self.assertIn(f"\n\nlabs/{LAB}/spin.cpp:2: warning: ‘x’ is used uninitialized "
                      f"[-Wuninitialized]\n    {source}\n\n", error)
        self.assertRegex(error, r"\.\.\. \d+ more lines in build/dev/build\.log")


if __name__ == "__main__":
    unittest.main()
