# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure of the gaps between the ribs: which of them open, and when."""
import numpy as np

from .curves import ALONG, Missing, path_axis
from .drawing import BLUE, INK, image, plt
from .history import History


def gap_map(history: History) -> str:
    """Opening of every gap over the pressure; where that falls on the way, over the path with the pressure above."""
    gaps = history.gaps()
    if not gaps:
        raise Missing("history.csv has no columns gap_01_deg, gap_02_deg, ...")
    values = np.array([history.numbers[column] for column in gaps])
    if len(history) < 2:
        return _gap_bars(values[:, 0])
    x, x_label, rises = _gap_axis(history)
    figure, rows = plt.subplots(1 if rises else 2, sharex=True, squeeze=False, layout="constrained",
                                figsize=(6.8, 3.6 if rises else 4.8), height_ratios=[3] if rises else [1, 3])
    if not rises:
        rows[0, 0].plot(x, history.numbers["pressure_kPa"], color=BLUE)
        rows[0, 0].set_ylabel(ALONG["pressure_kPa"])
    axes = rows[-1, 0]
    axes.grid(False)
    limit = max(np.nanmax(np.abs(values)), 1e-9)
    drawn = axes.pcolormesh(_edges(x), np.arange(len(gaps) + 1) + 0.5, values, cmap="RdBu_r", vmin=-limit, vmax=limit,
                            rasterized=True)
    axes.set(xlabel=x_label, ylabel="gap (1 = at the base)")
    axes.yaxis.get_major_locator().set_params(integer=True)
    figure.colorbar(drawn, ax=axes, label="gap opening (°)", pad=0.02)
    return image(figure, f"Opening of {len(gaps)} gaps; largest {limit:.1f} degrees")


def _gap_axis(history: History) -> tuple[np.ndarray, str, bool]:
    """Places, their label, and whether nothing has to be said about the pressure beside."""
    if not history.has("pressure_kPa"):
        return *path_axis(history), True
    pressure = history.numbers["pressure_kPa"]
    if np.all(np.diff(pressure) >= 0) and pressure[-1] > pressure[0]:
        return pressure, "cavity pressure (kPa)", True
    return *path_axis(history), False


def _edges(places: np.ndarray) -> np.ndarray:
    """Borders of cells about the places: halfway between neighbours."""
    between = (places[1:] + places[:-1]) / 2
    return np.concatenate([places[:1], between, places[-1:]])


def _gap_bars(openings: np.ndarray) -> str:
    figure, axes = plt.subplots(figsize=(6.4, 3.2))
    axes.bar(np.arange(1, len(openings) + 1), openings, color=BLUE)
    axes.axhline(0, color=INK, lw=0.8)
    axes.set(xlabel="gap (1 = at the base)", ylabel="gap opening (°)")
    axes.xaxis.get_major_locator().set_params(integer=True)
    return image(figure, f"Opening of {len(openings)} gaps")
