"""./tumble handout FILE.tar.gz: what students get, packed. The same kit gives the same bytes."""

from __future__ import annotations

import argparse
import gzip
import io
import os
import re
import shutil
import subprocess
import tarfile
from pathlib import Path
from typing import Iterator, Mapping, Optional

from .console import BAD_USAGE, Failure, say
from .labs import Lab, find_labs

FOLDER = "tumble"

_SUFFIX = ".tar.gz"
_KINDS = {".hpp", ".cpp", ".py", ".html", ".md", ".cmake", ".txt", ".json", ".gp", ".png", ".svg"}
_TOP = ("CMakeLists.txt", "CMakePresets.json", "LICENSE", "tumble", ".clang-format", ".clangd")
_WHOLE = ("common", "render", "labs", "tests/support")
# The overview for students stands in for the one that tells of solutions and grading.
_OVERVIEW = "labs/README.md"
_TIME = 946684800
"""2000-01-01: no file may tell when it was packed."""

_COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
_EMPTY = re.compile(r'throw common::NotImplemented\("[\d.]+ \w+"\);|^\s*(#include|using) [^\n]*$',
                    re.MULTILINE)


def run(root: Path, options: argparse.Namespace) -> int:
    target = Path(options.file)
    if not target.name.endswith(_SUFFIX) or target.name == _SUFFIX:
        raise Failure(f"'{target.name}' does not end in {_SUFFIX}: add that", BAD_USAGE)
    labs = find_labs(root)
    for lab in labs:
        _require_stub(lab)
    tracked = _tracked(root)
    files = sorted(_files(root, labs))
    left_out = [name for name in files if tracked is not None and name not in tracked]
    content = packed(root, [name for name in files if name not in left_out],
                     {_OVERVIEW: "README.md"})
    replace(target, content)
    if left_out:
        say(f"Left out, because git does not track it: {', '.join(left_out)}")
    say(f"{target}: {len(files) - len(left_out)} files, {len(content) / 1e6:.1f} MB, "
        f"{len(labs)} labs, no solutions. To try it: tar xf {target.name} && cd {FOLDER} && "
        "./tumble test 1")
    return 0


def _files(root: Path, labs: list[Lab]) -> Iterator[str]:
    """Names of what a student's test, frames, chart, hint, watch and doctor need."""
    for name in (*_TOP, "tests/CMakeLists.txt"):
        if (root / name).is_file():
            yield name
    for folder in (*_WHOLE, *(f"tests/{lab.name}" for lab in labs)):
        for path in (root / folder).rglob("*"):
            name = path.relative_to(root).as_posix()
            hidden = any(part.startswith((".", "__")) for part in Path(name).parts[:-1])
            good_name = path.suffix in _KINDS and not path.name.startswith(".")
            if (good_name and not hidden and path.is_file()
                    and not path.is_symlink()):
                yield name


def _tracked(root: Path) -> Optional[set[str]]:
    """What belongs to the kit where git knows it; a lecturer's notes beside it do not."""
    if not (root / ".git").exists() or not shutil.which("git"):
        return None
    done = subprocess.run(["git", "ls-files", "-z"], cwd=root, capture_output=True)
    names = done.stdout.decode("utf-8", "surrogateescape").split("\0")
    return set(names) if done.returncode == 0 else None


def _require_stub(lab: Lab) -> None:
    """A stub does nothing but throw: whoever tried out an answer in place must not hand it out."""
    text = _EMPTY.sub("", _COMMENT.sub("", lab.stub.read_text(encoding="utf-8")))
    if ";" in text:
        rest = next(line.strip() for line in text.splitlines() if ";" in line)
        raise Failure(f"labs/{lab.folder}/{lab.stub.name} is not the untouched stub: it contains "
                      f"'{rest[:60]}'; restore the stub first")


def whole_kit(root: Path) -> list[str]:
    """Names of all that belongs to the kit, for a machine that grades."""
    tracked = _tracked(root)
    names = (path.relative_to(root).as_posix() for path in root.rglob("*")
             if path.is_file() and not path.is_symlink())
    return sorted(name for name in names if name in tracked) if tracked is not None else sorted(
        name for name in names if not re.match(r"(build|out|\.git)/|.*__pycache__", name))


def packed(root: Path, names: list[str], renamed: Optional[Mapping[str, str]] = None) -> bytes:
    archive_bytes = io.BytesIO()
    with gzip.GzipFile("", "wb", 9, archive_bytes, mtime=0) as stream, tarfile.open(
            fileobj=stream, mode="w", format=tarfile.USTAR_FORMAT) as archive:
        for name in names:
            runs = os.access(root / name, os.X_OK)
            _add(archive, (renamed or {}).get(name, name), (root / name).read_bytes(), runs)
    return archive_bytes.getvalue()


def _add(archive: tarfile.TarFile, name: str, content: bytes, runs: bool) -> None:
    member = tarfile.TarInfo(f"{FOLDER}/{name}")
    member.size = len(content)
    member.mtime = _TIME
    member.mode = 0o755 if runs else 0o644
    archive.addfile(member, io.BytesIO(content))


def replace(target: Path, content: bytes) -> None:
    """In one move, so that nobody can hand out half of it."""
    draft = target.with_name(f".{target.name}.draft")
    try:
        draft.write_bytes(content)
        os.replace(draft, target)
    except OSError as error:
        draft.unlink(missing_ok=True)
        raise Failure(f"cannot write {target}: {error.strerror}") from error
