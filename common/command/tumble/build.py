"""Configures and builds with CMake's presets, and shows of its output only what counts."""

from __future__ import annotations

import contextlib
import fcntl
import os
import re
import shutil
import subprocess
import sys
import threading
from pathlib import Path
from typing import IO, Iterator, NamedTuple, Sequence

from .console import Failure, Progress, require_writable, shortened

DIAGNOSTICS_LIMIT = 4096

_STEP = re.compile(r"\[(\d+)/(\d+)\] ")
_NO_TARGET = re.compile(r"ninja: error: unknown target '([^']+)'")


_locks_here = threading.RLock()
_held: set[Path] = set()


@contextlib.contextmanager
def locked(root: Path, preset: str) -> Iterator[None]:
    """Keeps other commands out of build/<preset> meanwhile; they say that they wait, and go on.

    This process may ask again for a folder that it has; its threads take turns.
    """
    folder = build_folder(root, preset)
    with _locks_here:
        if folder in _held:
            yield
            return
        require_writable(folder.parent)
        with open(folder.with_name(f"{preset}.lock"), "a+", encoding="utf-8") as lock:
            _wait_for(lock, preset)
            _held.add(folder)
            try:
                yield
            finally:
                _held.remove(folder)


def _wait_for(lock: IO[str], preset: str) -> None:
    """The lock ends with its file, so a command that is killed leaves none behind."""
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        lock.seek(0)
        holder = lock.read().strip() or "another command"
        print(f"tumble: waiting for {holder}, which uses build/{preset}", file=sys.stderr)
        fcntl.flock(lock, fcntl.LOCK_EX)
    lock.truncate(0)
    lock.write(f"./tumble {' '.join(sys.argv[1:])} (process {os.getpid()})\n")
    lock.flush()


class Built(NamedTuple):
    """What the build tool said of the kit's programs."""

    ok: bool
    diagnostics: str


def build_folder(root: Path, preset: str) -> Path:
    return root / "build" / preset


def configure(root: Path, preset: str, again: bool = False) -> None:
    """Runs CMake where it has not run yet, or again; else ninja runs it again when it must."""
    folder = build_folder(root, preset)
    is_configured = (folder / "build.ninja").exists() and _configured_for(folder) == str(root)
    if is_configured and not again:
        return
    for tool, package in (("cmake", "cmake"), ("ninja", "ninja-build")):
        if not shutil.which(tool):
            raise Failure(f"{tool} is missing: install {package}, or let ./tumble demo do it "
                          "(./tumble doctor says what else is needed)")
    require_writable(folder)
    # A fresh start would also make the precompiled headers anew, and all that is built with them.
    start = [] if is_configured else ["--fresh"]
    with Progress() as progress:
        progress.show(f"configuring build/{preset}")
        done = subprocess.run(
            ["cmake", "--preset", preset, *start], cwd=root, text=True, errors="replace",
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode != 0:
        raise Failure(f"CMake cannot configure build/{preset}; type ./tumble doctor",
                      details=shortened(_cmake_errors(done.stdout), DIAGNOSTICS_LIMIT))


def build(root: Path, preset: str, targets: Sequence[str] = ()) -> Built:
    """Configures if needed and builds; the diagnostics hold warnings, too."""
    with locked(root, preset):
        configure(root, preset)
        return _run_ninja(root, preset, targets)


def _run_ninja(root: Path, preset: str, targets: Sequence[str]) -> Built:
    command = ["ninja", "-C", str(build_folder(root, preset)), *targets]
    environment = dict(os.environ, NINJA_STATUS="[%f/%t] ")
    lines = []
    with Progress() as progress, subprocess.Popen(
            command, text=True, errors="replace", env=environment, stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as process:
        for line in process.stdout or ():
            lines.append(line.rstrip("\n"))
            step = _STEP.match(line)
            if step:
                progress.show(f"building: {step.group(1)} of {step.group(2)}")
    output = "\n".join(lines)
    (build_folder(root, preset) / "build.log").write_text(output + "\n", encoding="utf-8",
                                                          errors="replace")
    return Built(process.returncode == 0, diagnostics(lines, root))


def targets(root: Path, preset: str) -> set[str]:
    """What this machine can build: scenes, for one, need off-screen GL."""
    with locked(root, preset):
        configure(root, preset)
    listing = subprocess.run(
        ["cmake", "--build", str(build_folder(root, preset)), "--target", "help"],
        text=True, errors="replace", stdout=subprocess.PIPE).stdout
    return {line.split(":", 1)[0] for line in listing.splitlines()}


def require(root: Path, preset: str, targets: Sequence[str] = ()) -> None:
    """Builds or ends the command with the compiler's words."""
    built = build(root, preset, targets)
    if built.ok:
        return
    unknown = _NO_TARGET.search(built.diagnostics)
    if unknown:
        raise Failure(f"there is no program {unknown.group(1)} in build/{preset}: this version or "
                      "this machine cannot build it; ./tumble doctor lists what is missing")
    raise Failure(f"the build of build/{preset} failed (whole log: build/{preset}/build.log)",
                  details=shortened(built.diagnostics, DIAGNOSTICS_LIMIT))


def diagnostics(lines: Sequence[str], root: Path) -> str:
    """Without ninja's own lines and the command lines; paths as they are seen from the root."""
    kept = []
    command_follows = False
    for line in lines:
        if command_follows:
            command_follows = False
        elif line.startswith("FAILED: "):
            command_follows = True
        elif not (_STEP.match(line) or line.startswith(("ninja: build stopped", "ninja: Entering",
                                                        "ninja: no work", "-- "))):
            kept.append(line.replace(f"{root}/", ""))
    return "\n".join(kept).strip()


def _cmake_errors(output: str) -> str:
    start = output.find("CMake Error")
    return output[max(start, 0):]


def _configured_for(folder: Path) -> str:
    """The source folder of the last configuration; another one means that the kit was moved."""
    try:
        with open(folder / "CMakeCache.txt", encoding="utf-8", errors="replace") as cache:
            for line in cache:
                if line.startswith("CMAKE_HOME_DIRECTORY:INTERNAL="):
                    return line.split("=", 1)[1].rstrip("\n")
    except OSError:
        pass
    return ""
