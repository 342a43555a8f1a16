# SPDX-License-Identifier: LGPL-2.1-or-later
"""A handful of results of one evaluation, each with what it means."""
import numpy as np

from .data import Evaluation, Results
from .events import events, jumps, limit_points, stages
from .units import bare, number, quantity, unit_of

STAGE_MEANINGS = {
    "separation": "the balloon does not press on the head yet",
    "insufficient": "the balloon presses on the head but touches few ribs",
    "sufficient": "the balloon touches nearly all ribs",
    "excessive": "the balloon bulges out between the ribs by a rib's thickness or more",
}
LARGE_SHARE = 0.05  # of viscous or kinetic energy: above it a state is called no equilibrium
Fact = tuple[str, str, str]  # name, value with unit, meaning


def facts(results: Results, shown: Evaluation) -> list[Fact]:
    """The results worth knowing first; only those that were recorded."""
    makers = (_objective, _judged, _angles, _pressures, _instabilities, _stage, _own, _stresses, _penetration, _shares)
    return [fact for make in makers for fact in make(results, shown)]


def _objective(results: Results, shown: Evaluation) -> list[Fact]:
    name = results.objective.get("response")
    if not name or name == "window_angle_deg" or name not in shown.responses:
        return []
    return [(bare(name), quantity(shown.response(name), unit_of(name)), "the objective of this study")]


def _judged(results: Results, shown: Evaluation) -> list[Fact]:
    name = shown.judgement.get("class")
    return [("class of the path", name.replace("_", " "), shown.judgement.get("reason", ""))] if name else []


def _angles(results: Results, shown: Evaluation) -> list[Fact]:
    window, end = shown.response("window_angle_deg"), shown.response("bending_angle_deg")
    window_end = 1e3 * results.quantity("judge", "window_max")
    rows = []
    if np.isfinite(window):
        meaning = "bending angle when the pressure, raised slowly, reaches the end of its window"
        if shown.response("pressure_kPa_max") < window_end:
            meaning = "bending angle of the last state: the path ends before the pressure is at the end of its window"
        rows.append(("window angle", quantity(window, "°"), f"{meaning} ({quantity(window_end, 'kPa')})"))
    if np.isfinite(end) and end != window:
        rows.append(("angle at the end", quantity(end, "°"),
                     "bending angle of the last state; positive towards the wall"))
    return rows


def _pressures(results: Results, shown: Evaluation) -> list[Fact]:
    pressure = shown.history.numbers.get("pressure_kPa", np.array([]))
    if not np.isfinite(pressure).any():
        return []
    peak = int(np.nanargmax(pressure))
    rows = [("pressure peak", quantity(pressure[peak], "kPa"),
             "largest cavity pressure on the path" + _at(shown, peak))]
    ends = dict(jumps(pressure))
    for i, row in enumerate(limit_points(pressure), 1):
        to = ("; raised slowly, it jumps from here to the path's next state of that pressure" + _at(shown, ends[row])
              if row in ends else "")
        rows.append((f"limit pressure {i}", quantity(pressure[row], "kPa"),
                     f"the pressure falls after it{_at(shown, row)}{to}"))
    return rows


def _at(shown: Evaluation, row: int) -> str:
    """`, at V/V₀ 2.37, 12°`: where on the path a row is."""
    numbers = shown.history.numbers
    parts = [f"V/V₀ {number(numbers['volume_ratio'][row])}"] if shown.history.has("volume_ratio") else []
    if shown.history.has("bending_angle_deg"):
        parts.append(quantity(round(numbers["bending_angle_deg"][row], 1), "°"))
    return ", at " + ", ".join(parts) if parts else ""


def _instabilities(results: Results, shown: Evaluation) -> list[Fact]:
    lost = [event.index for event in events(shown.history) if event.name == "stability lost"]
    if not lost or not shown.history.has("pressure_kPa"):
        return []
    pressure = quantity(shown.history.numbers["pressure_kPa"][lost[0]], "kPa")
    return [("stability lost", pressure, "first state that would run away at held pressure" + _at(shown, lost[0]))]


def _stage(results: Results, shown: Evaluation) -> list[Fact]:
    runs = stages(shown.history)
    return [("stage reached", runs[-1][0], STAGE_MEANINGS.get(runs[-1][0], ""))] if runs else []


def _own(results: Results, shown: Evaluation) -> list[Fact]:
    names = [name for name in results.own_responses() if name in shown.responses]
    return [(bare(name), quantity(shown.response(name), unit_of(name)), "named in the study; last state")
            for name in names[:6]]


def _stresses(results: Results, shown: Evaluation) -> list[Fact]:
    values = [(body, shown.response(f"{body}_stress_max_MPa_max")) for body in ("balloon", "backbone")]
    return [(f"stress in the {body}", quantity(value, "MPa"), "largest von Mises stress on the path")
            for body, value in values if value > 0]


def _penetration(results: Results, shown: Evaluation) -> list[Fact]:
    if results.reduced:
        return []
    limit = results.quantity("contact", "penetration_limit")
    rule = f"a step that ends deeper than {quantity(limit, 'mm')} is rejected" if np.isfinite(limit) else ""
    columns = [name for name in shown.history.numbers if "penetration" in name and shown.history.has(name)]
    if columns:
        deepest = max(float(np.nanmax(shown.history.numbers[name])) for name in columns)
        return [("contact penetration", quantity(deepest, "mm"), "deepest on the path; " + rule)]
    touched = shown.history.has("rib_contact_fraction") and shown.history.has("pressure_kPa")
    if not rule or not touched:
        return []
    return [("contact penetration", f"≤ {quantity(limit, 'mm')}", rule + "; the depth is not recorded")]


def _shares(results: Results, shown: Evaluation) -> list[Fact]:
    meanings = {"dissipated_share": ("viscous share", "of the energy that a step moved went into viscosity, at most"),
                "kinetic_share": ("kinetic share", "of the stored energy was motion, at most")}
    rows = []
    for column, (name, meaning) in meanings.items():
        if shown.history.has(column):
            shares = shown.history.numbers[column]
            worst = int(np.nanargmax(shares))
            far = (f"{_at(shown, worst)}: no equilibrium there, but half of the steps have "
                   f"{_percent(np.nanmedian(shares))} or less")
            calm = ": small on the whole path"
            rows.append((name, _percent(shares[worst]), meaning + (far if shares[worst] > LARGE_SHARE else calm)))
    return rows


def _percent(share: float) -> str:
    return "< 0.1 %" if share < 1e-3 else f"{100 * share:.2g} %"
