"""Records of a student's cases, as tests/support/run_each.cpp writes them."""

from pathlib import Path

HERE = Path(__file__).resolve().parent
RECORDS = (HERE / "student_records.txt").read_bytes()
NAMES = (HERE / "student_cases.txt").read_text(encoding="utf-8")


def record(line: int, output: str, end: str = "exit 1") -> bytes:
    return f"case {line} {end} 0.01 {len(output)}\n{output}\n".encode()


PASSED = "All tests passed (3 assertions in 1 test case)\n"
