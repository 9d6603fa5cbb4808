"""Submissions that a grader must survive, each with what must be said of it."""

from __future__ import annotations

import os
import tarfile
import zipfile
import zlib
from pathlib import Path
from typing import Callable, Optional

from evil_archives import (GOOD, NAME, bomb_tar, bomb_zip, deep, folder, huge_header, lying_zip,
                           many, tar_member, text, truncated, write_tar, write_zip,
                           xz_of_wide_window, zip_with_flag)

LINK = 0o120777
FIFO = 0o010644
FILE = 0o100644

# Name of the submission, what writes it, and what must be said; None: the good text is taken.
EVIL: list[tuple[str, Callable[[Path], object], Optional[str]]] = [
    ("good.zip", lambda p: write_zip(p, [("a/b/" + NAME, GOOD)], FILE), None),
    ("good.tar", lambda p: write_tar(p, [tar_member("./x/" + NAME)], "w"), None),
    ("good.tar.gz", lambda p: write_tar(p, [tar_member(NAME)]), None),
    ("good.tbz2", lambda p: write_tar(p, [tar_member(NAME)], "w:bz2"), None),
    ("good.tar.xz", xz_of_wide_window, None),
    ("good_folder", lambda p: text(p, GOOD), None),
    ("mac.zip", lambda p: write_zip(p, [(NAME, GOOD), ("__MACOSX/._" + NAME, b"\0")]), None),
    ("backslash.zip", lambda p: write_zip(p, [("src\\" + NAME, GOOD)]), None),
    ("other_bomb.zip", lambda p: bomb_zip(p, False), None),
    ("other_links.tar", lambda p: write_tar(p, [
        tar_member("x", kind=tarfile.SYMTYPE, link="/etc/passwd"), tar_member(NAME)], "w"), None),
    ("bom", lambda p: text(p, b"\xef\xbb\xbf" + GOOD), None),
    ("crlf", lambda p: text(p, GOOD), None),
    ("out.zip", lambda p: write_zip(p, [("../../" + NAME, GOOD)]), "leads out of the archive"),
    ("absolute.tar", lambda p: write_tar(p, [tar_member("/tmp/" + NAME)], "w"), "leads out"),
    ("out.tar", lambda p: write_tar(p, [tar_member("x/../../" + NAME)], "w"), "leads out"),
    ("twice.zip", lambda p: write_zip(p, [("a/" + NAME, GOOD), ("b/" + NAME, b"//")]),
     "the submission has spin.cpp 2 times: 'a/spin.cpp' and 'b/spin.cpp'"),
    ("same_twice.tar", lambda p: write_tar(p, [tar_member(NAME), tar_member(NAME, b"//")], "w"),
     "the submission has spin.cpp 2 times"),
    ("link.zip", lambda p: write_zip(p, [(NAME, b"/etc/passwd")], LINK), "is a symbolic link"),
    ("fifo.zip", lambda p: write_zip(p, [(NAME, GOOD)], FIFO), "not a regular file"),
    ("link.tar", lambda p: write_tar(p, [tar_member(NAME, kind=tarfile.SYMTYPE,
                                                    link="/etc/passwd")], "w"), "it is a link"),
    ("hard_link.tar", lambda p: write_tar(p, [tar_member(
        NAME, kind=tarfile.LNKTYPE, link="/etc/passwd")], "w"), "it is a link"),
    ("device.tar", lambda p: write_tar(p, [tar_member(NAME, kind=tarfile.CHRTYPE)], "w"),
     "not a regular file"),
    ("fifo.tar", lambda p: write_tar(p, [tar_member(NAME, kind=tarfile.FIFOTYPE)], "w"),
     "not a regular file"),
    ("is_folder.zip", lambda p: write_zip(p, [(NAME + "/", b"")]), "it is a folder"),
    ("link_folder", lambda p: folder(p, lambda f: (f / NAME).symlink_to("/etc/passwd")),
     "is a symbolic link"),
    ("fifo_folder", lambda p: folder(p, lambda f: os.mkfifo(f / NAME)), "not a regular file"),
    ("folder_folder", lambda p: folder(p, lambda f: (f / NAME).mkdir()), "it is a folder"),
    ("loop_folder", lambda p: folder(p, lambda f: (f / "loop").symlink_to(f)), "there is no"),
    ("is_link", lambda p: p.symlink_to("/etc"), "it is a symbolic link"),
    ("is_link.zip", lambda p: p.symlink_to("/etc/passwd"), "it is a symbolic link"),
    ("is_fifo.zip", lambda p: os.mkfifo(p), "not a regular file"),
    ("deep", deep, "more than 24 deep"),
    ("long.zip", lambda p: write_zip(p, [(NAME, b"/" * 262145)]), "longer than 256 KiB"),
    ("long", lambda p: text(p, b"/" * 262145), "longer than 256 KiB"),
    ("bomb.zip", lambda p: bomb_zip(p, True), "longer than 256 KiB"),
    ("bomb.tar.gz", lambda p: bomb_tar(p, True), "longer than 256 KiB|more than 256 MiB"),
    ("other_bomb.tar.gz", lambda p: bomb_tar(p, False), "unpacks to more than 256 MiB"),
    ("header_bomb.tar.gz", huge_header, "more than 256 MiB|too much"),
    ("lying.zip", lambda p: lying_zip(p, 10), "cannot be read"),
    ("many.zip", many, "more than 20000 entries"),
    ("encrypted.zip", lambda p: zip_with_flag(p, 1), "it is encrypted"),
    ("broken.zip", lambda p: p.write_bytes(b"PK\3\4" + bytes(100)), "cannot be read"),
    ("broken.tar.gz", lambda p: p.write_bytes(b"\x1f\x8b\x08" + bytes(50)),
     "cannot be read|neither"),
    ("crc.zip", lambda p: (write_zip(p, [(NAME, GOOD)], method=zipfile.ZIP_STORED), p.write_bytes(
        p.read_bytes().replace(b"passes", b"posses"))), "cannot be read"),
    ("cut.tar.gz", lambda p: truncated(p, 9000), "cannot be read|cut short|neither"),
    ("empty.zip", lambda p: p.write_bytes(b""), "neither a folder nor"),
    ("noise.zip", lambda p: p.write_bytes(os.urandom(5000)), "neither|cannot be read"),
    ("archive.rar", lambda p: p.write_bytes(b"Rar!\x1a\x07\x01\x00" + bytes(90)), "neither"),
    ("zlib.tar", lambda p: p.write_bytes(zlib.compress(bytes(4000))), "neither"),
    ("missing.zip", lambda p: write_zip(p, [("Spin.CPP", GOOD)]),
     "there is no spin.cpp in the submission; there is 'Spin.CPP'"),
    ("newline.zip", lambda p: write_zip(p, [("a\n\x1b[2J\u202e" * 30 + "/../" + NAME, GOOD)]),
     "leads out"),
    ("utf16", lambda p: text(p, GOOD.decode().encode("utf-16")), "it is UTF-16 text"),
    ("latin1", lambda p: text(p, b"// a\n// gr\xfc\xdfe\n"),
     "not UTF-8: line 2 has the byte 0xFC"),
    ("nul", lambda p: text(p, b"int x;\0"), "it is not text: byte 7 is zero"),
]


def write_all(into: Path) -> None:
    for name, write, _ in EVIL:
        write(into / name)
