"""Reads the wanted files of one submission, in a process of its own under limits.

usage: python3 -I -S -B reader SUBMISSION NAME...

SUBMISSION is a folder or an archive: zip, or tar, plain or packed by gzip, bzip2 or xz. Prints one
JSON object: for each NAME its text (base64), that it is missing, or the problem; and the notes.
"""

from __future__ import annotations

import json
import resource
import sys
import tarfile

from archives import read_submission
from finder import Finder, Problem, shown

_LIMITS = {resource.RLIMIT_AS: 1 << 30, resource.RLIMIT_CPU: 20, resource.RLIMIT_FSIZE: 0,
           resource.RLIMIT_CORE: 0, resource.RLIMIT_NOFILE: 64}


def main(path: str, names: list[str]) -> int:
    for limit, value in _LIMITS.items():
        resource.setrlimit(limit, (value, value))
    finder = Finder(names)
    try:
        read_submission(path, finder)
        answer = finder.result()
    except Problem as problem:
        answer = {"problem": str(problem)}
    except tarfile.ReadError:
        answer = {"problem": "it is neither a folder nor a zip or tar archive that can be read"}
    except MemoryError:
        answer = {"problem": "reading it takes too much memory"}
    except OSError as error:
        answer = {"problem": f"it cannot be read: {error.strerror or type(error).__name__}"}
    except Exception as error:  # broken archives fail in many ways: zlib, lzma, struct, zipfile
        answer = {"problem": f"it cannot be read: {shown(str(error) or type(error).__name__)}"}
    json.dump(answer, sys.stdout)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
