"""Runs a lab's tests on an answer with one mistake in it and checks that they catch it.

usage: mistake_test.py PROGRAM STEP WORDS

A test case of STEP must fail, and every likely mistake that the tests name must hold WORDS; with
empty WORDS none may be named. Exit code 0 where all of this holds.
"""
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path


def run(program: str) -> tuple[ElementTree.Element, str]:
    """The XML report of all test cases and what they printed on stderr."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.xml"
        done = subprocess.run([program, "-r", "xml", "-o", str(report)], stderr=subprocess.PIPE,
                              stdout=subprocess.DEVNULL, text=True, timeout=100, check=False)
        return ElementTree.parse(report).getroot(), done.stderr


def main() -> int:
    program, step, words = sys.argv[1:]
    root, printed = run(program)
    failed = {case.get("name"): case.get("tags") for case in root.iter("TestCase")
              if case.find("OverallResult").get("success") != "true"}
    own = [name for name, tags in failed.items() if f"[{step}]" in tags]
    likely = {line.removeprefix("| likely").strip()
              for line in printed.splitlines() if line.startswith("| likely")}
    print(f"failed of step {step}: {own}\nfailed of others: {sorted(set(failed) - set(own))}")
    print("\n".join(f"| likely  {line}" for line in sorted(likely)))

    complaints = []
    if not own:
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
