"""From a student's file to the program that answers for it, compiled and linked in the box."""

from __future__ import annotations

import json
import os
import shutil
import stat
import subprocess
import threading
from pathlib import Path
from typing import NamedTuple, Sequence

from .. import build
from ..console import Failure
from ..labs import Lab
from .sandbox import Sandbox

PRESET = "grade"
DIAGNOSTICS_LIMIT = 4096

_SECONDS = 900
"""Of waiting. The compiler's own computing is limited; more is a machine that is too busy."""
_LARGEST_PROGRAM = 64 << 20
_PLAIN = ("-O1", "-g1", "-D_GLIBCXX_ASSERTIONS")
_SANITIZED = (*_PLAIN, "-fsanitize=address,undefined", "-fno-sanitize-recover=all",
              "-fno-omit-frame-pointer")
_ERRORS = ("-fmax-errors=20", "-fdiagnostics-color=never", "-fno-diagnostics-show-caret")

_building = threading.Lock()
_built: dict[tuple[Path, str], "Tools"] = {}


class Tools(NamedTuple):
    """What CMake built for a lab, and how it would compile a student's file."""

    compiler: Path
    test: Path
    strict: Sequence[str]
    """Arguments of the test program that make a name which fits no case a failure."""
    driver: Path
    library: Path
    eigen: Path
    options: Sequence[str]


class Compiled(NamedTuple):
    """ok: the program is there; diagnostics: what the compiler said, warnings too."""

    ok: bool
    diagnostics: str


def tools(root: Path, lab: Lab) -> Tools:
    """Built once in the life of this process: sources that change meanwhile change no marks."""
    with _building:
        key = (root, lab.name)
        if key not in _built:
            build.require(root, PRESET, [f"{lab.name}_judge_test", f"{lab.name}_driver"])
            _built[key] = _read(build.build_folder(root, PRESET) / "judges" / f"{lab.name}.json")
        return _built[key]


def _read(file: Path) -> Tools:
    try:
        facts = json.loads(file.read_text(encoding="utf-8"))
        compiler = Path(facts["compiler"]).resolve()
        if "ccache" in compiler.name:
            raise Failure(f"{facts['compiler']} is ccache, which lets one student's file change "
                          "the result of another: set CXX to a compiler")
        return Tools(compiler, Path(facts["test"]), _words(facts["strict"]), Path(facts["driver"]),
                     Path(facts["library"]), Path(facts["eigen"]), _words(facts["options"]))
    except (OSError, ValueError, KeyError) as error:
        raise Failure(f"{file} cannot be read: {error}") from error


def _words(joined: str) -> list[str]:
    return [word for word in joined.split(";") if word]


def prepare_kit(root: Path, lab: Lab, source: bytes, tools_: Tools, kit: Path) -> None:
    """All that the compiler sees: the file, what its author was given, what it is linked with."""
    for header in sorted((root / "common").rglob("*.hpp")):
        copy = kit / header.relative_to(root)
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(header, copy)
    shutil.copyfile(lab.path / f"{lab.name}.hpp", kit / f"{lab.name}.hpp")
    shutil.copyfile(tools_.driver, kit / "driver.o")
    shutil.copyfile(tools_.library, kit / "libcommon.a")
    (kit / lab.stub.name).write_bytes(source)
    for path in [kit, *kit.rglob("*")]:
        path.chmod(0o755 if path.is_dir() else 0o644)


def compile_driver(lab: Lab, tools_: Tools, kit: Path, program: Path, sandbox: Sandbox,
                   sanitized: bool) -> Compiled:
    """Makes `program`; the box writes to a folder beside it."""
    out = program.with_name(f"{program.name}-out")
    out.mkdir(mode=0o755)
    sandbox.give(out)
    command = [str(tools_.compiler), *tools_.options, *(_SANITIZED if sanitized else _PLAIN),
               *_ERRORS, "-I.", "-isystem", str(tools_.eigen), lab.stub.name, "driver.o",
               "libcommon.a", "-o", "/out/program"]
    log = program.with_name(f"{program.name}.log")
    code = _run(sandbox.compile_command(kit, out, command), log)
    said = _diagnostics(log)
    if code is None:
        raise Failure(f"the compiler did not end within {_SECONDS} s: is this machine too busy?")
    if code != 0 or not _take(out / "program", program):
        return Compiled(False, said or "the compiler was stopped: too much time, memory or output")
    return Compiled(True, said)


def _run(command: Sequence[str], log: Path) -> int | None:
    """The exit code; None where it took too long. The box ends with its first process."""
    with open(log, "wb") as record:
        try:
            return subprocess.run(command, stdin=subprocess.DEVNULL, stdout=record,
                                  stderr=subprocess.STDOUT, timeout=_SECONDS).returncode
        except subprocess.TimeoutExpired:
            return None


def _diagnostics(log: Path) -> str:
    with open(log, "rb") as record:
        text = record.read(DIAGNOSTICS_LIMIT + 1)
    said = text[:DIAGNOSTICS_LIMIT].decode("utf-8", errors="replace").strip()
    return said + ("\n... and more" if len(text) > DIAGNOSTICS_LIMIT else "")


def _take(made: Path, program: Path) -> bool:
    """Copies what the box wrote, if it is a plain file of sound size."""
    try:
        descriptor = os.open(made, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    except OSError:
        return False
    with open(descriptor, "rb") as content:
        facts = os.fstat(content.fileno())
        if not stat.S_ISREG(facts.st_mode) or facts.st_size > _LARGEST_PROGRAM:
            return False
        program.write_bytes(content.read(_LARGEST_PROGRAM))
    program.chmod(0o755)
    return True
