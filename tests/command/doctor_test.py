"""./tumble doctor and watch."""

import os
import signal
import subprocess
import time
import unittest

from fake_kit import LAB, KitTestCase
from tumble import doctor
from tumble.machine import Finding


class Doctor(KitTestCase):
    def test_without_a_compiler_the_labs_cannot_be_built(self) -> None:
        done = self.kit.tumble("doctor")
        self.assertEqual((done.returncode, done.stderr), (1, ""))
        self.assertIn("Labs cannot be built yet", done.stdout)
        self.assertIn("libeigen3-dev", done.stdout)

    def test_too_old_is_told_apart_from_missing(self) -> None:
        lines = doctor.report([Finding("c++", "gcc 9.4.0", False, "C++20", "g++"),
                               Finding("gnuplot", "", False, "charts", "gnuplot-nox", False)])
        self.assertIn("gcc 9.4.0, too old", lines[0])
        self.assertIn("missing", lines[1])

    def test_what_is_missing_for_pictures_alone_does_not_stop_the_labs(self) -> None:
        missing = [Finding("EGL", "", False, "pictures", "libegl-dev", needed=False)]
        self.assertIn("Labs can be built", "\n".join(doctor.advice(missing)))


class Watch(KitTestCase):
    def test_a_save_runs_the_tests_again_and_an_interrupt_ends_it_well(self) -> None:
        self.kit.write(f"build/dev/labs/{LAB}/cases.txt", "1.1|Skew\n")
        passed = "All tests passed (1 assertion in 1 test case)"
        self.kit.add_program(self.kit.root / f"build/dev/labs/{LAB}/spin_student_test",
                             f'echo run >> "$FAKE/calls/program"\n'
                             f'echo "case 0 exit 0 0.1 {len(passed)}"; echo "{passed}"\n')
        environment = {"PATH": str(self.kit.tools), "FAKE": str(self.kit.fake)}
        with subprocess.Popen([self.kit.root / "tumble", "watch", "1"], env=environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            self.wait_for_runs(1)
            stub = self.kit.root / "labs" / LAB / "spin.cpp"
            os.utime(stub, (time.time() + 10, time.time() + 10))
            self.wait_for_runs(2)
            time.sleep(0.3)
            process.send_signal(signal.SIGINT)
            output, errors = process.communicate(timeout=20)
        self.assertEqual((process.returncode, errors), (0, ""))
        self.assertEqual(output.count("All done."), 2)

    def wait_for_runs(self, count: int) -> None:
        deadline = time.monotonic() + 20.0
        while len(self.kit.calls("program")) < count:
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.02)


if __name__ == "__main__":
    unittest.main()
