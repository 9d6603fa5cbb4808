"""Files in the output folder: each replaced in one move, so that nobody meets half of one."""

from __future__ import annotations

import csv
import io
import json
import os
from pathlib import Path
from typing import Mapping, Sequence

from ..console import Failure
from .score import Case, LabResult, StepResult

RECORDS = ".records"
"""What graders know of each student, for --resume and the summary."""

_FORMULA = ("=", "+", "-", "@", "\t")


def write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    draft = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        draft.write_text(text, encoding="utf-8", errors="replace")
        os.replace(draft, path)
    except OSError as error:
        draft.unlink(missing_ok=True)
        raise Failure(f"cannot write {path}: {error.strerror}") from error


def json_text(content: object) -> str:
    return json.dumps(content, indent=1, ensure_ascii=False, sort_keys=True) + "\n"


def record_file(out: Path, student: str) -> Path:
    return out / RECORDS / f"{student}.json"


def to_json(result: LabResult) -> dict:
    steps = [{**step._asdict(), "cases": [list(case) for case in step.cases]}
             for step in result.steps]
    return {**result._asdict(), "steps": steps}


def from_json(content: Mapping) -> LabResult:
    steps = [StepResult(**{**step, "cases": [Case(*case) for case in step["cases"]]})
             for step in content["steps"]]
    return LabResult(**{**content, "steps": steps})


def read_record(out: Path, student: str) -> dict:
    """Lab folder: {"key", "result"}. Empty where there is none, or only half of an older one."""
    try:
        content = json.loads(record_file(out, student).read_text(encoding="utf-8"))
        return {folder: {"key": entry["key"], "result": from_json(entry["result"])}
                for folder, entry in content["labs"].items()}
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return {}


def write_record(out: Path, student: str, labs: Mapping[str, Mapping]) -> None:
    content = {folder: {"key": entry["key"], "result": to_json(entry["result"])}
               for folder, entry in labs.items()}
    write(record_file(out, student), json_text({"student": student, "labs": content}))


def csv_text(rows: Sequence[Sequence[object]]) -> str:
    """No cell can be taken for a formula by a spreadsheet."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    for row in rows:
        writer.writerow([f"'{cell}" if isinstance(cell, str) and cell.startswith(_FORMULA)
                         else cell for cell in row])
    return stream.getvalue()
