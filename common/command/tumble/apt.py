"""Runs apt-get: with a counter that moves, and with the reason where it fails."""

from __future__ import annotations

import re
import subprocess
from typing import Callable, Sequence, TextIO

from .console import Progress

# Its words are read, so they are to be English. Without a network it is to say so soon.
_APT_GET = ("env", "LC_ALL=C", "DEBIAN_FRONTEND=noninteractive", "RES_OPTIONS=timeout:3 attempts:1",
            "apt-get", "-q", "-o", "Acquire::Retries=0", "-o", "Acquire::http::Timeout=10",
            "-o", "Acquire::https::Timeout=10")
_NEW_PACKAGES = re.compile(r"(\d+) newly installed")
_STEPS = {"Get": "fetched", "Unpacking": "unpacked", "Setting": "set up"}
_STEP = re.compile(r"(Get):\d+ |(Unpacking|Setting) ")
_REFUSAL = re.compile(r"^(?:E|sudo): (.+)$", re.MULTILINE)
_NO_CAUSE = ("Unable to fetch some archives", "Some index files failed to download")


def update(prefix: Sequence[str], record: TextIO, progress: Progress) -> str:
    """Why the lists of packages could not be read; empty where they were."""
    progress.show("installing: reading the package lists")
    command = [*prefix, *_APT_GET, "-o", "APT::Update::Error-Mode=any", "update"]
    return _run(command, record, lambda line: None)


def install(prefix: Sequence[str], wanted: Sequence[str], record: TextIO,
            progress: Progress) -> str:
    """Why it failed; empty where it did not."""
    command = [*prefix, *_APT_GET, "-y", "--no-install-recommends", "-o", "Dpkg::Use-Pty=0",
               "-o", "DPkg::Lock::Timeout=120", "install", *wanted]
    counter = Counter(len(wanted))
    progress.show(str(counter))

    def show(line: str) -> None:
        counter.read(line)
        progress.show(str(counter))

    return _run(command, record, show)


class Counter:
    """How far apt is, from its lines."""

    def __init__(self, total: int) -> None:
        self._total = total
        self._done = dict.fromkeys(_STEPS.values(), 0)

    def read(self, line: str) -> None:
        count = _NEW_PACKAGES.search(line)
        if count:
            self._total = int(count.group(1))
        step = _STEP.match(line)
        if step:
            self._done[_STEPS[step.group(1) or step.group(2)]] += 1

    def __str__(self) -> str:
        done = ", ".join(f"{count} {word}" for word, count in self._done.items() if count)
        return f"installing {self._total} packages" + (f": {done}" if done else "")


def _run(command: Sequence[str], record: TextIO, read: Callable[[str], None]) -> str:
    """The last line in which the tool says why it failed; empty where it did not."""
    lines = []
    with subprocess.Popen(command, text=True, errors="replace", stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT) as process:
        for line in process.stdout or ():
            record.write(line)
            lines.append(line)
            read(line)
    if process.returncode == 0:
        return ""
    told = [" ".join(why.split()) for why in _REFUSAL.findall("".join(lines))
            if not why.startswith(_NO_CAUSE)]
    return told[-1] if told else f"exit code {process.returncode}"
