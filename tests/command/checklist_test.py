"""./tumble test: the checklist from what a test program records, the first failure explained."""

import subprocess
import time
import unittest

from fake_kit import LAB
from recorded_tests import RecordedTests
from student_records import NAMES, record


class Checklist(RecordedTests):
    def test_each_step_has_its_line_and_word(self) -> None:
        done = self.kit.tumble("test", "1")
        self.assertEqual((done.returncode, done.stderr), (1, ""))
        self.assertIn("Lab 1: spin & <turn>", done.stdout)
        for line in ("✓ 1.1  The cross product as a matrix    2/2  done",
                     "✗ 1.2  Points of the body               1/3  wrong",
                     "· 1.3  Forces                           0/1  not written yet",
                     "✗ 1.4  Matrices                         0/2  crashed",
                     "✗ 1.5  Quaternions                      0/1  timed out",
                     "✗ 1.6  The exponential map              0/1  exception"):
            self.assertIn(line, done.stdout)

    def test_the_first_failure_is_explained_and_no_other(self) -> None:
        text = self.kit.tumble("test", "1").stdout
        self.assertIn("First failure: A point turns about the centre of mass\n"
                      "step     1.2 point_velocity\n"
                      "case     3 of 100\n"
                      "input    state.position = Vec3(1, 2, 3);\n"
                      "         point = Vec3(0, 0, 1);\n"
                      "got      (1, 0, 0)\n", text)
        self.assertIn("likely   the cross product is the wrong way round", text)
        self.assertNotIn("case     4 of 100", text)
        self.assertNotIn("A far point", text)
        self.assertIn("./tumble test 1 --all", text)

    def test_all_explains_every_failure_from_what_is_known_of_it(self) -> None:
        text = " ".join(self.kit.tumble("test", "1", "--all").stdout.split())
        for words in ("FAILED: CHECK( error < 1e-12 ) with expansion: 0.25 < 0.0",
                      "crashed (SIGSEGV); usual causes",
                      "this assert did not hold: determinant > 0.0",
                      "did not end in time", "an exception was thrown: vector::_M_range_check"):
            self.assertIn(words, text)

    def test_without_utf8_the_signs_are_plain(self) -> None:
        text = self.kit.tumble("test", "1", settings={"LANG": "C"}).stdout
        self.assertIn("+ 1.1", text)
        self.assertIn("x 1.2", text)
        self.assertTrue(text.isascii())

    def test_a_hint_is_offered_only_where_there_are_hints(self) -> None:
        self.assertNotIn("./tumble hint", self.kit.tumble("test", "1").stdout)
        self.kit.write(f"labs/{LAB}/hints.md", "")
        self.assertIn("./tumble hint 1.2", self.kit.tumble("test", "1").stdout)

    def test_an_untouched_stub_is_told_where_to_begin(self) -> None:
        self.record_steps("  1.1 skew is not written yet", "  1.2 world_point is not written yet")
        done = self.kit.tumble("test", "1")
        self.assertEqual(done.returncode, 1)
        self.assertIn("Nothing is written yet", done.stdout)
        self.assertIn("write skew of step 1.1", done.stdout)
        self.assertNotIn("failure", done.stdout)

    def test_what_is_written_and_right_leads_to_the_next_step_and_line(self) -> None:
        self.record_steps("", "", "  1.3 net_wrench is not written yet")
        self.assertIn(f"write net_wrench of step 1.3 in labs/{LAB}/spin.cpp:2",
                      self.kit.tumble("test", "1").stdout)

    def test_when_all_is_right_the_exit_code_is_0(self) -> None:
        self.record_steps("", "")
        done = self.kit.tumble("test", "1")
        self.assertEqual(done.returncode, 0)
        self.assertIn("All done.", done.stdout)

    def test_what_the_answer_prints_is_shown_and_cut(self) -> None:
        long = "".join(f"line {i}\n" for i in range(30))
        self.record_steps(long + "| step    1.1 skew\n| got     1\n" + "~" * 79 + "\nCatch\n")
        text = self.kit.tumble("test", "1").stdout
        self.assertIn("prints   line 0\n         line 1\n", text)
        self.assertIn('line 19\n         ... 10 more lines: ./tumble test 1 --case "Case 1"', text)
        self.assertNotIn("Catch", text)

    def test_a_crash_says_what_was_asked_and_its_usual_causes(self) -> None:
        self.record(record(0, "| step    1.1 skew\n| input   w = 1;\n"
                           "t: x.h:9: f(): Assertion `n < size()' failed.\n", "signal 6"),
                    "1.1|Case 1\n")
        text = " ".join(self.kit.tumble("test", "1").stdout.split())
        self.assertIn("step 1.1 skew input w = 1; note the program crashed (SIGABRT)", text)
        self.assertIn("n < size(); usual causes are", text)
        self.assertNotIn("prints", text)

    def test_a_compile_error_is_shown_without_the_build_tools_noise(self) -> None:
        self.kit.write("fake/build_error", (
            "[1/3] Building CXX object spin.cpp.o\n"
            "FAILED: spin.cpp.o \n/usr/bin/c++ -DX -o spin.cpp.o\n"
            f"{self.kit.root}/labs/{LAB}/spin.cpp:7:3: error: expected ';'\n"
            + "note: long\n" * 1000 + "ninja: build stopped: subcommand failed.\n"))
        done = self.kit.tumble("test", "1")
        self.assertEqual(done.returncode, 1)
        self.assertTrue(done.stderr.startswith("tumble: spin.cpp does not build"))
        self.assertIn(f"\nlabs/{LAB}/spin.cpp:7:3: error: expected ';'", done.stderr)
        self.assertLess(len(done.stderr), 4500)
        for noise in ("FAILED", "/usr/bin/c++", "ninja:", "[1/3]"):
            self.assertNotIn(noise, done.stderr)

    def test_a_program_that_ends_before_its_first_test_is_reported(self) -> None:
        self.record(b"", NAMES)
        done = self.kit.tumble("test", "1")
        self.assert_one_line(done, 1)
        self.assertIn("before its first test", done.stderr)

    def test_the_rest_of_a_hopeless_step_is_counted(self) -> None:
        self.record(record(0, "", "timeout 0") + record(1, "", "skipped 0")
                    + record(2, "", "skipped 0"), "1.1|A\n1.1|B\n1.1|C\n")
        text = " ".join(self.kit.tumble("test", "1").stdout.split())
        self.assertIn("did not end in time", text)
        self.assertIn("2 more cases of step 1.1 were not run", text)

    def test_a_second_command_waits_for_the_first_and_goes_on(self) -> None:
        """Both find the answer right, though each would spoil what the other builds."""
        self.record_steps("", "")
        marks, go = self.kit.fake / "marks", self.kit.fake / "go"
        self.kit.add_tool("ninja", f'echo in >> "{marks}"\n'
                          f'while [ ! -f "{go}" ]; do sleep 0.05; done\necho out >> "{marks}"\n')
        self.addCleanup(go.touch)
        first = self.start_test()
        deadline = time.monotonic() + 30.0
        while not marks.exists():
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.02)
        second = self.start_test()
        self.assertRegex(second.stderr.readline(), r"\Atumble: waiting for \./tumble test 1 "
                         r"\(process \d+\), which uses build/dev\n\Z")
        go.touch()
        said = [process.communicate(timeout=60) for process in (first, second)]
        self.assertEqual([first.returncode, second.returncode], [0, 0], said)
        self.assertEqual(marks.read_text().split(), ["in", "out"] * 4)
        self.assertEqual([errors for _, errors in said], ["", ""])

    def start_test(self) -> subprocess.Popen:
        environment = {"PATH": str(self.kit.tools), "FAKE": str(self.kit.fake), "LANG": "C.UTF-8"}
        return subprocess.Popen([self.kit.root / "tumble", "test", "1"], env=environment, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def test_cmake_is_run_once_and_again_when_the_kit_was_moved(self) -> None:
        self.kit.tumble("test", "1")
        self.kit.tumble("test", "1")
        self.assertEqual(sum("--preset" in call for call in self.kit.calls("cmake")), 1)
        self.kit.write("build/dev/CMakeCache.txt", "CMAKE_HOME_DIRECTORY:INTERNAL=/elsewhere\n")
        self.kit.tumble("test", "1")
        self.assertEqual(sum("--preset" in call for call in self.kit.calls("cmake")), 2)

    def test_without_cmake_one_line_says_what_to_install(self) -> None:
        (self.kit.tools / "cmake").unlink()
        done = self.kit.tumble("test", "1")
        self.assert_one_line(done, 1)
        self.assertIn("install cmake", done.stderr)


if __name__ == "__main__":
    unittest.main()
