"""out/index.html: every film and chart there is on one page, from the template page.html."""

from __future__ import annotations

import json
import os
import re
import urllib.parse
from html import escape
from pathlib import Path
from typing import Sequence

from .gallery import (CHART, FILM, REFERENCE, STUDENT, Chart, Film, LabPictures, default_command,
                      read_gallery)
from .labs import Lab, find_labs

_TEMPLATE = Path(__file__).with_name("page.html")
_WHOSE = {STUDENT: "Your answer", REFERENCE: "Reference"}


def _whose(variant: str) -> str:
    return _WHOSE.get(variant, f"Answer {variant}")


def write(root: Path, out: Path) -> Path:
    """Replaces the page in one move, so that a reader never meets half of one."""
    page = out / "index.html"
    draft = out / ".index.html.draft"
    draft.write_text(render(read_gallery(find_labs(root), out), out), encoding="utf-8",
                     errors="replace")
    os.replace(draft, page)
    return page


def render(gallery: Sequence[LabPictures], out: Path) -> str:
    shown = [pictures for pictures in gallery if pictures.films or pictures.charts]
    absent = [pictures.lab for pictures in gallery if not (pictures.films or pictures.charts)]
    links = "".join(f'<li><a href="#lab-{pictures.lab.number}">{pictures.lab.number}&ensp;'
                    f"{escape(_title(pictures.lab))}</a></li>" for pictures in shown)
    sections = "".join(_section(pictures, out) for pictures in shown)
    template = _TEMPLATE.read_text(encoding="utf-8")
    before, after = template.split("<!-- labs -->")
    return before + _contents(links) + sections + _still_to_make(absent) + after


def _contents(links: str) -> str:
    return f'<nav aria-label="Labs"><ol>{links}</ol></nav>\n' if links else ""


def _title(lab: Lab) -> str:
    return lab.title[:1].upper() + lab.title[1:]


def _section(pictures: LabPictures, out: Path) -> str:
    lab = pictures.lab
    parts = [f'<section class="lab" id="lab-{lab.number}" aria-labelledby="title-{lab.number}">',
             f'<header><p class="number">Lab {lab.number}</p>',
             f'<h2 id="title-{lab.number}">{escape(_title(lab))}</h2></header>']
    if pictures.films:
        parts += [_player(pictures.films, out), *(_strip(film, out) for film in pictures.films)]
    if pictures.charts:
        parts.append(_charts(lab, pictures.charts, out))
    return "\n".join(parts) + "\n</section>\n"


def _player(films: Sequence[Film], out: Path) -> str:
    """All variants of the scene under one slider: the same moment side by side."""
    head = next((film for film in films if film.title), films[0])
    parts = [f"<h3>{escape(head.title or 'Film')}</h3>"]
    if head.subtitle:
        parts.append(f'<p class="subtitle">{escape(head.subtitle)}</p>')
    parts.append(f'<div class="player of-{len(films)}" role="group" '
                 f'aria-label="Film: {escape(head.title, quote=True)}">\n'
                 '<div class="controls" hidden><button type="button" class="play">Play</button>'
                 '<input type="range" min="0" value="0" step="1" aria-label="Frame">'
                 '<output></output></div>')
    parts += [_stage(film, out) for film in films]
    return "\n".join(parts) + "\n</div>"


def _stage(film: Film, out: Path) -> str:
    frames = [_url(frame, out) for frame in film.frames]
    alt = f"{_whose(film.variant)}: a frame of the film {film.title}".strip()
    return (f'<figure data-frames="{escape(json.dumps(frames), quote=True)}" '
            f'data-fps="{film.fps:g}" data-start="{film.start:g}">\n'
            f'<div class="stage"><p class="whose">{_whose(film.variant)}</p>'
            f'<img src="{frames[0]}" alt="{escape(alt, quote=True)}"></div>\n'
            f'<figcaption><p class="whose">{_whose(film.variant)}</p>{_facts(film)}'
            f"{_command(film.command)}</figcaption>\n</figure>")


def _facts(film: Film) -> str:
    """Wide gaps part the facts in the strip's foot; here each has its own line."""
    lines = re.split(r"\s{2,}", f"{film.measured}  {film.parameters}")
    facts = "".join(f"<p>{escape(line.rstrip(';'))}</p>" for line in lines if line)
    return facts + _missing(film.missing)


def _strip(film: Film, out: Path) -> str:
    if not film.strip:
        return ""
    alt = f"Film strip of {film.title}. {film.subtitle} {film.measured}"
    url = _url(film.strip, out)
    return (f'<figure class="strip"><p class="whose">Film strip &middot; {_whose(film.variant)}</p>'
            f'<a href="{url}"><img src="{url}" loading="lazy" '
            f'alt="{escape(alt, quote=True)}"></a></figure>')


def _charts(lab: Lab, charts: Sequence[Chart], out: Path) -> str:
    """The same chart of all variants together; the command that draws them all stands once."""
    names = list(dict.fromkeys(chart.name for chart in charts))
    parts = [f'<h3>{"Charts" if len(names) > 1 else "Error against time"}</h3>']
    told: set[str] = set()
    for name in names:
        same = [chart for chart in charts if chart.name == name]
        if len(names) > 1:
            parts.append(f"<h4>{escape(same[0].title or name)}</h4>")
        parts.append('<div class="charts">')
        for chart in same:
            command = "" if chart.variant in told else _command(chart.command)
            told.add(chart.variant)
            parts.append(_chart(lab, chart, command, out))
        parts.append("</div>")
    return "\n".join(parts)


def _chart(lab: Lab, chart: Chart, command: str, out: Path) -> str:
    whose = _whose(chart.variant)
    if chart.image:
        url = _url(chart.image, out)
        title = chart.title or "error against time, both logarithmic"
        alt = f"{whose}, lab {lab.number}: {title}, of {', '.join(chart.methods)}"
        picture = (f'<a class="card" href="{url}"><img src="{url}" loading="lazy" '
                   f'alt="{escape(alt, quote=True)}"></a>')
    else:
        picture = '<p class="card empty">Measured but not drawn, because gnuplot is missing.</p>'
    files = ", ".join(f'<a href="{_url(file, out)}">{escape(file.name)}</a>'
                      for file in chart.files)
    return (f'<figure><p class="whose">{whose}</p>{picture}\n<figcaption>{_missing(chart.missing)}'
            f"<p>{files}</p>{command}</figcaption></figure>")


def _missing(names: Sequence[str]) -> str:
    if not names:
        return ""
    return (f'<p class="missing">Left out, because not written yet or broken: '
            f'{escape(", ".join(names))}</p>')


def _command(command: str) -> str:
    return ('<p class="command"><code>' + escape(command) + "</code>"
            '<button type="button" class="copy" hidden>Copy</button></p>')


def _still_to_make(labs: Sequence[Lab]) -> str:
    """The labs without a picture, and how to get one."""
    if not labs:
        return ""
    rows = "".join(f"<li>{escape(lab.heading)}{_command(default_command(lab, STUDENT, FILM))}"
                   f"{_command(default_command(lab, STUDENT, CHART))}</li>" for lab in labs)
    return f'<section class="absent"><h2>Not drawn yet</h2><ul>{rows}</ul></section>\n'


def _url(path: Path, out: Path) -> str:
    return urllib.parse.quote(path.relative_to(out).as_posix())
