"""A small copy of the kit with one lab, and tools that only pretend to build and install."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from typing import Mapping, Optional

ROOT = Path(__file__).resolve().parents[2]
LAB = "1_spin"

_SYSTEM_TOOLS = ("sh", "dirname", "readlink", "id", "mkdir", "env", "cat", "touch", "cp", "uname",
                 "sleep", "true")

_HANDOUT = """# Lab 1: spin & <turn>

## Step 1.1: The cross product as a matrix
## Step 1.2: Points of the body
## Step 1.3: Forces
## Step 1.4: Matrices
## Step 1.5: Quaternions
## Step 1.6: The exponential map
"""

_STUB = 'Wrench net_wrench() {\n  throw common::NotImplemented("1.3 net_wrench");\n}\n'

# Each tool notes its call in the folder `calls` and does as little as the command can live with.
_TOOLS = {
    "cmake": """
case "$1" in
  --preset) mkdir -p "build/$2"; touch "build/$2/build.ninja"
    echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" > "build/$2/CMakeCache.txt" ;;
  --build) case "$*" in
      *"--target help"*) [ ! -f "$FAKE/targets" ] || cat "$FAKE/targets" ;;
    esac ;;
esac
""",
    "ninja": """
if [ -f "$FAKE/build_error" ]; then cat "$FAKE/build_error"; exit 1; fi
""",
    "ctest": """
while [ $# -gt 0 ]; do
  if [ "$1" = --output-junit ] && [ -f "$FAKE/junit.xml" ]; then cp "$FAKE/junit.xml" "$2"; fi
  shift
done
[ ! -f "$FAKE/console.txt" ] || cat "$FAKE/console.txt"
[ ! -f "$FAKE/ctest_fails" ] || exit 8
""",
    "dpkg-query": """
shift 3
for name; do
  grep_missing=no
  for missing in $MISSING; do [ "$missing" != "$name" ] || grep_missing=yes; done
  [ "$grep_missing" = yes ] || echo "$name installed"
done
""",
    "apt-get": "exit 1\n",
    "apt-cache": """
for name; do :; done
for unknown in $UNKNOWN; do [ "$unknown" != "$name" ] || exit 100; done
echo "Package: $name"
""",
}


class FakeKit:
    """Runs ./tumble in the copy, with the pretending tools as the only ones there are."""

    def __init__(self) -> None:
        self.root = Path(tempfile.mkdtemp(prefix="tumble test ")).resolve()
        self.fake = self.root / "fake"
        self.tools = self.fake / "bin"
        self.tools.mkdir(parents=True)
        (self.fake / "calls").mkdir()
        shutil.copy(ROOT / "tumble", self.root)
        for part in ("common/command", "solutions/grading/command"):
            shutil.copytree(ROOT / part, self.root / part,
                            ignore=shutil.ignore_patterns("__pycache__"))
        self.write(f"labs/{LAB}/README.md", _HANDOUT)
        self.write(f"labs/{LAB}/spin.cpp", _STUB)
        self.write(f"solutions/{LAB}/spin.cpp", "")
        for name in _SYSTEM_TOOLS:
            os.symlink(shutil.which(name) or "", self.tools / name)
        self.add_tool("python3", f'exec "{sys.executable}" "$@"\n')
        for name, body in _TOOLS.items():
            self.add_tool(name, f'echo "$*" >> "$FAKE/calls/{name}"\n{body}')

    def close(self) -> None:
        shutil.rmtree(self.root)

    def write(self, path: str, text: str) -> Path:
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
        return file

    def add_tool(self, name: str, body: str) -> None:
        self.add_program(self.tools / name, body)

    def add_program(self, path: Path, body: str) -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.unlink(missing_ok=True)  # a link: root would write over the machine's own program
        path.write_text(f"#!/bin/sh\n{body}", encoding="utf-8")
        path.chmod(0o755)

    def calls(self, tool: str) -> list[str]:
        record = self.fake / "calls" / tool
        return record.read_text(encoding="utf-8").splitlines() if record.exists() else []

    def tumble(self, *arguments: str, program: Optional[Path] = None, cwd: Optional[Path] = None,
               settings: Optional[Mapping[str, str]] = None) -> subprocess.CompletedProcess[str]:
        environment = {"PATH": str(self.tools), "FAKE": str(self.fake), "LANG": "C.UTF-8",
                       "MISSING": "", "UNKNOWN": "", **(settings or {})}
        return subprocess.run([program or self.root / "tumble", *arguments], cwd=cwd or self.root,
                              env=environment, text=True, encoding="utf-8", errors="replace",
                              capture_output=True, stdin=subprocess.DEVNULL, timeout=60)


class KitTestCase(unittest.TestCase):
    def setUp(self) -> None:
        self.kit = FakeKit()
        self.addCleanup(self.kit.close)

    def assert_cause_and_remedy(self, done: subprocess.CompletedProcess[str]) -> None:
        """One line says what is wrong, one what helps."""
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stderr, r"\A(tumble: installing[^\n]*\n)?(tumble: [^\n]+\n){2}\Z")
        self.assertNotIn("Traceback", done.stdout)

    def assert_one_line(self, done: subprocess.CompletedProcess[str], code: int) -> None:
        """One clear line on stderr, that code, and no traceback."""
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertRegex(done.stderr, r"\Atumble: [^\n]+\n\Z")
        self.assertNotIn("Traceback", done.stdout)
