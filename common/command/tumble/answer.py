"""The student's answer, compiled and linked with its tests."""

from __future__ import annotations

from pathlib import Path

from . import build, diagnosis
from .console import Failure, coloured, say
from .labs import Lab


def compiled(root: Path, lab: Lab, kind: str = "") -> Path:
    """The test program; what the compiler warns of is said, and why it cannot be built is raised.

    kind  "debug" or "sanitized", or the one that every save makes
    """
    target = "_".join(filter(None, (lab.name, "student", kind, "test")))
    built = build.build(root, "dev", [target])
    told = "\n".join(diagnosis.told(lab, built.diagnostics, build.DIAGNOSTICS_LIMIT))
    if not built.ok:
        missing = diagnosis.missing_functions(lab, built.diagnostics)
        if missing:
            raise Failure(f"{lab.stub.name}: {missing[0]}", details="\n".join(missing[1:]))
        own_fault = f"{lab.stub.name}:" in built.diagnostics
        blamed = lab.stub.name if own_fault else f"the test of lab {lab.number}"
        raise Failure(f"{blamed} does not build, so nothing is tested yet", details=told)
    if built.diagnostics and not kind:
        say(coloured("The compiler warns:", "yellow"), told, "")
    return build.build_folder(root, "dev") / "labs" / lab.folder / target
