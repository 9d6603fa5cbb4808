"""./tumble doctor and watch."""

import os
import signal
import subprocess
import time
import unittest
from unittest import mock

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

    def test_what_is_too_old_gets_advice_that_helps(self) -> None:
        old = Finding("cmake", "3.22.1", False, "builds", "cmake", newer="get it elsewhere")
        told = "\n".join(doctor.advice([old]))
        self.assertIn("cmake 3.22.1 is too old: get it elsewhere", told)
        self.assertNotIn("apt-get install", told)

    def test_an_old_cmake_says_where_to_get_a_newer_one(self) -> None:
        self.kit.add_tool("cmake", 'echo "cmake version 3.22.1"\n')
        told = self.kit.tumble("doctor").stdout
        self.assertRegex(told, r"cmake 3\.22\.1 is too old: [^\n]*pip install")
        self.assertNotRegex(told, r"apt-get install[^\n]* cmake")

    def test_what_only_verify_takes_is_told_apart(self) -> None:
        tools = [Finding("bubblewrap", "", False, "grading", "bubblewrap", needed=False,
                         command="verify")]
        told = "\n".join(doctor.advice(tools))
        self.assertIn("To install what ./tumble verify needs: ./tumble verify", told)
        self.assertNotIn("./tumble demo", told)

    def test_nothing_is_built_for_a_test_frame(self) -> None:
        gl = [Finding(name, "yes", True, "pictures", "x") for name in ("OpenGL", "OSMesa")]
        with mock.patch("tumble.build.require") as require:
            told = "\n".join(doctor.test_frame(self.kit.root, gl))
            self.assertIn("./tumble frames 1 --solution builds the renderer", told)
            self.assertIn("no off-screen GL", doctor.test_frame(self.kit.root, gl[:1])[0])
            require.assert_not_called()

    def test_where_a_renderer_is_built_it_draws_a_test_frame(self) -> None:
        gl = [Finding(name, "yes", True, "pictures", "x") for name in ("OpenGL", "OSMesa")]
        render = self.kit.root / "build" / "release" / "render"
        self.kit.write("build/release/render/librender_scene.a", "")
        self.kit.add_program(render / "render_doctor", 'echo "OSMesa, a test"\n')
        with mock.patch("tumble.build.require"):
            told = doctor.test_frame(self.kit.root, gl)
        self.assertEqual(told[0], "Pictures: OSMesa, a test")


class ReadOnly(KitTestCase):
    """A file in the place of build/ is as good as a folder that cannot be written: root can."""

    def setUp(self) -> None:
        super().setUp()
        self.kit.write("build", "")

    def test_test_says_so_in_one_line_and_does_not_ask_cmake(self) -> None:
        done = self.kit.tumble("test", "1")
        self.assert_one_line(done, 1)
        self.assertIn(f"cannot write to {self.kit.root / 'build'}", done.stderr)
        self.assertEqual(self.kit.calls("cmake"), [])

    def test_doctor_says_so(self) -> None:
        done = self.kit.tumble("doctor")
        self.assertEqual((done.returncode, done.stderr), (1, ""))
        self.assertIn("Nothing can be built here: cannot write to", done.stdout)


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
