"""Plants breaches of the architecture in a copy of the tree: the architecture test must see each.

usage: architecture_breach_test.py CMAKE
"""
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LAB = "1_rigid_body_kinematics"
NAME = "rigid_body_kinematics"

# (what it is, file, text that is added to it; None: the file is removed)
BREACHES = [
    ("common draws", "common/types.hpp", '#include "render/scene.hpp"\n'),
    ("common tests", "common/types.hpp", "#include <catch2/catch.hpp>\n"),
    ("render knows a lab", "render/files/image.hpp", f'#include "labs/{LAB}/{NAME}.hpp"\n'),
    ("an answer draws", f"solutions/{LAB}/{NAME}.cpp", '#include "render/scene.hpp"\n'),
    ("an answer copies another", f"solutions/{LAB}/{NAME}.cpp", f'#include "solutions/{LAB}/x.hpp"\n'),
    ("a stub draws", f"labs/{LAB}/{NAME}.cpp", '#include "render/scene.hpp"\n'),
    ("a contract draws", f"labs/{LAB}/{NAME}.hpp", '#include "render/scene.hpp"\n'),
    ("a lab reaches a solution", f"labs/{LAB}/scene.cpp", f'#include "solutions/{LAB}/{NAME}.cpp"\n'),
    ("a lab reaches another by ..", f"labs/{LAB}/scene.cpp", '#include "../2_x/x.hpp"\n'),
    ("a scene calls GL itself", f"labs/{LAB}/scene.cpp", "#include <GL/gl.h>\n"),
    ("a scene runs another engine", f"labs/{LAB}/scene.cpp",
     "#include <btBulletDynamicsCommon.h>\n"),
    ("a chart runs another engine", f"labs/{LAB}/chart.cpp", "#include <ode/ode.h>\n"),
    ("an answer runs another engine", f"solutions/{LAB}/{NAME}.cpp",
     "#include <LinearMath/btVector3.h>\n"),
    ("a test includes a solution", f"tests/{NAME}/mass_test.cpp",
     f'#include "solutions/{LAB}/{NAME}.cpp"\n'),
    ("a room reaches one above it", "common/exact/double_double.hpp",
     '#include "common/rotation/spin.hpp"\n'),
    ("a room of render reaches one above it", "render/draw/camera.hpp",
     '#include "render/film/film.hpp"\n'),
    ("charts know scenes", "render/chart/chart.hpp", '#include "render/draw/camera.hpp"\n'),
    ("a room has no order", "common/attic/spare.hpp", "#pragma once\n"),
    ("the points are missing", f"solutions/{LAB}/points.json", None),
    ("what crosses to a worker is missing", f"solutions/grading/{NAME}/remote.hpp", None),
    ("a handout is missing", f"labs/{LAB}/README.md", None),
    ("hints are missing", f"labs/{LAB}/hints.md", None),
    ("a reference is missing", f"solutions/{LAB}/{NAME}.cpp", None),
    ("the second right answer is missing", f"solutions/{LAB}/by_components.cpp", None),
    ("the bank of mistakes is missing", f"solutions/{LAB}/mistakes.cmake", None),
    ("a lab vanishes from the list", "labs/CMakeLists.txt", None),
    ("a lab is not declared", f"labs/{LAB}/CMakeLists.txt", None),
]


def run(cmake: str, root: Path) -> subprocess.CompletedProcess:
    return subprocess.run([cmake, "-D", f"root={root}", "-P", ROOT / "tests/architecture_test.cmake"],
                          capture_output=True, text=True, check=False)


def main() -> int:
    cmake = sys.argv[1]
    missed = []
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for part in ("common", "render", "labs", "solutions", "tests"):
            shutil.copytree(ROOT / part, root / part, ignore=shutil.ignore_patterns("*.png"))
        if run(cmake, root).returncode != 0:
            missed.append("the untouched copy is refused")
        for story, file, text in BREACHES:
            path = root / file
            before = path.read_text(encoding="utf-8") if path.exists() else None
            if text is None:
                path.unlink()
            else:
                path.parent.mkdir(exist_ok=True)
                path.write_text((before or "") + text, encoding="utf-8")
            done = run(cmake, root)
            if done.returncode == 0 or "architecture:" not in done.stderr:
                missed.append(story)
            if before is None:
                path.unlink()
            else:
                path.write_text(before, encoding="utf-8")
        if run(cmake, root).returncode != 0:
            missed.append("the copy that is whole again is refused")
    for story in missed:
        print(f"not caught: {story}")
    print(f"{len(BREACHES) - len(missed)} of {len(BREACHES)} breaches caught")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
