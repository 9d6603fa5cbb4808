"""Packs the zip that Gradescope wants as an autograder.

usage: python3 solutions/grading/gradescope/pack.py FILE.zip --labs N[,N] --secret FILE
                                                    [--no-sandbox]

FILE.zip holds setup.sh, run_autograder, the whole kit with its solutions, and the secret: keep it
from students. --no-sandbox is for where containers may make no namespaces; results then say so.
"""

from __future__ import annotations

import argparse
import io
import re
import sys
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(ROOT / "common" / "command"))

from tumble.console import BAD_USAGE, Failure  # noqa: E402 (found by the line above)
from tumble.grading.points import graded_labs  # noqa: E402
from tumble.handout import packed, replace, whole_kit  # noqa: E402

_EARLIEST = (1980, 1, 1, 0, 0, 0)
"""The earliest time that a zip can hold."""


def main() -> int:
    parser = argparse.ArgumentParser(allow_abbrev=False)
    parser.add_argument("file", type=Path)
    parser.add_argument("--labs", required=True)
    parser.add_argument("--secret", required=True, type=Path)
    parser.add_argument("--no-sandbox", action="store_true")
    arguments = parser.parse_args()
    try:
        _pack(arguments)
    except (Failure, OSError) as failure:
        print(failure if isinstance(failure, Failure) else f"tumble: {failure}", file=sys.stderr)
        return failure.code if isinstance(failure, Failure) else 1
    return 0


def _pack(arguments: argparse.Namespace) -> None:
    known = {str(lab.number) for lab in graded_labs(ROOT)}
    if not set(arguments.labs.split(",")) <= known:
        raise Failure(f"--labs {arguments.labs}: give some of {', '.join(sorted(known))}",
                      BAD_USAGE)
    if not re.search(r"\S{16}", arguments.secret.read_text(encoding="ascii", errors="replace")):
        raise Failure(f"the secret in {arguments.secret} is shorter than 16 bytes", BAD_USAGE)
    options = ["--labs", arguments.labs] + (["--no-sandbox"] if arguments.no_sandbox else [])
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in ("setup.sh", "run_autograder"):
            _add(archive, name, (HERE / name).read_bytes(), 0o755)
        _add(archive, "options.sh", f"options=({' '.join(options)})\n".encode("ascii"), 0o644)
        _add(archive, "secret", arguments.secret.read_bytes(), 0o600)
        _add(archive, "kit.tar.gz", packed(ROOT, whole_kit(ROOT)), 0o600)
    replace(arguments.file, content.getvalue())
    print(f"{arguments.file}: {len(content.getvalue()) / 1e6:.1f} MB")


def _add(archive: zipfile.ZipFile, name: str, text: bytes, mode: int) -> None:
    member = zipfile.ZipInfo(name, _EARLIEST)
    member.compress_type = zipfile.ZIP_DEFLATED
    member.external_attr = (0o100000 | mode) << 16
    archive.writestr(member, text)


if __name__ == "__main__":
    sys.exit(main())
