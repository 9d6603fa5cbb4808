"""Folders, zip and tar archives, entry by entry. Nothing is ever unpacked to disk."""

from __future__ import annotations

import bz2
import gzip
import io
import lzma
import os
import stat
import tarfile
import zipfile
from typing import BinaryIO, Optional

from finder import Finder, Problem, bounded

_ARCHIVE_LIMIT = 64 << 20
_UNPACKED_LIMIT = 256 << 20
_DEPTH_LIMIT = 24
_PACKED = {b"\x1f\x8b": gzip.open, b"BZ": bz2.open, b"\xfd7": lzma.open}


def _open(path: str, folder: Optional[int] = None) -> int:
    """No link is followed, and no pipe or device is waited for."""
    handle = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK, dir_fd=folder)
    if not stat.S_ISREG(os.fstat(handle).st_mode):
        os.close(handle)
        raise Problem("it is not a regular file")
    return handle


def read_folder(path: str, finder: Finder) -> None:
    handle = os.open(path, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW)
    _walk(handle, "", _DEPTH_LIMIT, finder)


def _walk(folder: int, prefix: str, depth: int, finder: Finder) -> None:
    if depth == 0:
        raise Problem(f"it has folders more than {_DEPTH_LIMIT} deep")

    def read(name: str) -> bytes:
        with os.fdopen(_open(name, folder), "rb") as stream:
            return bounded(stream)

    try:
        for entry in sorted(os.scandir(folder), key=lambda entry: entry.name):
            is_folder = entry.is_dir(follow_symlinks=False)
            problem = ("it is a folder" if is_folder else
                       "it is a symbolic link" if entry.is_symlink() else "")
            finder.meet(prefix + entry.name, problem, lambda: read(entry.name))
            if is_folder:
                below = os.open(entry.name, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW,
                                dir_fd=folder)
                _walk(below, f"{prefix}{entry.name}/", depth - 1, finder)
    finally:
        os.close(folder)


def read_zip(stream: BinaryIO, finder: Finder) -> None:
    with zipfile.ZipFile(stream) as archive:
        for member in archive.infolist():
            kind = stat.S_IFMT(member.external_attr >> 16)
            problem = ("it is a folder" if member.is_dir() else
                       "it is a symbolic link" if kind == stat.S_IFLNK else
                       "it is not a regular file" if kind not in (0, stat.S_IFREG) else
                       "it is encrypted" if member.flag_bits & 1 else "")

            def read(member: zipfile.ZipInfo = member) -> bytes:
                with archive.open(member) as text:
                    return bounded(text, member.file_size)

            finder.meet(member.filename, problem, read)


class Capped(io.RawIOBase):
    """A stream that ends in a Problem where a small archive unpacks to too much."""

    def __init__(self, stream: BinaryIO):
        self._stream = stream
        self._left = _UNPACKED_LIMIT

    def read(self, size: int = -1) -> bytes:
        block = self._stream.read(min(size if size >= 0 else 1 << 20, 1 << 20))
        self._left -= len(block)
        if self._left < 0:
            raise Problem(f"it unpacks to more than {_UNPACKED_LIMIT >> 20} MiB")
        return block


def read_tar(stream: BinaryIO, finder: Finder) -> None:
    head = stream.read(2)
    stream.seek(0)
    opened = _PACKED[head](stream) if head in _PACKED else stream
    with tarfile.open(fileobj=Capped(opened), mode="r|") as archive:  # type: ignore[arg-type]
        for member in archive:
            problem = ("it is a folder" if member.isdir() else
                       "it is a link" if member.issym() or member.islnk() else
                       "" if member.isreg() else "it is not a regular file")

            def read(member: tarfile.TarInfo = member) -> bytes:
                text = archive.extractfile(member)
                assert text is not None
                return bounded(text, member.size)  # type: ignore[arg-type]

            finder.meet(member.name, problem, read)


def read_submission(path: str, finder: Finder) -> None:
    mode = os.lstat(path).st_mode
    if stat.S_ISLNK(mode):
        raise Problem("it is a symbolic link")
    if stat.S_ISDIR(mode):
        return read_folder(path, finder)
    with os.fdopen(_open(path), "rb") as stream:
        if os.fstat(stream.fileno()).st_size > _ARCHIVE_LIMIT:
            raise Problem(f"it is larger than {_ARCHIVE_LIMIT >> 20} MiB")
        is_zip = stream.read(2) == b"PK"
        stream.seek(0)
        return read_zip(stream, finder) if is_zip else read_tar(stream, finder)
