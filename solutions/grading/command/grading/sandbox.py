"""The box in which a student's file is compiled and run: bubblewrap, without network, limited.

The compiler sees /usr, the headers that students have, and what it links with; a worker sees /usr
and itself. Neither sees tests, solutions or other students. Under root all of it runs as a user
without rights: root would keep its capabilities within, and no limit of processes holds for it.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path
from typing import NamedTuple, Sequence

from ..console import Failure

NO_SANDBOX = 3
"""The exit code where students' files cannot be run safely."""

NOBODY = 61001
"""A user and a group that have nothing."""

STATUS_DESCRIPTOR = 5
"""Where bubblewrap says that it has come up, as solutions/grading/worker.cpp wants it."""

_TOOLS = (("bwrap", "bubblewrap"), ("prlimit", "util-linux"), ("setpriv", "util-linux"))
_MIB = 1 << 20
_SANITIZERS = (
    ("ASAN_OPTIONS", "exitcode=99:detect_leaks=0:hard_rss_limit_mb=512:handle_segv=1:"
                     "allocator_may_return_null=0:abort_on_error=0:log_path=stderr"),
    ("UBSAN_OPTIONS", "halt_on_error=1:exitcode=99:print_stacktrace=0:log_path=stderr"),
)


class Limits(NamedTuple):
    """What one program may take. `cpu` [s] is 0 where the caller limits it; memory and processes
    are 0 where nothing does."""

    cpu: int
    memory: int
    file: int
    processes: int
    files: int
    scratch: int

    def command(self) -> list[str]:
        """Within the box, since the kernel counts the processes of a user by namespace."""
        words = [_tool("prlimit"), f"--fsize={self.file}", f"--nofile={self.files}", "--core=0"]
        words += [f"--nproc={self.processes}"] if self.processes else []
        words += [f"--as={self.memory}"] if self.memory else []
        words += [f"--cpu={self.cpu}"] if self.cpu else []
        return words


COMPILER = Limits(60, 2048 * _MIB, 64 * _MIB, 16, 64, 256 * _MIB)
WORKER = Limits(0, 1024 * _MIB, _MIB, 1, 32, 16 * _MIB)
"""A worker is one process of one thread: what it cannot start cannot outlive it."""
SANITIZED_WORKER = Limits(0, 0, _MIB, 8, 32, 16 * _MIB)
"""The sanitizers reserve address space and watch their memory from a thread of their own."""


def _unboxed(limits: Limits) -> Limits:
    """Without a namespace all processes of the user count, whoever began them: then a limit can
    only be none or, for what is to begin no other, 1."""
    return limits if limits.processes == 1 else limits._replace(processes=0)


class Sandbox:
    """boxed: whether there is one; where there is none, only limits and another user are left."""

    def __init__(self, boxed: bool):
        self.boxed = boxed
        self.changes_user = os.geteuid() == 0 and shutil.which("setpriv") is not None

    @staticmethod
    def find(allow_none: bool) -> "Sandbox":
        """Fails closed where bubblewrap does not work, unless that is allowed."""
        for tool, package in _TOOLS[1:] if allow_none else _TOOLS:
            if not shutil.which(tool):
                raise Failure(f"{tool} is missing, so no student's file is run: install {package}"
                              + ("" if allow_none else ", or grade with --no-sandbox"), NO_SANDBOX)
        sandbox = Sandbox(not allow_none)
        if sandbox.boxed:
            sandbox._require_that_it_works()
        return sandbox

    def _require_that_it_works(self) -> None:
        command = self._boxed(WORKER, [], ["/usr/bin/true"])
        try:
            done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                  stderr=subprocess.PIPE, text=True, errors="replace", timeout=30)
        except subprocess.TimeoutExpired:
            raise Failure("bubblewrap does not start, so no student's file is run", NO_SANDBOX
                          ) from None
        if done.returncode != 0:
            words = (done.stderr.strip().splitlines() or [f"exit code {done.returncode}"])[0]
            raise Failure(f"bubblewrap does not work here, so no student's file is run: {words} "
                          "(does this machine let users make namespaces?)", NO_SANDBOX)

    def worker_command(self, driver: Path, sanitized: bool) -> list[str]:
        limits = SANITIZED_WORKER if sanitized else WORKER
        settings = _SANITIZERS if sanitized else ()
        if not self.boxed:
            words = [_tool("env"), "-i", *(f"{name}={value}" for name, value in settings)]
            return [*self.as_user(), *words, *_unboxed(limits).command(), str(driver)]
        mounts = ["--chdir", "/tmp", "--ro-bind", str(driver), "/driver",
                  *(word for setting in settings for word in ("--setenv", *setting))]
        options = ["--json-status-fd", str(STATUS_DESCRIPTOR)]
        return self._boxed(limits, mounts, ["/driver"], options)

    def compile_command(self, kit: Path, out: Path, command: Sequence[str]) -> list[str]:
        """The command sees `kit` as /kit, begins there, and may write to `out`, seen as /out."""
        if not self.boxed:
            paths = {"/kit": str(kit), "/out": str(out)}
            words = [_within(word, paths) for word in command]
            return [*self.as_user(), _tool("env"), "-i", "-C", str(kit), "PATH=/usr/bin",
                    "LC_ALL=C", f"TMPDIR={out}", *_unboxed(COMPILER).command(), *words]
        mounts = ["--ro-bind", str(kit), "/kit", "--bind", str(out), "/out", "--chdir", "/kit"]
        return self._boxed(COMPILER, mounts, command)

    def give(self, folder: Path) -> None:
        """Lets the box's user write there."""
        if self.changes_user:
            os.chown(folder, NOBODY, NOBODY)

    def _boxed(self, limits: Limits, mounts: Sequence[str], command: Sequence[str],
               options: Sequence[str] = ()) -> list[str]:
        return [*self.as_user(), _tool("bwrap"), "--unshare-all", "--unshare-user",
                "--disable-userns", "--cap-drop", "ALL", "--new-session", "--die-with-parent",
                "--clearenv", *options,
                "--uid", "1000", "--gid", "1000", "--hostname", "box",
                "--ro-bind", "/usr", "/usr", *_system_links(), "--proc", "/proc", "--dev", "/dev",
                "--size", str(limits.scratch), "--tmpfs", "/tmp",
                "--setenv", "PATH", "/usr/bin", "--setenv", "LC_ALL", "C",
                "--setenv", "HOME", "/tmp", *mounts,
                "--", *limits.command(), *command]

    def as_user(self) -> list[str]:
        if not self.changes_user:
            return []
        return [_tool("setpriv"), f"--reuid={NOBODY}", f"--regid={NOBODY}", "--clear-groups"]


def _tool(name: str) -> str:
    path = shutil.which(name)
    if path is None:
        raise Failure(f"{name} is missing", NO_SANDBOX)
    return path


def _system_links() -> list[str]:
    """/lib and its like, as they are here: links into /usr, or folders of their own."""
    words: list[str] = []
    for name in ("/bin", "/lib", "/lib32", "/lib64", "/sbin"):
        if os.path.islink(name):
            words += ["--symlink", os.readlink(name), name]
        elif os.path.isdir(name):
            words += ["--ro-bind", name, name]
    return words


def _within(word: str, paths: dict[str, str]) -> str:
    for seen, real in paths.items():
        if word == seen or word.startswith(f"{seen}/"):
            return real + word[len(seen):]
    return word
