"""./tumble doctor: what is installed, what for, which GL draws, what to do about the rest."""

from __future__ import annotations

import argparse
import subprocess
from pathlib import Path
from typing import Sequence

from . import build
from .console import FAILED, Failure, Progress, coloured, mark, say
from .machine import Finding, examine

FRAME_PROGRAM = "render_doctor"


def run(root: Path, _options: argparse.Namespace) -> int:
    with Progress() as progress:
        progress.show("looking at this machine")
        findings = examine()
    say(*report(findings), "")
    missing = [finding for finding in findings if not finding.usable]
    ready = not any(finding.needed for finding in missing)
    if ready:
        say(*_test_frame(root), "")
    say(*advice(missing))
    return 0 if ready else FAILED


def report(findings: Sequence[Finding]) -> list[str]:
    name_width = max(len(finding.name) for finding in findings)
    state_width = max(len(_state(finding)) for finding in findings)
    return [f"  {_sign(finding)} {finding.name:<{name_width}}  {_state(finding):<{state_width}}  "
            f"{finding.purpose}" for finding in findings]


def _sign(finding: Finding) -> str:
    if finding.usable:
        return coloured(mark("done"), "green")
    return coloured(mark("wrong"), "red") if finding.needed else coloured(mark("open"), "yellow")


def _state(finding: Finding) -> str:
    if finding.usable:
        return finding.version
    return f"{finding.version}, too old" if finding.version else "missing"


def _test_frame(root: Path) -> list[str]:
    """One frame shows more than any version number. Without one, all but the pictures works."""
    try:
        if FRAME_PROGRAM not in build.targets(root, "release"):
            return ["Pictures: none, this build found no off-screen GL. Labs and tests work."]
        build.require(root, "release", [FRAME_PROGRAM])
    except Failure as failure:
        return [str(failure)]
    picture = root / "build" / "doctor.png"
    program = build.build_folder(root, "release") / "render" / FRAME_PROGRAM
    done = subprocess.run([program, "--out", picture], text=True, errors="replace",
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    said = done.stdout.strip() or f"exit code {done.returncode}"
    if done.returncode != 0:
        return [f"Pictures: none. Labs and tests work. {said}"]
    return [f"Pictures: {said}", f"A test frame: {picture}"]


def advice(missing: Sequence[Finding]) -> list[str]:
    if not missing:
        return [coloured("Nothing is missing.", "green") + " Begin with ./tumble test 1"]
    packages = " ".join(finding.package for finding in missing)
    needed = any(finding.needed for finding in missing)
    return ["Labs cannot be built yet." if needed else "Labs can be built: ./tumble test 1",
            "To get what is missing: ./tumble demo, or by hand",
            f"  sudo apt-get install {packages}"]
