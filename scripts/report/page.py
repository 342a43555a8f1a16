# SPDX-License-Identifier: LGPL-2.1-or-later
"""Puts the page together: one function per section, in the order of the page."""
import html
from collections.abc import Callable
from pathlib import Path

from . import models, sections
from .answer import headline, study_name
from .curves import Missing
from .data import Results

HERE = Path(__file__).parent

# anchor, title, what makes the section
SECTIONS: list[tuple[str, str, Callable[[Results], str]]] = [
    ("shape", "The deformed actuator", sections.shapes),
    ("curve", "Bending angle against pressure", sections.pressure_angle),
    ("path", "Along the path", sections.along_path),
    ("responses", "Responses of this study along the path", sections.responses),
    ("gaps", "Opening of the gaps", sections.gap_map),
    ("expansion", "Expansion of the balloon", sections.expansion),
    ("stress", "Largest stresses", sections.stress),
    ("force", "Forces", sections.force),
    ("judgement", "How the path is judged", sections.judgement),
    ("models", "The two models", models.models),
    ("loop", "The design loop", sections.progress),
    ("numerics", "How the path was computed", sections.numerics),
    ("reproduce", "How to repeat this", sections.reproduce),
    ("all", "All responses", sections.all_responses),
]


def page(results: Results) -> str:
    """The whole report as one HTML text that needs no other file."""
    title = html.escape(study_name(results))
    contents, missing = _contents(results)
    links = "".join(f'<a href="#{anchor}">{name}</a>' for anchor, name in contents)
    body = "\n".join([*contents.values(), _not_shown(missing)])
    return (
        f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f'<meta name="viewport" content="width=device-width, initial-scale=1">\n<title>{title} – Ballonet</title>\n'
        f"<style>\n{(HERE / 'style.css').read_text()}</style>\n</head>\n<body>\n"
        f"<header>{headline(results)}</header>\n<nav>{links}</nav>\n<main>{body}</main>\n"
        f"{_viewer_script(body)}</body>\n</html>\n"
    )


def _contents(results: Results) -> tuple[dict[tuple[str, str], str], dict[str, str]]:
    """The sections that have something to show, by anchor and title, and for the others why they have not."""
    contents, missing = {}, {}
    for anchor, title, make in SECTIONS:
        try:
            contents[anchor, title] = f'<section id="{anchor}"><h2>{title}</h2>\n{make(results)}</section>'
        except Missing as reason:
            missing[title] = str(reason)
    return contents, missing


def _not_shown(missing: dict[str, str]) -> str:
    if not missing:
        return ""
    titles: dict[str, list[str]] = {}
    for title, reason in missing.items():
        titles.setdefault(reason, []).append(title)
    items = "".join(f"<li>{', '.join(names)}: {html.escape(reason)}</li>" for reason, names in titles.items())
    return f'<section id="missing"><h2>Not in these results</h2><ul class="missing">{items}</ul></section>'


def _viewer_script(body: str) -> str:
    """The viewer's program, if the page holds shapes for it."""
    parts = ("viewer_shapes.js", "viewer_scene.js", "viewer.js")
    program = "".join((HERE / part).read_text() for part in parts)
    return f"<script>\n{program}</script>\n" if 'id="shapes"' in body else ""
