"""The Debian packages that Tumble needs, and their installation: only of what is missing."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple, Sequence

from . import apt
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
    Package("libeigen3-dev", "vectors, matrices, quaternions"),
    Package("catch2", "the tests"),
    Package("libboost-dev", "exact references of the tests"),
    Package("libbenchmark-dev", "timings of the charts"),
    Package("libstb-dev", "writes PNG pictures"),
    Package("libisal-dev", "packs PNG pictures"),
    Package("libgl-dev", "header of OpenGL"),
    Package("libosmesa6-dev", "draws without a screen: OSMesa", optional=True),
    Package("gnuplot-nox", "draws the charts"),
    Package("fonts-dejavu-core", "letters in pictures and charts"),
)
"""What the labs and their pictures take."""

EGL_PACKAGES = (
    Package("libegl-dev", "header of EGL"),
    Package("libegl1", "draws without a screen: EGL"),
    Package("libegl-mesa0", "draws without a screen: EGL"),
    Package("libgl1-mesa-dri", "draws without a graphics card"),
)
"""In OSMesa's place where this release has none; and for the proof, which compares the two."""

PROOF_PACKAGES = (
    Package("lld", "links faster: there is much to link", optional=True),
    Package("bubblewrap", "isolates the programs that are graded"),
    Package("util-linux", "limits the programs that are graded"),
)
"""What ./tumble verify takes beside them; a hand-out, which proves nothing, does without."""

_LOG = "build/apt.log"


def missing_packages(packages: Sequence[Package] = PACKAGES) -> list[Package]:
    installed = _query(["dpkg-query", "-W", "-f", "${Package} ${db:Status-Status}\n",
                        *(package.name for package in packages)])
    present = {line.split()[0] for line in installed.splitlines() if line.endswith(" installed")}
    return [package for package in packages if package.name not in present]


def install_missing(root: Path, proof: bool = True) -> None:
    """Installs what is missing. An optional package that this release lacks is not missing."""
    missing = _missing(root, proof)
    if not any(not package.optional for package in missing):
        missing = _available(missing)
    if not missing:
        return
    if not shutil.which("apt-get"):
        raise Failure(f"{_count(missing)} missing, and there is no apt-get to install them with",
                      remedy="install these by this system's package manager (names may differ), "
                             f"then add --no-install to the command: {_names(missing)}")
    prefix = root_prefix(missing)
    (root / _LOG).parent.mkdir(exist_ok=True)
    with Progress() as progress, open(root / _LOG, "w", encoding="utf-8") as record:
        refusal = apt.update(prefix, record, progress)
        missing = _missing(root, proof)
        known = _available(missing)
        needed = [package for package in missing if not package.optional]
        if refusal and not all(package in known for package in needed):
            raise _refused(needed, refusal)
        wanted = needed + [package for package in known if package.optional]
        names = [package.name for package in wanted]
        refusal = apt.install(prefix, names, record, progress) if names else ""
        if refusal and needed:
            raise _refused(needed, refusal)


def _missing(root: Path, proof: bool) -> list[Package]:
    packages = PACKAGES
    if proof and not is_handout(root):
        return missing_packages(packages + EGL_PACKAGES + PROOF_PACKAGES)
    osmesa = [package for package in packages if package.name == "libosmesa6-dev"]
    has_osmesa = not missing_packages(osmesa) or _available(osmesa)
    return missing_packages(packages if has_osmesa else packages + EGL_PACKAGES)


def root_prefix(missing: Sequence[Package]) -> list[str]:
    """What stands before a command that takes root."""
    if os.geteuid() == 0:
        return []
    if not shutil.which("sudo"):
        raise Failure(f"{_count(missing)} missing; installing needs root, and there is no sudo",
                      remedy=f"as root, type: {_by_hand(missing)}")
    print("tumble: installing packages; sudo may ask for your password", file=sys.stderr)
    if subprocess.run(["sudo", "true"]).returncode != 0:
        raise Failure(f"{_count(missing)} missing; installing needs root, and sudo refuses",
                      remedy=f"as root, type: {_by_hand(missing)}")
    return ["sudo"]


def _available(packages: Sequence[Package]) -> list[Package]:
    """Those that apt knows here: Mesa 25.1, for one, has given up OSMesa."""
    return [package for package in packages
            if _query(["apt-cache", "show", "--no-all-versions", package.name])]


def _refused(packages: Sequence[Package], why: str) -> Failure:
    sudo = "" if os.geteuid() == 0 else "sudo "
    return Failure(f"{_count(packages)} missing, and apt-get failed: {why} (more: {_LOG})", remedy=(
        f"when that is solved, type the same command again, or: {sudo}{_by_hand(packages)}"))


def _by_hand(packages: Sequence[Package]) -> str:
    return f"apt-get install --no-install-recommends {_names(packages)}"


def _names(packages: Sequence[Package]) -> str:
    return " ".join(package.name for package in packages)


def _count(packages: Sequence[Package]) -> str:
    return "1 package is" if len(packages) == 1 else f"{len(packages)} packages are"


def _query(command: Sequence[str]) -> str:
    """What the command prints; nothing where it does not exist."""
    try:
        return subprocess.run(command, text=True, errors="replace", stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL).stdout
    except FileNotFoundError:
        return ""
