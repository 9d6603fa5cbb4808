"""Stands in for the judge: a submission says itself what it deserves, in lines such as

    // passes 1.1 1.2          every case of these steps passes, those of others are wrong
    // passes_first_seed 1.3   these steps fail under the second seed
    // says compile error | sanitizer | crash | unknown case | twice | raise | seeds
    // waits 0.5               seconds
    // runs 60                 seconds in another process
"""

import re
import subprocess
import time
from pathlib import Path
from typing import Sequence

from .verdicts import CaseOutcome, Judged

CASES = ("One", "Two & <b>three</b>")


def judge(root: Path, lab, source: bytes, work: Path, seeds: Sequence[int], sandbox,
          sanitize: bool = True) -> Judged:
    assert work.is_dir() and not list(work.iterdir()) and len(seeds) == 2 and min(seeds) > 0
    with open(root / "judged.log", "a", encoding="utf-8") as log:
        log.write(f"{lab.folder} {len(source)} {seeds}\n")
    text = source.decode("utf-8")
    words = {key: value.split() for key, value in re.findall(r"// (\w+) (.+)", text)}
    time.sleep(float(words.get("waits", ["0"])[0]))
    subprocess.run(["sleep", words.get("runs", ["0"])[0]])
    says = " ".join(words.get("says", []))
    if says == "raise":
        raise RuntimeError("the judge fell over")
    if says == "compile error":
        return Judged(False, "spin.cpp:1: error: <script>alert(1)</script>\x1b[31m", [], "", [],
                      sandbox.boxed)
    cases = [_outcome(step, case, seed, words, "NotImplemented" in text, says)
             for seed in range(2) for step in lab.steps() for case in CASES]
    if says == "unknown case":
        cases.append(cases[0]._replace(case="Injected"))
    if says == "twice":
        cases += cases[:1]
    found = "runtime error: signed integer overflow in spin.cpp:7" if says == "sanitizer" else ""
    notes = ["uses fork()"] if says == "sanitizer" else []
    return Judged(True, "", cases, found, notes, sandbox.boxed)


def _outcome(step, case, seed, words, is_stub, says) -> CaseOutcome:
    if is_stub:
        return CaseOutcome(step, case, "not written yet", f"{step} f", "", 0.1)
    right = step in words.get("passes", []) or (
        seed == 0 and step in words.get("passes_first_seed", []))
    if right:
        return CaseOutcome(step, case, "pass", "", "", 0.1)
    if says == "crash":
        return CaseOutcome(step, case, "crash with signal", "SIGSEGV secret input 3.25", "", 0.1)
    return CaseOutcome(step, case, "wrong", "got 3.25, a hidden input", "the sign of <omega>", 0.1)
