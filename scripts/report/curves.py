# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of one path: each function returns an HTML image, or says in a sentence what is missing."""
import numpy as np
from matplotlib.patches import Patch

from .data import Evaluation
from .drawing import BLUE, COLOURS, EVENT_MARKS, FAINT, INK, STAGE_TINTS, VERMILION, image, legend_beside, plt
from .events import events, jumps, stages
from .history import History
from .units import label

PATH = ("pressure_kPa", "bending_angle_deg")
ALONG = {"pressure_kPa": "pressure\n(kPa)", "bending_angle_deg": "bending\nangle (°)",
         "rib_contact_fraction": "ribs touched\n(share)", "max_bulge_mm": "bulge beyond\nribs (mm)"}
NEGLIGIBLE = 1e-5  # in the column's unit: round-off of what is not there


class Missing(Exception):
    """Why a section has no figure; the page shows the sentence."""


def _need(history: History, *columns: str) -> None:
    absent = [column for column in columns if not history.has(column)]
    if absent:
        raise Missing("history.csv has no numbers in " + ", ".join(absent) + ".")
    if len(history) < 2:
        raise Missing("the path has one state only.")


def _present(history: History, columns: dict[str, str]) -> dict[str, str]:
    """Those columns that hold numbers, of a path that is long enough for a curve."""
    present = {column: name for column, name in columns.items() if history.has(column)}
    _need(history, *(present or columns))
    return present


def pressure_angle(best: Evaluation, others: list[Evaluation], window_end: float) -> str:
    """All paths faint, the best one bold with its events; `window_end` in kPa, NaN if there is none."""
    _need(best.history, *PATH)
    figure, axes = plt.subplots(figsize=(6.4, 4.4))
    others = [other for other in others if other.id != best.id and other.history.has(*PATH)]
    for i, other in enumerate(others):
        axes.plot(*(other.history.numbers[c] for c in PATH), color=FAINT, lw=0.9, alpha=0.8, rasterized=True,
                  label="" if i else "other evaluations")
    ends = [[other.history.numbers[c][-1] for c in PATH] for other in others if other.failed]
    if ends:
        axes.plot(*zip(*ends), "x", color=FAINT, label="failed there")
    pressure, angle = (best.history.numbers[column] for column in PATH)
    axes.plot(pressure, angle, color=BLUE, lw=2.4, label=f"evaluation {best.id}")
    for i, (start, end) in enumerate(jumps(pressure)):
        axes.plot(pressure[[start, end]], angle[[start, end]], ":", color=VERMILION,
                  label="" if i else "jump at slowly\nraised pressure")
    _mark_events(axes, best.history, pressure, angle)
    if np.isfinite(window_end):
        axes.axvline(window_end, color=INK, lw=0.8, ls="--", zorder=0, label="end of the\npressure window")
    axes.set(xlabel="cavity pressure (kPa)", ylabel="bending angle (°)")
    axes.axhline(0, color="#77808A", lw=0.6, zorder=0)
    legend_beside(axes)
    return image(figure, f"Bending angle against pressure of evaluation {best.id} and {len(others)} others")


def _mark_events(axes, history: History, x: np.ndarray, y: np.ndarray) -> None:
    named: set[str] = set()
    located = {event.index for event in events(history) if event.name.endswith("located")}
    for event in events(history):
        if event.name == "stability lost" and event.index in located:
            continue  # the located point says the same, and why
        marker, colour = EVENT_MARKS.get(event.name, ("s", COLOURS[3]))
        axes.plot(x[event.index], y[event.index], marker, color=colour, mec="white", ms=8, zorder=5,
                  label="" if event.name in named else event.name)
        named.add(event.name)


