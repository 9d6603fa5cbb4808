"""The seeds of the hidden inputs: two a lab, made from a secret of the course."""

from __future__ import annotations

import hashlib
import hmac
import os
import secrets
from pathlib import Path
from typing import Mapping, Optional

from ..console import BAD_USAGE, Failure
from ..labs import Lab

SEEDS = 2
VARIABLE = "TUMBLE_SECRET"
OWN_SECRET = "secret"
"""File in the output folder; whoever reads it can compute the hidden inputs."""

_SHORTEST = 16


def course_secret(file: Optional[str], out: Path, environment: Mapping[str, str]) -> bytes:
    """From the file that is named, or else one of this output folder, made once and kept: grading
    again gives the same points."""
    name = file if file is not None else environment.get(VARIABLE, "")
    if name:
        return _read(Path(name), BAD_USAGE)
    own = out / OWN_SECRET
    if not own.exists():
        _make(own)
    return _read(own)


def is_given(file: Optional[str], environment: Mapping[str, str]) -> bool:
    return file is not None or bool(environment.get(VARIABLE))


def lab_seeds(secret: bytes, lab: Lab) -> list[int]:
    """In [1, 2^63): no seed is 0, which is what students test with."""
    digests = (_digest(secret, f"seed {number} of {lab.folder}") for number in range(SEEDS))
    return [int.from_bytes(digest[:8], "big") >> 1 or 1 for digest in digests]


def mark(secret: bytes) -> str:
    """Tells secrets apart and gives nothing away."""
    return _digest(secret, "mark").hex()[:16]


def _digest(secret: bytes, words: str) -> bytes:
    return hmac.new(secret, words.encode("utf-8"), hashlib.sha256).digest()


def _read(path: Path, code: int = 1) -> bytes:
    try:
        secret = path.read_bytes().strip()
    except OSError as error:
        raise Failure(f"the secret {path} cannot be read: {error.strerror}", code) from error
    if len(secret) < _SHORTEST:
        raise Failure(f"the secret in {path} is shorter than {_SHORTEST} bytes; to make one: "
                      f"openssl rand -hex 32 > {path}", code)
    return secret


def _make(path: Path) -> None:
    """Of several shards that make one at the same time, the first one's counts."""
    draft = path.with_name(f".{path.name}.{secrets.token_hex(8)}")
    handle = os.open(draft, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    with os.fdopen(handle, "w", encoding="ascii") as stream:
        stream.write(secrets.token_hex(32) + "\n")
    try:
        os.link(draft, path)
    except FileExistsError:
        pass
    finally:
        draft.unlink()
