"""A class, graded: the kit proves itself first, then one submission is one job."""

from __future__ import annotations

import hashlib
import tempfile
import threading
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path
from typing import NamedTuple, Optional, Sequence

from ..console import Failure, Progress
from ..labs import Lab
from . import files, gradescope, report
from .children import end_until_done
from .intake import Submission, Taken, take
from .judge import judge
from .points import Table, expected_cases, read_table
from .sandbox import Sandbox
from .score import MISSING, REFUSED, LabResult, graded, ungraded
from .seeds import lab_seeds, mark
from .verdicts import GRADER_ERROR, NOT_WRITTEN, PASS

NOT_PROVEN = 3
"""The exit code where the grader itself is not to be trusted."""

_SELF_CHECK = "kit/self-check"
"""No student can have this name."""


class Exam(NamedTuple):
    """A lab with all that grading it takes."""

    lab: Lab
    table: Table
    expected: Sequence[tuple[str, str]]
    seeds: Sequence[int]
    key: str
    """Changes with anything that could change a result."""


class Setting(NamedTuple):
    root: Path
    out: Path
    exams: Sequence[Exam]
    sandbox: Sandbox
    resume: bool


def make_exam(root: Path, lab: Lab, secret: bytes, sandbox_mark: str) -> Exam:
    digest = hashlib.sha256(f"{mark(secret)} {sandbox_mark}".encode())
    for path in _sources(root, lab):
        content = path.read_bytes()
        digest.update(f"\n{path.relative_to(root)} {len(content)}\n".encode() + content)
    return Exam(lab, read_table(root, lab), expected_cases(root, lab), lab_seeds(secret, lab),
                digest.hexdigest())


def _sources(root: Path, lab: Lab) -> list[Path]:
    patterns = ("CMakeLists.txt", "CMakePresets.json", "common/**/*.?pp", "common/cmake/*.cmake",
                "solutions/grading/command/**/*.py", "tests/support/*.?pp",
                "solutions/grading/**/*.?pp", f"tests/{lab.name}/*.?pp",
                f"labs/{lab.folder}/{lab.name}.?pp", f"labs/{lab.folder}/README.md",
                f"solutions/{lab.folder}/*.*")
    return sorted({path for pattern in patterns for path in root.glob(pattern) if path.is_file()})


def prove(setting: Setting) -> None:
    """The reference must have every point and the untouched stub none, or nothing is graded."""
    known = files.read_record(setting.out, _SELF_CHECK) if setting.resume else {}
    for exam in setting.exams:
        lab = exam.lab
        if known.get(lab.folder, {}).get("key") == exam.key:
            continue
        reference = setting.root / "solutions" / lab.folder / lab.stub.name
        result = _judged(setting, exam, Taken(reference.read_bytes()))
        if any(step.word != PASS for step in result.steps) or result.deduction:
            raise _unproven(lab, f"the reference has {result.score} points", result)
        stub = _judged(setting, exam, Taken(lab.stub.read_bytes()))
        if any(case.word != NOT_WRITTEN for step in stub.steps for case in step.cases) or (
                stub.status != "graded" or stub.score != 0):
            raise _unproven(lab, f"the untouched stub has {stub.score} points", stub)
        known[lab.folder] = {"key": exam.key, "result": result}
        files.write_record(setting.out, _SELF_CHECK, known)


def _unproven(lab: Lab, what: str, result: LabResult) -> Failure:
    lines = [f"{result.status} {result.problem}".strip(), *result.remarks, result.diagnostics]
    lines += [f"{step.step} {case.title}: {case.word} {case.signal}".rstrip()
              for step in result.steps for case in step.cases if case.word != PASS][:20]
    return Failure(f"the grader cannot be trusted, so nobody is graded: in lab {lab.number} {what}",
                   NOT_PROVEN, "\n".join(line for line in lines if line))


def grade_class(setting: Setting, submissions: Sequence[Submission], jobs: int) -> list[str]:
    """Grades all of them and returns the names of those for which the grader failed."""
    failed = []
    stop = threading.Event()
    with Progress() as progress, ThreadPoolExecutor(jobs) as pool:
        futures = {pool.submit(_grade, setting, submission, stop): submission.student
                   for submission in submissions}
        try:
            for done, future in enumerate(as_completed(futures), 1):
                progress.show(f"graded: {done} of {len(futures)}")
                if any(result.status == GRADER_ERROR for result in future.result()):
                    failed.append(futures[future])
        except BaseException:  # an interrupt: what is not begun does not begin
            stop.set()
            pool.shutdown(wait=False, cancel_futures=True)
            end_until_done(list(futures))
            raise
    return sorted(failed)


def _grade(setting: Setting, submission: Submission, stop: threading.Event) -> list[LabResult]:
    taken = take(submission, [exam.lab.stub.name for exam in setting.exams])
    record = files.read_record(setting.out, submission.student)
    for exam in setting.exams:
        if stop.is_set():
            return []
        file = taken[exam.lab.stub.name]
        key = _key(exam, file)
        old = record.get(exam.lab.folder)
        if setting.resume and old and old["key"] == key and old["result"].status != GRADER_ERROR:
            continue
        result = _judged(setting, exam, file)
        if stop.is_set():  # cut short, so it tells nothing
            return []
        record[exam.lab.folder] = {"key": key, "result": result}
    results = [record[exam.lab.folder]["result"] for exam in setting.exams]
    write_results(setting.out, submission.student, results)
    files.write_record(setting.out, submission.student, record)
    return results


def write_results(out: Path, student: str, results: Sequence[LabResult]) -> None:
    folder = out / student
    files.write(folder / "results.json", files.json_text(gradescope.results(results)))
    files.write(folder / "index.html", report.student_page(student, results))


def _key(exam: Exam, file: Taken) -> str:
    handed_in = repr((file.text, file.problem, list(file.notes)))
    return hashlib.sha256(f"{exam.key} {handed_in}".encode()).hexdigest()


def _judged(setting: Setting, exam: Exam, file: Taken) -> LabResult:
    if file.text is None:
        status = MISSING if file.missing else REFUSED
        return ungraded(exam.lab, exam.table, status, file.problem, file.notes)
    error: Optional[Exception] = None
    try:
        with tempfile.TemporaryDirectory(prefix="tumble-grade-") as work:
            judged = judge(setting.root, exam.lab, file.text, Path(work), exam.seeds,
                           setting.sandbox)
        return graded(exam.lab, exam.table, exam.expected, judged, len(exam.seeds), file.notes)
    except Failure as failure:
        if failure.code == NOT_PROVEN:  # the sandbox is gone: nothing is to be trusted
            raise
        error = failure
    except Exception as failure:  # one submission must not end the class
        error = failure
    return ungraded(exam.lab, exam.table, GRADER_ERROR,
                    "the grader failed on this file; this is not your mistake", file.notes,
                    [f"{type(error).__name__}: {error}"])
