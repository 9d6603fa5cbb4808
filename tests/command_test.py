"""Tests of ./tumble: python3 -B tests/command_test.py [checklist hints ...]; without names, all."""

import sys
import unittest
from pathlib import Path

TESTS = Path(__file__).resolve().parent / "command"
ROOT = TESTS.parents[1]


def main() -> int:
    sys.dont_write_bytecode = True
    sys.path[:0] = [str(TESTS), str(ROOT / "common" / "command")]
    found = sorted(path.name[: -len("_test.py")] for path in TESTS.glob("*_test.py"))
    names = sys.argv[1:] or found
    suite = unittest.defaultTestLoader.loadTestsFromNames([f"{name}_test" for name in names])
    result = unittest.TextTestRunner().run(suite)
    return 0 if result.wasSuccessful() and result.testsRun else 1


if __name__ == "__main__":
    sys.exit(main())
