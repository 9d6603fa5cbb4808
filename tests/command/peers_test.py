"""CMake finds other engines, in whichever version is installed, and says which it does not find."""

import subprocess
import tempfile
import unittest
from pathlib import Path

from fake_kit import ROOT

PROJECT = """
cmake_minimum_required(VERSION 3.25)
project(peers LANGUAGES CXX)
set(TUMBLE_EMBREE ON)
set(TUMBLE_BULLET OFF)
if(NO_LIBRARY)
  set(CMAKE_FIND_LIBRARY_PREFIXES "no")
endif()
include("{root}/common/cmake/Dependencies.cmake")
if(TARGET peer_embree)
  get_target_property(folder peer_embree INTERFACE_INCLUDE_DIRECTORIES)
  get_target_property(library peer_embree INTERFACE_LINK_LIBRARIES)
  message(STATUS "Embree: ${{folder}} ${{library}}")
endif()
"""


class Peers(unittest.TestCase):
    """All configure one folder, because it takes seconds to find out about a compiler."""

    @classmethod
    def setUpClass(cls) -> None:
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        (cls.folder / "CMakeLists.txt").write_text(PROJECT.format(root=ROOT), encoding="utf-8")

    def configure(self, *arguments: str) -> str:
        forget = [f"-U{name}" for name in ("EMBREE*", "ISAL_LIBRARY", "NO_LIBRARY",
                                           "CMAKE_PREFIX_PATH")]
        done = subprocess.run(["cmake", "-G", "Ninja", "-B", self.folder / "build", "-S",
                               self.folder, *forget, *arguments], text=True, capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_embree_is_found_as_version_3_and_as_version_4(self) -> None:
        for version in ("3", "4"):
            prefix = self.folder / f"embree {version}"
            header = prefix / "include" / f"embree{version}" / "rtcore.h"
            library = prefix / "lib" / f"libembree{version}.so"
            for file in (header, library):
                file.parent.mkdir(parents=True)
                file.touch()
            said = self.configure(f"-DCMAKE_PREFIX_PATH={prefix}")
            self.assertIn(f"Embree: {header.parent} {library}", said)

    def test_an_engine_that_is_not_found_is_named(self) -> None:
        said = self.configure("-DISAL_LIBRARY=/usr/lib/libisal.so", "-DNO_LIBRARY=ON")
        self.assertNotIn("Peer bullet", said)
        self.assertIn("Peer embree: not found", said)


if __name__ == "__main__":
    unittest.main()
