"""A student unpacks the hand-out, tests, looks, and writes one step. It builds: minutes."""

import os
import re
import shutil
import subprocess
import tarfile
import tempfile
import unittest
from pathlib import Path

from fake_kit import ROOT

LAB = "labs/1_rigid_body_kinematics/rigid_body_kinematics.cpp"
ANSWER = "solutions/1_rigid_body_kinematics/rigid_body_kinematics.cpp"
STEPS = ("1.1", "1.2", "1.3", "1.4", "1.5", "1.6")


def body(text: str, function: str) -> str:
    found = re.search(rf"^\w[^\n]* {function}\([^{{]*\{{\n.*?^\}}\n", text,
                      re.MULTILINE | re.DOTALL)
    assert found, function
    return found.group(0)


class Student(unittest.TestCase):
    def setUp(self) -> None:
        folder = Path(tempfile.mkdtemp(prefix="tumble student "))
        self.addCleanup(shutil.rmtree, folder)
        file = folder / "kit.tar.gz"
        subprocess.run([ROOT / "tumble", "handout", file], check=True, capture_output=True)
        with tarfile.open(file) as archive:
            archive.extractall(folder)
        self.kit = folder / "tumble"

    def tumble(self, *arguments: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run([self.kit / "tumble", *arguments], text=True, capture_output=True,
                              encoding="utf-8", env={**_environment(), "LANG": "C.UTF-8"})

    def words(self) -> dict[str, tuple[int, int, str]]:
        """Of each step: tests passed, all, and the word."""
        done = self.tumble("test", "1")
        rows = re.findall(r"^  . (\d\.\d) .* (\d+)/(\d+)  ([a-z ]+)$", done.stdout, re.MULTILINE)
        self.assertEqual(tuple(row[0] for row in rows), STEPS, done.stdout + done.stderr)
        return {step: (int(passed), int(all_), word) for step, passed, all_, word in rows}

    def test_a_student_starts_looks_and_writes_one_step(self) -> None:
        for passed, all_, word in self.words().values():
            self.assertEqual((passed, word), (0, "not written yet"))
            self.assertGreaterEqual(all_, 4)

        doctor = self.tumble("doctor")
        self.assertEqual(doctor.returncode, 0, doctor.stdout + doctor.stderr)
        if "Pictures: none" not in doctor.stdout:
            frames = self.tumble("frames", "1", "--to", "0.2", "--size", "64x64")
            self.assertIn("not written yet", frames.stdout + frames.stderr)
            self.assertRegex(frames.stdout + frames.stderr, r"1\.\d [a-z_]+")

        stub = self.kit / LAB
        text = stub.read_text(encoding="utf-8")
        answer = (ROOT / ANSWER).read_text(encoding="utf-8")
        stub.write_text(text.replace(body(text, "skew"), body(answer, "skew")), encoding="utf-8")
        words = self.words()
        passed, all_, word = words.pop("1.1")
        self.assertEqual((passed, word), (all_, "done"))
        for passed, _, word in words.values():
            self.assertEqual((passed, word), (0, "not written yet"))


def _environment() -> dict[str, str]:
    """Of this process, without what would make the build another one."""
    return {name: value for name, value in os.environ.items()
            if not name.startswith(("CMAKE_GENERATOR", "TUMBLE", "LC_"))}


if __name__ == "__main__":
    unittest.main()