def along_path(history: History) -> str:
    """Pressure, angle, rib contact and bulge above bands that show the stages; events on the pressure."""
    present = _present(history, ALONG)
    figure, rows, x = _panels(history, present)
    for axes, column in zip(rows, present):
        _stage_bands(axes, history, x)
        if column == "rib_contact_fraction":
            axes.set_ylim(-0.05, 1.05)
    if "pressure_kPa" in present:
        _mark_events(rows[0], history, x, history.numbers["pressure_kPa"])
    bands = list(dict.fromkeys(name for name, _, _ in stages(history)))
    handles = [Patch(fc=_tint(name), ec="#B8BFC6", lw=0.5, label=name) for name in bands]
    if handles or events(history):
        legend_beside(rows[0], handles=handles + rows[0].get_legend_handles_labels()[0])
    return image(figure, "Quantities along the path" + (", stages: " + ", ".join(bands) if bands else ""))


def columns_along_path(history: History, columns: dict[str, str], scale: str = "linear") -> str:
    """Any columns (name: label) over the path, one panel each."""
    present = _present(history, columns)
    figure, rows, _ = _panels(history, present)
    for axes, column in zip(rows, present):
        if np.nanmax(history.numbers[column]) > 0:  # a scale of powers of ten has no zero
            axes.set_yscale(scale)
    return image(figure, "Along the path: " + ", ".join(columns))


def _panels(history: History, columns: dict[str, str]) -> tuple:
    """One panel per column over the path: the figure, its axes and the places on the path."""
    x, x_label = path_axis(history)
    figure, rows = plt.subplots(len(columns), sharex=True, figsize=(6.4, 1.5 * len(columns) + 0.8), squeeze=False)
    for axes, (column, name) in zip(rows[:, 0], columns.items()):
        axes.plot(x, history.numbers[column], color=BLUE, marker="." if len(history) < 30 else None)
        axes.set_ylabel(name)
    rows[-1, 0].set_xlabel(x_label)
    figure.align_ylabels()
    return figure, rows[:, 0], x


def path_axis(history: History) -> tuple[np.ndarray, str]:
    """What grows along the path, and its label."""
    if history.has("control") and np.array_equal(history.numbers["control"], history.numbers.get("time_s", [])):
        return history.numbers["time_s"], label("time_s")  # a body that is let go
    if history.has("volume_ratio"):
        ratio = history.numbers["volume_ratio"]
        if np.all(np.diff(ratio) >= 0) and ratio[-1] > ratio[0]:
            return ratio, "cavity volume over volume at rest (–)"
    for column in ("step", "control"):
        if history.has(column) and np.isfinite(history.numbers[column]).all():
            return history.numbers[column], label(column)
    return np.arange(len(history)), "row of history.csv"


def _tint(stage: str) -> str:
    return STAGE_TINTS.get(stage, "#EEEEEE")


def _stage_bands(axes, history: History, x: np.ndarray) -> None:
    for name, first, last in stages(history):
        axes.axvspan(x[first], x[min(last + 1, len(x) - 1)], color=_tint(name), lw=0)


def against_pressure(history: History, columns: dict[str, str], y_label: str, one_scale: bool = True) -> str:
    """Several columns (name: legend) over the pressure, in one panel or, where their scales differ, one panel each."""
    _need(history, "pressure_kPa")
    present = {column: name for column, name in _present(history, columns).items()
               if np.nanmax(np.abs(history.numbers[column])) > NEGLIGIBLE}
    if not present:
        raise Missing(f"{', '.join(columns)}: zero along the whole path.")
    panels = 1 if one_scale else len(present)
    figure, rows = plt.subplots(panels, sharex=True, figsize=(6.4, 3.4 if panels == 1 else 2.2 * panels), squeeze=False)
    for i, ((column, name), style) in enumerate(zip(present.items(), ("-", "--", ":", "-."))):
        axes = rows[min(i, panels - 1), 0]
        axes.plot(history.numbers["pressure_kPa"], history.numbers[column], style, color=COLOURS[i], label=name)
        axes.set_ylabel(y_label)
        legend_beside(axes)
    rows[-1, 0].set_xlabel("cavity pressure (kPa)")
    figure.align_ylabels()
    return image(figure, y_label + " against pressure: " + ", ".join(present.values()))
