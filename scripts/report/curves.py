# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of one path: each function returns an HTML image, or says in a sentence what is missing."""
import numpy as np
from matplotlib.patches import Patch

from .data import Evaluation, History
from .drawing import BLUE, COLOURS, FAINT, STAGE_TINTS, VERMILION, image, legend_beside, plt
from .events import events, first_passages, stages
from .units import label

PATH = ("pressure_kPa", "bending_angle_deg")
ALONG = ("pressure_kPa", "bending_angle_deg", "rib_contact_fraction", "max_bulge_mm")
# Columns with a figure of their own or of the bookkeeping; everything else in history.csv was named by the study.
KNOWN = {*ALONG, "step", "time", "control", "load_factor", "volume_mm3", "volume_ratio", "twist_deg",
         "out_of_plane_deg", "tip_x_mm", "tip_y_mm", "tip_z_mm", "tip_force_N", "head_force_N", "axial_ratio",
         "radial_ratio", "balloon_stress_max_MPa", "backbone_stress_max_MPa", "negative_eigenvalues",
         "newton_iterations", "dissipated_share", "kinetic_share", "cuts"}
DEGENERATE = 1e-9  # a colour scale needs some extent


class Missing(Exception):
    """Why a section has no figure; the page shows the sentence."""


def _need(history: History, *columns: str) -> None:
    absent = [column for column in columns if not history.has(column)]
    if absent:
        raise Missing("history.csv has no numbers in " + ", ".join(absent) + ".")


def pressure_angle(best: Evaluation, others: list[Evaluation]) -> str:
    """All paths faint, the best one bold with its events."""
    _need(best.history, *PATH)
    figure, axes = plt.subplots(figsize=(6.4, 4.2))
    drawn = 0
    for other in others:
        if other.id != best.id and other.history.has(*PATH):
            axes.plot(*(other.history.numbers[c] for c in PATH), color=FAINT, lw=0.8, alpha=0.6, rasterized=True,
                      label="" if drawn else "other evaluations")
            drawn += 1
    pressure, angle = (best.history.numbers[column] for column in PATH)
    axes.plot(pressure, angle, color=BLUE, lw=2.4, label=f"evaluation {best.id}")
    _mark_events(axes, best.history, pressure, angle)
    axes.set(xlabel="cavity pressure (kPa)", ylabel="bending angle (°)")
    axes.axhline(0, color="#77808A", lw=0.6)
    legend_beside(axes)
    return image(figure, f"Bending angle against pressure of evaluation {best.id} and {drawn} others")


def _mark_events(axes, history: History, x: np.ndarray, y: np.ndarray) -> None:
    markers = {"limit point": ("^", VERMILION), "stability lost": ("o", "#222222")}
    named: set[str] = set()
    for event in events(history):
        marker, colour = markers.get(event.name, ("s", COLOURS[3]))
        axes.plot(x[event.index], y[event.index], marker, color=colour, mec="white", ms=8, zorder=5,
                  label="" if event.name in named else event.name)
        named.add(event.name)


def along_path(history: History) -> str:
    """Pressure, angle, rib contact and bulge over the control, above bands that show the stages."""
    present = [column for column in ALONG if history.has(column)]
    if not present:
        raise Missing("history.csv has none of the columns " + ", ".join(ALONG) + ".")
    x, x_label = _path_axis(history)
    figure, rows = plt.subplots(len(present), sharex=True, figsize=(6.4, 1.5 * len(present) + 0.8), squeeze=False)
    for axes, column in zip(rows[:, 0], present):
        _stage_bands(axes, history, x)
        axes.plot(x, history.numbers[column], color=BLUE)
        axes.set_ylabel(label(column).replace(" (", "\n("))
    rows[-1, 0].set_xlabel(x_label)
    bands = list(dict.fromkeys(name for name, _, _ in stages(history)))
    if bands:
        legend_beside(rows[0, 0], handles=[Patch(color=_tint(name), label=name) for name in bands], title="stage")
    figure.align_ylabels()
    return image(figure, "Quantities along the path" + (", stages: " + ", ".join(bands) if bands else ""))


def _path_axis(history: History) -> tuple[np.ndarray, str]:
    if history.has("volume_ratio"):
        ratio = history.numbers["volume_ratio"]
        if np.all(np.diff(ratio) >= 0) and ratio[-1] > ratio[0]:
            return ratio, "cavity volume over its start value"
    for column in ("step", "control"):
        if history.has(column):
            return history.numbers[column], label(column)
    return np.arange(len(history)), "row of history.csv"


