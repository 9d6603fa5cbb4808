"""The bundle for Gradescope, packed, set up and run as its documents say, in a folder apart."""

import json
import os
import shutil
import subprocess
import sys
import unittest
import zipfile
from pathlib import Path

from class_kit import ALL, ROOT, ClassTestCase
from tumble.packages import PACKAGES

BUNDLE = Path("solutions/grading/gradescope")
_KEYS = {"score", "output", "output_format", "test_output_format", "test_name_format", "visibility",
         "stdout_visibility", "tests", "extra_data"}
_TEST_KEYS = {"name", "number", "score", "max_score", "status", "output", "visibility", "tags"}


class Gradescope(ClassTestCase):
    def setUp(self) -> None:
        super().setUp()
        shutil.copytree(ROOT / BUNDLE, self.kit.root / BUNDLE)
        self.kit.add_tool("dpkg-query", "echo installed\n")
        self.base = self.kit.root / "autograder"
        self.zip = self.kit.root / "bundle.zip"

    def run_in(self, *command: object) -> subprocess.CompletedProcess[str]:
        path = f"{self.kit.tools}:{os.environ['PATH']}"
        return subprocess.run([str(part) for part in command], text=True, capture_output=True,
                              env={**os.environ, "PATH": path, "AUTOGRADER": str(self.base),
                                   "FAKE": str(self.kit.fake)})

    def pack(self, *options: str) -> subprocess.CompletedProcess[str]:
        return self.run_in(sys.executable, "-B", self.kit.root / BUNDLE / "pack.py", self.zip,
                           "--labs", "1", "--secret", self.kit.root / "secret", *options)

    def set_up(self, *options: str) -> subprocess.CompletedProcess[str]:
        done = self.pack(*options)
        self.assertEqual(done.returncode, 0, done.stderr)
        with zipfile.ZipFile(self.zip) as archive:
            archive.extractall(self.base / "source")
        return self.run_in("bash", self.base / "source/setup.sh")

    def submit(self, text: str) -> subprocess.CompletedProcess[str]:
        shutil.rmtree(self.base / "submission", ignore_errors=True)
        (self.base / "submission" / "sub").mkdir(parents=True)
        (self.base / "submission" / "sub" / "spin.cpp").write_text(text, encoding="utf-8")
        return self.run_in("bash", self.base / "source/run_autograder")

    def results(self, _student: str = "") -> dict:
        return json.loads((self.base / "results/results.json").read_text(encoding="utf-8"))

    def test_a_submission_gets_results_as_gradescope_reads_them(self) -> None:
        done = self.set_up()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        for text, score in ((ALL, 115), ("// passes 1.1 1.2\n", 30), ("// says compile error\n", 0),
                            ("\0", 0)):
            done = self.submit(text)
            self.assertEqual(done.returncode, 0, done.stderr)
            results = self.results()
            self.assertEqual(results["score"], score)
            self.assertEqual(set(results), _KEYS)
            for test in results["tests"]:
                self.assertEqual(set(test), _TEST_KEYS)
                self.assertIn(test["status"], ("passed", "failed"))
                self.assertEqual(test["visibility"], "visible")  # or nobody sees a total
            self.assertLess(len(json.dumps(results)), 1 << 20)
        self.assertEqual(self.graded(), 2 + 3)  # the proof once, and each text that is one

    def graded(self) -> int:
        log = self.base / "grader/tumble/judged.log"
        return len(log.read_text(encoding="utf-8").splitlines())

    def test_a_grader_that_fails_leaves_no_result(self) -> None:
        self.set_up()
        self.submit(ALL)
        done = self.submit(ALL + "// says raise\n")
        self.assertNotEqual(done.returncode, 0)
        self.assertFalse((self.base / "results/results.json").exists())

    def test_without_a_sandbox_the_image_is_not_built(self) -> None:
        self.kit.write("no_sandbox", "")
        done = self.set_up()
        self.assertEqual(done.returncode, 3)
        self.assertIn("bubblewrap is missing", done.stderr)
        self.assertEqual(self.set_up("--no-sandbox").returncode, 0)
        self.submit(ALL)
        self.assertFalse(self.results()["extra_data"]["labs"][0]["sandboxed"])

    def test_students_code_cannot_read_secret_and_solutions(self) -> None:
        self.set_up()
        for folder in ("source", "grader"):
            self.assertEqual((self.base / folder).stat().st_mode & 0o077, 0)

    def test_bad_arguments_get_one_line(self) -> None:
        for options in (["--labs", "9"], ["--secret", "/no/such"]):
            done = self.pack(*options)
            self.assertNotEqual(done.returncode, 0)
            self.assertRegex(done.stderr, r"\Atumble: [^\n]+\n\Z")
        self.assertFalse(self.zip.exists())

    def test_the_same_kit_gives_the_same_zip(self) -> None:
        self.pack()
        before = self.zip.read_bytes()
        self.zip.unlink()
        self.pack()
        self.assertEqual(self.zip.read_bytes(), before)

    def test_it_installs_what_the_labs_need(self) -> None:
        listed = (ROOT / BUNDLE / "setup.sh").read_text(encoding="utf-8").split("packages=(")[1]
        names = set(listed.split(")")[0].split())
        needed = {package.name for package in PACKAGES if package.purpose in (
            "the C++20 compiler", "configures the build", "runs the build", "the tests",
            "vectors, matrices, quaternions", "exact references of the tests",
            "timings of the charts", "writes PNG pictures", "packs PNG pictures")}
        self.assertEqual(len(needed), 9)
        self.assertLessEqual(needed, names)


if __name__ == "__main__":
    unittest.main()
