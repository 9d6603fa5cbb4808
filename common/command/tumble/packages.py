"""The Debian packages that Tumble needs, and their installation by apt: only of what is missing."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple, Sequence, TextIO

from .console import Failure, Progress
from .labs import is_handout


class Package(NamedTuple):
    name: str
    purpose: str
    optional: bool = False


PACKAGES = (
    Package("g++", "the C++20 compiler"),
    Package("cmake", "configures the build"),
    Package("ninja-build", "runs the build"),
    Package("lld", "links faster", optional=True),
    Package("libeigen3-dev", "vectors, matrices, quaternions"),
    Package("catch2", "the tests"),
    Package("libboost-dev", "exact references of the tests"),
    Package("libbenchmark-dev", "timings of the charts"),
    Package("libtinyobjloader-dev", "reads OBJ meshes"),
    Package("libstb-dev", "writes PNG pictures"),
    Package("libisal-dev", "packs PNG pictures"),
    Package("libgl-dev", "header of OpenGL"),
    Package("libosmesa6-dev", "draws without a screen: OSMesa", optional=True),
    Package("libegl-dev", "header of EGL"),
    Package("libegl1", "draws without a screen: EGL"),
    Package("libegl-mesa0", "draws without a screen: EGL"),
    Package("libgl1-mesa-dri", "draws without a graphics card"),
    Package("gnuplot-nox", "draws the charts"),
    Package("fonts-dejavu-core", "letters in pictures and charts"),
)

GRADING_PACKAGES = (
    Package("bubblewrap", "boxes the files that are graded"),
    Package("util-linux", "limits the files that are graded"),
)
"""A hand-out, which grades nobody, does without."""

_NEW_PACKAGES = re.compile(r"(\d+) newly installed")


def missing_packages(packages: Sequence[Package] = PACKAGES) -> list[Package]:
    installed = _query(["dpkg-query", "-W", "-f", "${Package} ${db:Status-Status}\n",
                        *(package.name for package in packages)])
    present = {line.split()[0] for line in installed.splitlines() if line.endswith(" installed")}
    return [package for package in packages if package.name not in present]


def install_missing(root: Path) -> None:
    """Installs what is missing. An optional package that this release lacks is not missing."""
    missing = missing_packages(PACKAGES if is_handout(root) else PACKAGES + GRADING_PACKAGES)
    if not any(not package.optional for package in missing):
        missing = _available(missing)
    if not missing:
        return
    if not shutil.which("apt-get"):
        raise _by_hand(missing, "there is no apt-get here")
    prefix = _as_root(missing)
    log = root / "build" / "apt.log"
    log.parent.mkdir(exist_ok=True)
    with Progress() as progress, open(log, "w", encoding="utf-8") as record:
        progress.show("installing: reading the package lists")
        subprocess.run([*prefix, "apt-get", "-q", "update"], stdout=record,
                       stderr=subprocess.STDOUT)
        wanted = [package for package in missing if not package.optional]
        wanted += _available([package for package in missing if package.optional])
        if wanted and _install(prefix, wanted, record, progress) != 0:
            if any(not package.optional for package in wanted):
                raise _by_hand(wanted, "apt-get failed, see build/apt.log")


def _as_root(missing: Sequence[Package]) -> list[str]:
    setting = ["env", "DEBIAN_FRONTEND=noninteractive"]
    if os.geteuid() == 0:
        return setting
    if not shutil.which("sudo"):
        raise _by_hand(missing, "this needs root, and there is no sudo")
    print("tumble: installing packages; sudo may ask for your password", file=sys.stderr)
    return ["sudo", *setting]


def _install(prefix: Sequence[str], wanted: Sequence[Package], record: TextIO,
             progress: Progress) -> int:
    command = [*prefix, "apt-get", "-q", "-y", "--no-install-recommends",
               "-o", "DPkg::Lock::Timeout=120", "-o", "Dpkg::Use-Pty=0", "install",
               *(package.name for package in wanted)]
    total = len(wanted)
    done = 0
    progress.show(f"installing: {total} packages and what they need")
    with subprocess.Popen(command, text=True, errors="replace", stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT) as process:
        for line in process.stdout or ():
            record.write(line)
            count = _NEW_PACKAGES.search(line)
            if count:
                total = int(count.group(1))
            if line.startswith("Setting up "):
                done += 1
                progress.show(f"installing: {done} of {total} packages")
    return process.returncode


def _available(packages: Sequence[Package]) -> list[Package]:
    """Those that apt knows here: Mesa 25.1, for one, has given up OSMesa."""
    return [package for package in packages
            if _query(["apt-cache", "show", "--no-all-versions", package.name])]


def _by_hand(packages: Sequence[Package], why: str) -> Failure:
    names = " ".join(package.name for package in packages)
    return Failure(f"{why}; install by hand: {names} "
                   "(or, where they have other names and are there: --no-install)")


def _query(command: Sequence[str]) -> str:
    """What the command prints; nothing where it does not exist."""
    try:
        return subprocess.run(command, text=True, errors="replace", stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL).stdout
    except FileNotFoundError:
        return ""
