"""Runs all test cases of a right answer under other seeds of their random inputs: each must pass.

usage: seeds_test.py PROGRAM CASES

CASES is how many cases CMake read from the sources; another number in the program means that a case
is hidden from CTest. A bound that only just holds for the seed in the source shows up here.
"""
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

SEEDS = 25


def main() -> int:
    program, cases = sys.argv[1], int(sys.argv[2])
    wrong = 0
    for seed in range(1, SEEDS + 1):
        with tempfile.TemporaryDirectory() as folder:
            report = Path(folder) / "report.xml"
            subprocess.run([program, "-r", "xml", "-o", str(report)], check=False,
                           env={**os.environ, "TUMBLE_SEED": str(seed)}, stdout=subprocess.DEVNULL)
            run = list(ElementTree.parse(report).getroot().iter("TestCase"))
        if len(run) != cases:
            print(f"{len(run)} cases in the program, {cases} in CTest")
            return 1
        for case in run:
            if case.find("OverallResult").get("success") != "true":
                wrong += 1
                print(f"seed {seed}: {case.get('name')}")
                for printed in case.iter("StdErr"):
                    print(printed.text)
    print(f"{cases} cases, {SEEDS} seeds, {wrong} failures")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
