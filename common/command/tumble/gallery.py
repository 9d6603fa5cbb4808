"""What there is in out/: out/<N>_<name>/<answer>/{film,chart}, read with distrust."""

from __future__ import annotations

import csv
import json
import math
import re
import shlex
from pathlib import Path
from typing import Any, NamedTuple, Optional, Sequence

from .labs import Lab

STUDENT = "student"
REFERENCE = "reference"
FILM = "film"
CHART = "chart"

_COMMANDS = {FILM: "frames", CHART: "chart"}
_INDEX = "charts.txt"
_MAIN_CHART = "chart"
_ANSWER = re.compile(r"[a-z][a-z0-9_]*")
_CHART_NAME = re.compile(r"[a-z0-9_]+")
_CHART_FILES = (".svg", ".png", ".pdf", ".csv", ".gp")


class Film(NamedTuple):
    variant: str
    command: str
    title: str
    subtitle: str
    parameters: str
    measured: str
    missing: Sequence[str]
    fps: float
    start: float
    frames: Sequence[Path]
    strip: Optional[Path]


class Chart(NamedTuple):
    variant: str
    command: str
    name: str
    title: str
    image: Optional[Path]
    files: Sequence[Path]
    methods: Sequence[str]
    missing: Sequence[str]


class LabPictures(NamedTuple):
    lab: Lab
    films: Sequence[Film]
    charts: Sequence[Chart]


def read_gallery(labs: Sequence[Lab], out: Path) -> list[LabPictures]:
    """The student's pictures come first, then the reference's."""
    gallery = []
    for lab in labs:
        others = sorted(path.name for path in (out / lab.folder).glob("*")
                        if _ANSWER.fullmatch(path.name) and path.name not in (STUDENT, REFERENCE))
        variants = (STUDENT, REFERENCE, *others)
        films = [_read_film(lab, variant, out) for variant in variants]
        charts = [chart for variant in variants for chart in _read_charts(lab, variant, out)]
        gallery.append(LabPictures(lab, [film for film in films if film], charts))
    return gallery


def command_file(folder: Path) -> Path:
    """Beside the folder of the pictures, in which their program wants its own files alone."""
    return folder.with_name(f"{folder.name}-command.txt")


def of_answer(variant: str) -> list[str]:
    """What is typed for pictures of this answer."""
    return {STUDENT: [], REFERENCE: ["--solution"]}.get(variant, ["--answer", variant])


def default_command(lab: Lab, variant: str, kind: str) -> str:
    return shlex.join(["./tumble", _COMMANDS[kind], str(lab.number), *of_answer(variant)])


def _read_film(lab: Lab, variant: str, out: Path) -> Optional[Film]:
    folder = out / lab.folder / variant / FILM
    frames = sorted(folder.glob("frame_*.png"), key=lambda path: (len(path.name), path.name))
    if not frames:
        return None
    told = _read_json(folder / "film.json")
    return Film(variant, _command(lab, variant, FILM, folder), _words(told, "title"),
                _words(told, "subtitle"), _words(told, "parameters"), _words(told, "measured"),
                _names(told.get("missing")), _number(told.get("fps"), 25.0) or 25.0,
                _number(told.get("from"), 0.0), frames, _existing(folder / "strip.png"))


def _read_charts(lab: Lab, variant: str, out: Path) -> list[Chart]:
    """In the order of their program, the main one first."""
    folder = out / lab.folder / variant / CHART
    command = _command(lab, variant, CHART, folder)
    charts = []
    for name, title in _chart_titles(folder).items():
        files = [folder / f"{name}{ending}" for ending in _CHART_FILES]
        files = [file for file in files if file.is_file()]
        if files:
            drawn = [file for file in files if file.suffix in (".svg", ".png")]
            methods = _read_methods(folder / f"{name}.csv")
            charts.append(Chart(variant, command, name, title, drawn[0] if drawn else None, files,
                                [method for method, written in methods.items() if written],
                                [method for method, written in methods.items() if not written]))
    return charts


def _chart_titles(folder: Path) -> dict[str, str]:
    """By name. The index has a line a chart: name, tab, title; without it there is one chart."""
    try:
        lines = (folder / _INDEX).read_text(encoding="utf-8", errors="replace").splitlines()
    except OSError:
        return {_MAIN_CHART: ""}
    rows = [line.partition("\t") for line in lines]
    return {name: title.strip() for name, _, title in rows if _CHART_NAME.fullmatch(name)}


def _read_methods(path: Path) -> dict[str, bool]:
    """The methods of the chart, and whether they are written yet."""
    methods: dict[str, bool] = {}
    try:
        with open(path, encoding="utf-8", errors="replace", newline="") as rows:
            for row in csv.DictReader(rows):
                name = row.get("method") or ""
                if name:
                    written = row.get("status") != "not_implemented" and row.get("value") != ""
                    methods[name] = methods.get(name, False) or written
    except (OSError, csv.Error):
        pass
    return methods


def _command(lab: Lab, variant: str, kind: str, folder: Path) -> str:
    try:
        return command_file(folder).read_text(encoding="utf-8", errors="replace").strip()
    except OSError:
        return default_command(lab, variant, kind)


def _existing(path: Path) -> Optional[Path]:
    return path if path.is_file() else None


def _read_json(path: Path) -> dict[str, Any]:
    try:
        content = json.loads(path.read_text(encoding="utf-8", errors="replace"))
    except (OSError, ValueError):
        return {}
    return content if isinstance(content, dict) else {}


def _words(content: dict[str, Any], key: str) -> str:
    value = content.get(key)
    return value.strip() if isinstance(value, str) else ""


def _names(value: Any) -> list[str]:
    return [name for name in value if isinstance(name, str)] if isinstance(value, list) else []


def _number(value: Any, otherwise: float) -> float:
    good = isinstance(value, (int, float)) and math.isfinite(value) and value >= 0
    return float(value) if good else otherwise
