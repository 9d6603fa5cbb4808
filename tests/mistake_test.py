"""Runs a lab's tests on an answer with one mistake in it and checks that they catch it.

usage: mistake_test.py PROGRAM STEP WORDS

A test case of STEP must fail, and the likely mistakes that the cases of STEP name must be one and
hold WORDS; with empty WORDS none may be named. Cases of other steps, which may rest on this one and
end the program, are not run. Exit code 0 where all of this holds.
"""
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path


def run(program: str, step: str) -> ElementTree.Element:
    """The XML report of the step's cases; what a case printed on stderr stands in it."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.xml"
        subprocess.run([program, f"[{step}]", "-r", "xml", "-o", str(report)], stderr=subprocess.DEVNULL,
                       stdout=subprocess.DEVNULL, timeout=100, check=False)
        return ElementTree.parse(report).getroot()


def likely_mistakes(case: ElementTree.Element) -> set[str]:
    """What the failing checks of a case named."""
    return {line.removeprefix("| likely").strip()
            for printed in case.iter("StdErr") for line in printed.text.splitlines()
            if line.startswith("| likely")}


def main() -> int:
    program, step, words = sys.argv[1:]
    failed = [case for case in run(program, step).iter("TestCase")
              if case.find("OverallResult").get("success") != "true"]
    likely = set().union(*map(likely_mistakes, failed))
    for case in failed:
        print(f"fails: {case.get('name')}")
    for line in sorted(likely):
        print(f"| likely  {line}")

    complaints = []
    if not failed:
        complaints.append(f"no test of step {step} fails")
    if words and not any(words in line for line in likely):
        complaints.append(f"no message names '{words}'")
    for line in sorted(likely):
        if not words or words not in line:
            complaints.append(f"a message names another mistake: {line}")
    for complaint in complaints:
        print(f"not caught: {complaint}")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
