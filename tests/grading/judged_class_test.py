"""A small class for each of two labs, graded by the real judge. It builds: minutes."""

import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from class_kit import snapshot
from fake_kit import ROOT

HERE = Path(__file__).resolve().parent
STUDENTS = 16
"""Enough to meet every kind but one."""


class JudgedClass(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = Path(tempfile.mkdtemp(prefix="tumble class "))
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / "secret").write_text("0123456789abcdef0123456789abcdef", encoding="ascii")

    def grade(self, *options: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run([ROOT / "tumble", "grade", self.folder / "class", "--out",
                               self.folder / "out", "--secret", self.folder / "secret", "--labs",
                               "1", *options], text=True, capture_output=True)

    def test_everyone_gets_what_is_due_twice_the_same(self) -> None:
        subprocess.run([sys.executable, "-B", HERE / "generate_class.py", self.folder / "class",
                        "--students", str(STUDENTS)], check=True, capture_output=True)
        done = self.grade()
        if done.returncode == 3 and "cannot be trusted" not in done.stderr:
            self.skipTest(done.stderr)  # no sandbox here, and it says so
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        expected = json.loads((self.folder / "class.expected.json").read_text(encoding="utf-8"))
        self.assertEqual(len(expected), STUDENTS)
        for student, labs in expected.items():
            (least, most), = labs.values()
            results = json.loads((self.folder / "out" / student / "results.json").read_text(
                encoding="utf-8"))
            with self.subTest(student=student):
                self.assertGreaterEqual(results["score"], least)
                self.assertLessEqual(results["score"], most)
                self.assertTrue(results["extra_data"]["labs"][0]["sandboxed"])
        print(done.stdout)
        before = snapshot(self.folder / "out")
        self.assertEqual(self.grade("--resume").returncode, 0)
        self.assertEqual(snapshot(self.folder / "out"), before)


if __name__ == "__main__":
    unittest.main()
