"""One student's file of one lab, judged: everything between the file and a list of outcomes."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path
from typing import Optional, Sequence

from ..console import Failure
from ..labs import Lab
from .cases import Run, report_of_sanitizers, run_cases
from .compiling import Tools, compile_driver, prepare_kit, tools
from .points import expected_cases
from .sandbox import Sandbox
from .verdicts import (CRASH, FLOOD, GRADER_ERROR, NOT_WRITTEN, OUT_OF_MEMORY, PASS, TIME_OUT,
                       CaseOutcome, Judged)

_UNSANITIZED = {TIME_OUT, NOT_WRITTEN, OUT_OF_MEMORY, FLOOD, GRADER_ERROR}
"""Cases that the sanitizers have nothing to say of."""

_ADVICE = (
    ("inline assembly", re.compile(rb"\b(?:asm|__asm|__asm__)\b")),
    ("the sanitizers' switches", re.compile(
        rb"no_sanitize|__SANITIZE|__has_feature|__(?:asan|ubsan|lsan|sanitizer)_")),
    ("processes, signals or files", re.compile(
        rb"\b(?:fork|vfork|clone|exec[lv]p?e?|kill|ptrace|signal|sigaction|mmap|mprotect|dlopen|"
        rb"open|socket|syscall|_exit|_Exit|quick_exit|atexit|system|popen)\s*\(")),
    ("system headers", re.compile(rb"#\s*include\s*<(?:sys|linux|asm|arpa|netinet)/|"
                                         rb"#\s*include\s*<(?:unistd|fcntl|dlfcn|csignal)")),
    ("the names of the grader", re.compile(rb"\bgrading\b|TUMBLE_|Catch(?:::|2)|/driver")),
)


def judge(root: Path, lab: Lab, source: bytes, work: Path, seeds: Sequence[int], sandbox: Sandbox,
          sanitize: bool = True, steps: Optional[Sequence[str]] = None) -> Judged:
    """Judges `source` in the empty folder `work`. A case passes where it does under all seeds.

    steps  where given, the cases of these alone
    Throws Failure where the kit itself is at fault.
    """
    built = tools(root, lab)
    expected = expected_cases(root, lab)
    _require_cases(built, expected)
    expected = [case for case in expected if steps is None or case[0] in steps]
    work.chmod(0o711)  # the box's user goes through, and lists nothing
    kit = work / "kit"
    kit.mkdir()
    prepare_kit(root, lab, source, built, kit)
    notes = advice(source)
    plain = compile_driver(lab, built, kit, work / "driver", sandbox, False)
    if not plain.ok:
        return Judged(False, plain.diagnostics, [], "", notes, sandbox.boxed)
    worker = _command_file(work, "driver", sandbox, False)
    cases = _judge_seeds(built, worker, work, seeds, sandbox.boxed, expected)
    report = ""
    if sanitize:
        report = _sanitize(lab, built, work, seeds[0], sandbox, cases, notes)
    return Judged(True, plain.diagnostics, cases, report, notes, sandbox.boxed)


def _require_cases(built: Tools, expected: Sequence[tuple[str, str]]) -> None:
    """The tests in the program are those in the sources: none missing, none more, none twice."""
    names_only = (["--list-test-names-only"] if built.strict  # Catch2 2
                  else ["--list-tests", "--verbosity", "quiet"])
    listed = subprocess.run([built.test, *names_only], text=True, errors="replace",
                            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE).stdout
    titles = sorted(line.strip() for line in listed.splitlines() if line.strip())
    wanted = sorted(title for _, title in expected)
    if titles != wanted or len(set(wanted)) != len(wanted):
        odd = set(titles) ^ set(wanted) or {"a title twice"}
        raise Failure(f"the test program and its sources have different cases: {sorted(odd)[:3]}")


def _command_file(work: Path, name: str, sandbox: Sandbox, sanitized: bool) -> Path:
    file = work / f"{name}.command"
    file.write_text("\n".join(sandbox.worker_command(work / name, sanitized)) + "\n",
                    encoding="utf-8")
    return file


def _judge_seeds(built: Tools, worker: Path, work: Path, seeds: Sequence[int], boxed: bool,
                 expected: Sequence[tuple[str, str]]) -> list[CaseOutcome]:
    """Each seed is asked of what has passed so far."""
    outcomes: dict[tuple[str, str], CaseOutcome] = {}
    for index, seed in enumerate(seeds):
        left = [case for case in expected if index == 0 or outcomes[case].word == PASS]
        run = Run(built, worker, boxed, seed, work / f"seed-{index}")
        for case, found in zip(left, run_cases(run, left)):
            outcomes[case] = found
    return [outcomes[case] for case in expected]


def _sanitize(lab: Lab, built: Tools, work: Path, seed: int, sandbox: Sandbox,
              cases: Sequence[CaseOutcome], notes: list[str]) -> str:
    """What the sanitizers found, or nothing."""
    chosen = [case for case in cases if case.word not in _UNSANITIZED]
    if not chosen:
        return ""
    compiled = compile_driver(lab, built, work / "kit", work / "sanitized", sandbox, True)
    if not compiled.ok:
        notes.append("the sanitizers could not run: the file does not compile with them")
        return ""
    run = Run(built, _command_file(work, "sanitized", sandbox, True), sandbox.boxed, seed,
              work / "sanitized-run", keeps_words=True)
    outcomes = run_cases(run, [(case.step, case.case) for case in chosen])
    report = report_of_sanitizers(run, len(chosen))
    for before, after in zip(chosen, outcomes):
        if not report and before.word == PASS and after.word == CRASH:
            report = f"undefined behaviour: '{before.case}' passes, but crashes with sanitizers"
    return report


def advice(source: bytes) -> list[str]:
    """What a human should look at. No mark depends on it."""
    notes = []
    for what, pattern in _ADVICE:
        found = pattern.search(source)
        if found:
            line = source.count(b"\n", 0, found.start()) + 1
            notes.append(f"line {line} uses {what}")
    return notes
