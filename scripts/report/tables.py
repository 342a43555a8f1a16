# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of the page."""
import html
import re

from .data import Evaluation, Results
from .units import duration, label, number, unit_of

LARGEST_TABLE = 500  # rows; longer journals show the last ones
SHOWN_RESPONSES = 5
KEY_RESPONSES = ("window_angle_deg", "bending_angle_deg", "pressure_kPa_max", "rib_contact_fraction",
                 "balloon_stress_max_MPa_max", "backbone_stress_max_MPa_max")


def table(titles: list, rows: list, kinds: dict[int, str] | None = None) -> str:
    """Cells are words, or (words, css class); `kinds` gives rows a class. Scrolls sideways if it is too wide."""
    head = _row(titles, "th") if titles else ""
    body = "".join(_row(cells, kind=(kinds or {}).get(i, "")) for i, cells in enumerate(rows))
    return f'<div class="wide"><table>{head}{body}</table></div>'


def _row(cells: list, tag: str = "td", kind: str = "") -> str:
    pairs = [cell if isinstance(cell, tuple) else (cell, "") for cell in cells]
    inner = "".join(f"<{tag}{_class(css)}>{html.escape(str(text))}</{tag}>" for text, css in pairs)
    return f"<tr{_class(kind)}>{inner}</tr>"


def _class(name: str) -> str:
    return f' class="{name}"' if name else ""


def _unit(units: dict, name: str) -> str:
    unit = units.get(name, unit_of(name))
    return "" if unit == "1" else unit


def design_table(results: Results, evaluation: Evaluation) -> str:
    """Variables of the design with their units and ranges; nothing if the study varies nothing."""
    if not evaluation.design:
        return ""
    ranges = {v.get("key"): _range(v) for v in results.settings.get("variable", [])}
    rows = [[key, (number(value), "number"), _unit(evaluation.units, key), ranges.get(key, "")]
            for key, value in evaluation.design.items()]
    return table(["variable", ("value", "number"), "unit", "searched"], rows)


def _range(variable: dict) -> str:
    if variable.get("values"):
        return "one of " + ", ".join(str(value) for value in variable["values"])
    return f"{variable['min']} … {variable['max']}" if {"min", "max"} <= variable.keys() else ""


def responses_table(evaluation: Evaluation) -> str:
    """Every response: at the end of the path, and where recorded its extremes along the path."""
    values, units = evaluation.responses, evaluation.units
    names = [name for name in values if not (re.search("_(max|min)$", name) and name[:-4] in values)]
    rows = [[name, *((number(values[key]) if key in values else "", "number") for key in
                     (name, name + "_min", name + "_max")), _unit(units, name)] for name in names]
    return table(["response", ("last state", "number"), ("smallest", "number"), ("largest", "number"), "unit"], rows)


def criteria_table(evaluation: Evaluation) -> str:
    """What the class of the path was decided by; what is not met is marked."""
    criteria = evaluation.judgement.get("criteria") or []
    rows = [[c.get("what", ""), (number(c.get("value")), "number"), "at most" if c.get("at_most") else "at least",
             (number(c.get("limit")), "number"), c.get("unit", ""), (number(c.get("margin")), "number"),
             str(c.get("class", "")).replace("_", " ")] for c in criteria]
    kinds = {i: "failed" for i, c in enumerate(criteria) if (c.get("margin") or 0) < 0}
    titles = ["criterion", ("value", "number"), "", ("limit", "number"), "unit", ("margin", "number"), "else"]
    return table(titles, rows, kinds)


def evaluations_table(results: Results) -> str:
    """One row per evaluation: status, time, design and the first responses."""
    shown = results.evaluations[-LARGEST_TABLE:]
    variables = list(dict.fromkeys(key for e in shown for key in e.design))
    responses = shown_responses(results)
    units = next((e.units for e in shown if e.units), {})
    titles = [(_titled(key.split(".", 1)[-1], units.get(key, "")), "number") for key in variables]
    titles += [(label(name), "number") for name in responses]
    rows = [_evaluation_row(e, variables, responses) for e in shown]
    kinds = {i: _kind(e, results) for i, e in enumerate(shown)}
    cut = len(shown) < len(results.evaluations)
    note = f'<p class="note">The last {len(shown)} of {len(results.evaluations)}.</p>' if cut else ""
    return note + table(["number", "status", *titles, ("time", "number")], rows, kinds)


def _evaluation_row(evaluation: Evaluation, variables: list[str], responses: list[str]) -> list:
    ending = evaluation.judgement.get("class", "ok") if evaluation.ok else evaluation.status
    values = [evaluation.design.get(key) for key in variables] + [evaluation.responses.get(name) for name in responses]
    cells = [*(number(value) for value in values), duration(evaluation.entry.get("seconds"))]
    return [evaluation.id, ending.replace("_", " "), *((text, "number") for text in cells)]


def _kind(evaluation: Evaluation, results: Results) -> str:
    if evaluation.ok and results.objective and evaluation is results.best:
        return "best"
    return "failed" if evaluation.failed else ""


def _titled(name: str, unit: str) -> str:
    return f"{name} ({unit})" if unit and unit != "1" else name


def shown_responses(results: Results) -> list[str]:
    """The objective and the constraints, then what matters most, then the responses the study names."""
    recorded = {name for e in results.evaluations for name, value in e.responses.items() if value is not None}
    wanted = [results.objective.get("response"), *(limit.get("response") for limit in results.constraints),
              *KEY_RESPONSES, *results.own_responses()]
    return [name for name in dict.fromkeys(wanted) if name in recorded][:SHOWN_RESPONSES]
