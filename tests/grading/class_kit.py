"""A small kit whose judge is a stand-in, and folders of submissions for it."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

from fake_kit import ROOT, KitTestCase

STAND_IN = Path(__file__).with_name("stand_in")
STEPS = ("1.1", "1.2", "1.3", "1.4", "1.5", "1.6")
ALL = "// passes " + " ".join(STEPS) + "\n"

_STUB = 'Wrench net_wrench() {\n  throw common::NotImplemented("1.3 net_wrench");\n}\n'
_TABLE = {"undefined_behaviour": -10, "steps": {
    "1.1": {"points": 10}, "1.2": {"points": 20}, "1.3": {"points": 20},
    "1.4": {"points": 20, "depends_on": ["1.1"]}, "1.5": {"points": 30},
    "1.6": {"points": 15, "bonus": True}}}


class ClassTestCase(KitTestCase):
    def setUp(self) -> None:
        super().setUp()
        for name in ("judge.py", "sandbox.py"):
            shutil.copy(STAND_IN / name, self.kit.root / "solutions/grading/command/grading" / name)
        handout = self.kit.root / "labs/1_spin/README.md"
        handout.write_text(handout.read_text(encoding="utf-8").replace(
            "Step 1.6: The", "Step 1.6: Challenge: the"), encoding="utf-8")
        self.kit.write("labs/1_spin/spin.cpp", _STUB)
        self.kit.write("solutions/1_spin/spin.cpp", ALL)
        self.write_table(_TABLE)
        self.kit.write("tests/spin/spin_test.cpp", "".join(
            f'TEST_CASE("{case}", "[{step}]") {{}}\n' for step in STEPS
            for case in ("One", "Two & <b>three</b>")))
        self.kit.write("secret", "0123456789abcdef0123456789abcdef\n")
        self.folder = self.kit.root / "class"
        self.folder.mkdir()
        self.out = self.kit.root / "results"

    def write_table(self, table: object) -> None:
        self.kit.write("solutions/1_spin/points.json", json.dumps(table))

    def hand_in(self, student: str, text: str) -> Path:
        return self.kit.write(f"class/{student}/spin.cpp", text)

    def grade(self, *options: str) -> subprocess.CompletedProcess[str]:
        return self.kit.tumble("grade", str(self.folder), "--out", str(self.out), "--secret",
                               str(self.kit.root / "secret"), *options)

    def results(self, student: str) -> dict:
        return json.loads((self.out / student / "results.json").read_text(encoding="utf-8"))

    def page(self, student: str) -> str:
        return (self.out / student / "index.html").read_text(encoding="utf-8")

    def judged(self) -> int:
        """How many files the judge has seen."""
        log = self.kit.root / "judged.log"
        return len(log.read_text(encoding="utf-8").splitlines()) if log.exists() else 0


def snapshot(folder: Path) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes()
            for path in sorted(folder.rglob("*")) if path.is_file()}


__all__ = ["ALL", "ROOT", "STEPS", "ClassTestCase", "snapshot"]
