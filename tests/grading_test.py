"""Tests of hand-out and grading: python3 -B tests/grading_test.py [intake points ...]."""

import sys
import unittest
from pathlib import Path

TESTS = Path(__file__).resolve().parent / "grading"
ROOT = TESTS.parents[1]
SLOW = {"attack", "judged", "handout_student", "judged_class"}
"""They build, so they run where they are named."""


def main() -> int:
    sys.dont_write_bytecode = True
    sys.path[:0] = [str(TESTS), str(ROOT / "tests" / "command"), str(ROOT / "common" / "command")]
    found = {path.name[: -len("_test.py")] for path in TESTS.glob("*_test.py")}
    names = sys.argv[1:] or sorted(found - SLOW)
    suite = unittest.defaultTestLoader.loadTestsFromNames([f"{name}_test" for name in names])
    result = unittest.TextTestRunner().run(suite)
    return 0 if result.wasSuccessful() and result.testsRun else 1


if __name__ == "__main__":
    sys.exit(main())
