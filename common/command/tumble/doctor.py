"""./tumble doctor: what is installed, what for, which GL draws, what to do about the rest."""

from __future__ import annotations

import argparse
import subprocess
from pathlib import Path
from typing import Sequence

from . import build
from .console import FAILED, Failure, Progress, coloured, mark, require_writable, say
from .labs import is_handout
from .machine import Finding, examine

FRAME_PROGRAM = "render_doctor"
RENDERER = "render/librender_scene.a"


def run(root: Path, _options: argparse.Namespace) -> int:
    with Progress() as progress:
        progress.show("examining this machine")
        findings = examine()
    say(*report(findings), "")
    missing = [finding for finding in findings if not finding.usable]
    ready = not any(finding.needed for finding in missing)
    try:
        require_writable(root / "build")
    except Failure as failure:
        say(*advice(missing), f"Nothing can be built here: {failure.args[0]}. "
            "Copy the kit to a folder of your own.")
        return FAILED
    if ready:
        say(*test_frame(root, findings), "")
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


def test_frame(root: Path, findings: Sequence[Finding]) -> list[str]:
    """One frame shows more than any version number, where what draws it is built: to build that
    takes too long for a question. Without a frame, all but the pictures works."""
    usable = {finding.name for finding in findings if finding.usable}
    if "OpenGL" not in usable or not usable & {"OSMesa", "EGL"}:
        return ["Pictures: none, because there is no off-screen GL. Labs and tests work."]
    if not (build.build_folder(root, "release") / RENDERER).exists():
        solution = "" if is_handout(root) else " --solution"
        return [f"Pictures: not tried yet. ./tumble frames 1{solution} builds the renderer;",
                "after that ./tumble doctor draws a test frame."]
    try:
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
    needed = any(finding.needed for finding in missing)
    lines = ["Labs cannot be built yet." if needed else "Labs can be built: ./tumble test 1"]
    for finding in missing:
        if finding.version:
            lines.append(f"{finding.name} {finding.version} is too old: {finding.newer}")
    absent = [finding for finding in missing if not finding.version]
    for command, what in (("demo", "what is missing"), ("verify", "what ./tumble verify needs")):
        packages = " ".join(finding.package for finding in absent if finding.command == command)
        if packages:
            lines += [f"To install {what}: ./tumble {command}, or by hand",
                      f"  sudo apt-get install --no-install-recommends {packages}"]
    return lines
