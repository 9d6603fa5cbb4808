"""Writes archives and folders that a grader must survive; see evil_submissions.py."""

from __future__ import annotations

import gzip
import io
import lzma
import os
import struct
import tarfile
import zipfile
from pathlib import Path
from typing import Callable

NAME = "spin.cpp"
GOOD = b"// passes 1.1\n"

Tar = list[tuple[tarfile.TarInfo, bytes]]


def tar_member(name: str, content: bytes = GOOD, kind: bytes = tarfile.REGTYPE,
               link: str = "") -> tuple[tarfile.TarInfo, bytes]:
    member = tarfile.TarInfo(name)
    member.type = kind
    member.linkname = link
    member.size = len(content) if kind == tarfile.REGTYPE else 0
    return member, content


def write_tar(path: Path, members: Tar, mode: str = "w:gz") -> None:
    with tarfile.open(path, mode) as archive:
        for member, content in members:
            archive.addfile(member, io.BytesIO(content))


def write_zip(path: Path, members: list[tuple[str, bytes]], kind: int = 0,
              method: int = zipfile.ZIP_DEFLATED) -> None:
    with zipfile.ZipFile(path, "w", method) as archive:
        for name, content in members:
            entry = zipfile.ZipInfo(name)
            entry.external_attr = kind << 16
            entry.compress_type = method
            archive.writestr(entry, content)


def zip_with_flag(path: Path, bits: int) -> None:
    """As an encrypted member looks."""
    write_zip(path, [(NAME, GOOD)])
    data = bytearray(path.read_bytes())
    for signature, offset in ((b"PK\1\2", 8), (b"PK\3\4", 6)):
        data[data.index(signature) + offset] |= bits
    path.write_bytes(data)


def lying_zip(path: Path, size: int) -> None:
    """The directory says that the file is small; its data go on."""
    write_zip(path, [(NAME, b"x" * (5 << 20))])
    data = bytearray(path.read_bytes())
    start = data.index(b"PK\1\2")
    struct.pack_into("<L", data, start + 24, size)
    path.write_bytes(data)


def bomb_zip(path: Path, wanted: bool) -> None:
    """300 MB of zeros in little more than 1 MB."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
        with archive.open(NAME if wanted else "zeros.bin", "w") as stream:
            for _ in range(300):
                stream.write(bytes(1 << 20))
        if not wanted:
            archive.writestr(NAME, GOOD)


def bomb_tar(path: Path, wanted: bool, megabytes: int = 300) -> None:
    member = tarfile.TarInfo(NAME if wanted else "zeros.bin")
    member.size = megabytes << 20
    with gzip.open(path, "wb", compresslevel=1) as stream:
        stream.write(member.tobuf())
        for _ in range(megabytes):
            stream.write(bytes(1 << 20))


def huge_header(path: Path) -> None:
    """A member whose extended header claims two gigabytes."""
    member = tarfile.TarInfo("pax")
    member.type = tarfile.XHDTYPE
    member.size = 2 << 30
    with gzip.open(path, "wb", compresslevel=1) as stream:
        stream.write(member.tobuf())
        for _ in range(300):
            stream.write(bytes(1 << 20))


def many(path: Path) -> None:
    with zipfile.ZipFile(path, "w") as archive:
        for i in range(30000):
            archive.writestr(f"f{i}", b"")


def deep(path: Path) -> None:
    """Deeper than anyone's work."""
    path.mkdir()
    start = os.open(path, os.O_RDONLY)
    for _ in range(60):
        os.mkdir("d", dir_fd=start)
        below = os.open("d", os.O_RDONLY, dir_fd=start)
        os.close(start)
        start = below
    os.close(start)


def folder(path: Path, fill: Callable[[Path], object]) -> None:
    path.mkdir()
    fill(path)


def text(path: Path, text: bytes) -> None:
    folder(path, lambda folder: (folder / NAME).write_bytes(text))


def truncated(path: Path, whole: int) -> None:
    write_tar(path, [tar_member(NAME, os.urandom(20000))])
    path.write_bytes(path.read_bytes()[:whole])


def xz_of_wide_window(path: Path) -> None:
    filters = [{"id": lzma.FILTER_LZMA2, "dict_size": 1 << 20, "preset": 1}]
    buffer = io.BytesIO()
    with tarfile.open(fileobj=buffer, mode="w") as archive:
        member, content = tar_member(NAME)
        archive.addfile(member, io.BytesIO(content))
    path.write_bytes(lzma.compress(buffer.getvalue(), filters=filters))