def _tint(stage: str) -> str:
    return STAGE_TINTS.get(stage, "#EEEEEE")


def _stage_bands(axes, history: History, x: np.ndarray) -> None:
    for name, first, last in stages(history):
        axes.axvspan(x[first], x[min(last + 1, len(x) - 1)], color=_tint(name), lw=0)


def gap_map(history: History) -> str:
    """Opening of every gap: left as a slow rise of the pressure would show it, right along the path itself."""
    gaps = history.gaps()
    if not gaps:
        raise Missing("history.csv has no columns gap_01_deg, gap_02_deg, ...")
    values = np.array([history.numbers[column] for column in gaps])
    limit = max(np.nanmax(np.abs(values)), DEGENERATE)
    style = {"cmap": "RdBu_r", "vmin": -limit, "vmax": limit, "aspect": "auto", "origin": "lower",
             "interpolation": "nearest"}
    figure, panels = plt.subplots(1, 2, figsize=(8.2, 4.0), sharey=True, layout="constrained")
    for axes in panels:
        axes.grid(False)
    _gaps_over_pressure(panels[0], history, values, style)
    drawn = panels[1].imshow(values, extent=(-0.5, values.shape[1] - 0.5, 0.5, len(gaps) + 0.5), **style)
    panels[1].set(xlabel="step", title="along the path")
    panels[0].set_ylabel("gap (1 = at the base)")
    panels[0].yaxis.get_major_locator().set_params(integer=True)
    figure.colorbar(drawn, ax=panels, label="gap opening (°)", pad=0.02)
    return image(figure, f"Opening of {len(gaps)} gaps over pressure and over steps; largest {limit:.1f} degrees")


def _gaps_over_pressure(axes, history: History, values: np.ndarray, style: dict) -> None:
    axes.set(xlabel="cavity pressure (kPa)", title="raising the pressure slowly")
    if not history.has("pressure_kPa"):
        axes.text(0.5, 0.5, "no pressure recorded", ha="center", transform=axes.transAxes)
        return
    pressure = history.numbers["pressure_kPa"]
    low, high = pressure[np.isfinite(pressure)][0], np.nanmax(pressure)
    if high - low < DEGENERATE:
        axes.text(0.5, 0.5, "the pressure does not rise", ha="center", transform=axes.transAxes)
        return
    rows = first_passages(pressure, np.linspace(low, high, 200))
    axes.imshow(values[:, rows[rows >= 0]], extent=(low, high, 0.5, len(values) + 0.5), **style)


def against_pressure(history: History, columns: dict[str, str], y_label: str, one_scale: bool = True) -> str:
    """Several columns (name: legend) over the pressure, in one panel or, where their scales differ, one panel each."""
    present = {column: name for column, name in columns.items() if history.has(column)}
    if not present:
        raise Missing("history.csv has no numbers in " + ", ".join(columns) + ".")
    _need(history, "pressure_kPa")
    panels = 1 if one_scale else len(present)
    figure, rows = plt.subplots(panels, sharex=True, figsize=(6.4, 3.4 if panels == 1 else 2.2 * panels), squeeze=False)
    for i, ((column, name), style) in enumerate(zip(present.items(), ("-", "--", ":", "-."))):
        axes = rows[min(i, panels - 1), 0]
        axes.plot(history.numbers["pressure_kPa"], history.numbers[column], style, color=COLOURS[i], label=name)
        axes.set_ylabel(y_label)
        legend_beside(axes)
    rows[-1, 0].set_xlabel("cavity pressure (kPa)")
    return image(figure, y_label + " against pressure: " + ", ".join(present.values()))


def responses_along_path(history: History, columns: list[str]) -> str:
    """Columns the user named, each over the control, in small panels."""
    figure, rows = plt.subplots(len(columns), sharex=True, figsize=(6.4, 1.6 * len(columns) + 0.8), squeeze=False)
    axis = "control" if history.has("control") else None
    x, x_label = (history.numbers[axis], axis) if axis else _path_axis(history)
    for axes, column, colour in zip(rows[:, 0], columns, COLOURS * len(columns)):
        axes.plot(x, history.numbers[column], ".-", color=colour, ms=4)
        axes.set_ylabel(label(column).replace(" (", "\n("))
    rows[-1, 0].set_xlabel(x_label)
    figure.align_ylabels()
    return image(figure, "Responses along the path: " + ", ".join(columns))
