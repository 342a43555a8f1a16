# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of the page."""
import html

from .data import Evaluation, Results
from .units import label, number, unit_of

LARGEST_TABLE = 500  # rows; longer journals show the last ones
SHOWN_RESPONSES = 6


def _row(cells: list, tag: str = "td", kind: str = "") -> str:
    """Cells are words, or (words, css class)."""
    pairs = [cell if isinstance(cell, tuple) else (cell, "") for cell in cells]
    inner = "".join(f"<{tag}{_class(css)}>{html.escape(str(text))}</{tag}>" for text, css in pairs)
    return f"<tr{_class(kind)}>{inner}</tr>"


def _class(name: str) -> str:
    return f' class="{name}"' if name else ""


def fact_table(facts: dict[str, str]) -> str:
    return "<table>" + "".join(_row([name, value]) for name, value in facts.items()) + "</table>"


def design_table(evaluation: Evaluation) -> str:
    """Variables of the design with their units; nothing if the study varies nothing."""
    design, units = evaluation.entry.get("design") or {}, evaluation.entry.get("units") or {}
    if not design:
        return ""
    rows = [_row([key, (number(value), "number"), _unit(units, key)]) for key, value in design.items()]
    return f"<table>{_row(['variable', ('value', 'number'), 'unit'], 'th')}{''.join(rows)}</table>"


def response_table(evaluation: Evaluation) -> str:
    responses, units = evaluation.entry.get("responses") or {}, evaluation.entry.get("units") or {}
    if not responses:
        return '<p class="missing">No responses recorded.</p>'
    rows = [_row([name, (number(value), "number"), _unit(units, name)]) for name, value in responses.items()]
    return f"<table>{_row(['response', ('value', 'number'), 'unit'], 'th')}{''.join(rows)}</table>"


def _unit(units: dict, name: str) -> str:
    unit = units.get(name, unit_of(name))
    return "" if unit == "1" else unit


def evaluations_table(results: Results) -> str:
    """One row per evaluation: status, reason, time, design and the first responses."""
    shown = results.evaluations[-LARGEST_TABLE:]
    variables = list(dict.fromkeys(key for e in shown for key in e.entry.get("design") or {}))
    responses = _responses_to_show(results, shown)
    units = next((e.entry["units"] for e in shown if e.entry.get("units")), {})
    titles = [(_titled(key.split(".", 1)[-1], units.get(key, "")), "number") for key in variables]
    titles += [(label(name), "number") for name in responses]
    head = _row(["number", "status", *titles, ("time (s)", "number"), "reason"], "th")
    rows = [_evaluation_row(e, variables, responses, results) for e in shown]
    cut = len(shown) < len(results.evaluations)
    note = f'<p class="note">The last {len(shown)} of {len(results.evaluations)}.</p>' if cut else ""
    return f'{note}<div class="wide"><table>{head}{"".join(rows)}</table></div>'


def _titled(name: str, unit: str) -> str:
    return f"{name} ({unit})" if unit and unit != "1" else name


def _responses_to_show(results: Results, shown: list[Evaluation]) -> list[str]:
    objective = (results.summary.get("objective") or {}).get("response")
    named = list(dict.fromkeys(name for e in shown for name in e.entry.get("responses") or {}))
    return sorted(named, key=lambda name: name != objective)[:SHOWN_RESPONSES]  # the objective first


def _evaluation_row(evaluation: Evaluation, variables: list[str], responses: list[str], results: Results) -> str:
    entry = evaluation.entry
    values = [(entry.get("design") or {}).get(key) for key in variables]
    values += [(entry.get("responses") or {}).get(name) for name in responses]
    cells = [(number(value), "number") for value in [*values, entry.get("seconds")]]
    kind = "failed" if not evaluation.ok else "best" if evaluation.id == results.named_best else ""
    return _row([evaluation.id, entry.get("status", ""), *cells, entry.get("reason", "")], kind=kind)
