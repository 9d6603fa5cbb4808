"""What this machine has of what Tumble needs, asked of the tools themselves."""

from __future__ import annotations

import os
import platform
import re
import shlex
import subprocess
from pathlib import Path
from typing import NamedTuple, Sequence

_VERSION = re.compile(r"\d+(?:\.\d+)+")
_OLDEST_COMPILER = {"gcc": 11, "clang": 14}
_OLDEST_CMAKE = (3, 25)
_NEWER_COMPILER = ("install a newer one beside it, such as g++-12, and type CXX=g++-12 before the "
                   "command, as in CXX=g++-12 ./tumble test 1")
_NEWER_CMAKE = ("this system has no newer package; python3 -m pip install --user cmake gets one "
                "in ~/.local/bin, which must come first in PATH (cmake.org has archives, too)")
_FONTS = ("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans.ttf",
          "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf")
_INCLUDE_FLAGS = ("-I/usr/include/eigen3", "-I/usr/include/stb")
_CATCH2_VERSION = "CATCH_VERSION_MAJOR CATCH_VERSION_MINOR CATCH_VERSION_PATCH"


class Finding(NamedTuple):
    name: str
    version: str
    """Or "yes"; empty where it is missing."""
    usable: bool
    purpose: str
    package: str
    needed: bool = True
    command: str = "demo"
    """The one that installs it."""
    newer: str = ""
    """Where to get a newer one: the package of this system is the old one."""


class Header(NamedTuple):
    """A library, known by one of its headers; macros give its version where there are any."""

    name: str
    purpose: str
    package: str
    includes: Sequence[str]
    version: str = "yes"
    needed: bool = True
    command: str = "demo"


HEADERS = (
    Header("Eigen", "vectors, matrices, quaternions", "libeigen3-dev",
           ["Eigen/src/Core/util/Macros.h"],
           "EIGEN_WORLD_VERSION EIGEN_MAJOR_VERSION EIGEN_MINOR_VERSION"),
    Header("Catch2", "the tests", "catch2", ["catch2/catch_version_macros.hpp", "catch2/catch.hpp"],
           _CATCH2_VERSION),
    Header("Boost", "exact references of the tests", "libboost-dev", ["boost/version.hpp"],
           "BOOST_LIB_VERSION"),
    Header("benchmark", "timings of the charts", "libbenchmark-dev", ["benchmark/benchmark.h"]),
    Header("stb", "writes PNG pictures", "libstb-dev", ["stb_image_write.h"]),
    Header("ISA-L", "packs PNG pictures", "libisal-dev", ["isa-l.h"],
           "ISAL_MAJOR_VERSION ISAL_MINOR_VERSION ISAL_PATCH_VERSION"),
    Header("OpenGL", "header for pictures", "libgl-dev", ["GL/glcorearb.h"], needed=False),
    Header("OSMesa", "pictures without a screen", "libosmesa6-dev", ["GL/osmesa.h"],
           "OSMESA_MAJOR_VERSION OSMESA_MINOR_VERSION", needed=False),
    Header("EGL", "pictures without a screen", "libegl-dev libegl1 libegl-mesa0 libgl1-mesa-dri",
           ["EGL/egl.h"], needed=False, command="verify"),
)


def examine() -> list[Finding]:
    compiler = _compiler()
    command = compiler.name if compiler.version else ""
    return [compiler, _cmake(), _tool("ninja", "runs the build", "ninja-build"),
            *(_library(header, command) for header in HEADERS),
            _tool("gnuplot", "draws the charts", "gnuplot-nox", needed=False),
            _font(), Finding("python3", platform.python_version(), True, "this command", "python3")]


def _compiler() -> Finding:
    """The one that CMake takes: $CXX, or else the first that there is."""
    chosen = shlex.split(os.environ.get("CXX", ""))[:1]
    for name in [*chosen, "c++", "g++", "clang++"]:
        words = _output([name, "--version"])
        version = _VERSION.search(words)
        if version:
            kind = "clang" if "clang" in words.lower() else "gcc"
            good = int(version.group().split(".")[0]) >= _OLDEST_COMPILER[kind]
            return Finding(name, f"{kind} {version.group()}", good,
                           "C++20: g++ 11 or clang 14 or newer", "g++", newer=_NEWER_COMPILER)
    return Finding("c++", "", False, "C++20: g++ 11 or clang 14 or newer", "g++")


def _cmake() -> Finding:
    version = _version_of("cmake")
    good = bool(version) and tuple(map(int, version.split(".")[:2])) >= _OLDEST_CMAKE
    return Finding("cmake", version, good, "configures the build: 3.25 or newer", "cmake",
                   newer=_NEWER_CMAKE)


def _tool(name: str, purpose: str, package: str, needed: bool = True) -> Finding:
    version = _version_of(name)
    return Finding(name, version, bool(version), purpose, package, needed)


def _font() -> Finding:
    found = any(Path(font).exists() for font in _FONTS)
    return Finding("DejaVu Sans", "yes" if found else "", found, "letters in pictures",
                   "fonts-dejavu-core", needed=False)


def _version_of(tool: str) -> str:
    version = _VERSION.search(_output([tool, "--version"]))
    return version.group() if version else ""


def _library(header: Header, compiler: str) -> Finding:
    """Asks the preprocessor: it knows where headers are."""
    version = ""
    for include in header.includes if compiler else ():
        probe = f"#include <{include}>\nfound: {header.version}\n"
        command = [compiler, "-std=c++20", "-E", "-P", "-x", "c++", *_INCLUDE_FLAGS, "-"]
        lines = _output(command, probe)
        found = re.search(r"^found: (.+)$", lines, re.MULTILINE)
        if found:
            version = re.sub(r"[ _]", ".", found.group(1).replace('"', "").strip())
            break
    return Finding(header.name, version, bool(version), header.purpose, header.package,
                   header.needed, header.command)


def _output(command: Sequence[str], text: str = "") -> str:
    """What the command prints; nothing where it fails or does not exist."""
    try:
        done = subprocess.run(command, input=text, text=True, errors="replace",
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    except OSError:
        return ""
    return done.stdout if done.returncode == 0 else ""
