# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of the design loop: how the objective came on, what it owes to each variable, and what failed."""
import numpy as np

from .curves import Missing
from .data import Results
from .drawing import BLUE, FAINT, VERMILION, image, legend_beside, plt
from .units import label

MOST_VARIABLES = 6  # panels


def convergence(results: Results, name: str | None) -> str:
    """The response of each evaluation, the best so far, and the failed ones on a line of their own below."""
    evaluations = results.evaluations
    values = np.array([e.response(name) if e.ok else np.nan for e in evaluations])
    if not np.isfinite(values).any():
        raise Missing("no evaluation worked.")
    numbers = np.array([e.id for e in evaluations])
    admissible = np.array([results.admissible(e) for e in evaluations])
    figure, (axes, rug) = plt.subplots(2, sharex=True, figsize=(6.4, 4.0), height_ratios=(8, 1), layout="constrained")
    axes.plot(numbers[admissible], values[admissible], "o", color=BLUE, ms=6, label="evaluation")
    _outside(axes, numbers, np.where(admissible, np.nan, values))
    if results.objective:
        best = best_so_far(np.where(admissible, values, np.nan), results.goal_sign)
        axes.step(numbers, best, where="post", color=BLUE, lw=1.2, label="best so far")
    axes.set_ylabel(label(name))
    failed = _failed_below(rug, numbers[[e.failed for e in evaluations]])
    rug.set_xlabel("evaluation")
    rug.set_ylabel("failed", rotation=0, ha="right", va="center")
    rug.xaxis.get_major_locator().set_params(integer=True)
    legend_beside(axes)
    return image(figure, f"{name} over {len(evaluations)} evaluations, {failed} of them failed")


def over_variables(results: Results, name: str) -> str:
    """The response over each variable: one panel per variable, failed designs as crosses at the lower edge."""
    evaluations = [e for e in results.evaluations if e.design]
    keys = list(dict.fromkeys(key for e in evaluations for key in e.design))[:MOST_VARIABLES]
    if len(evaluations) < 2 or not keys:
        return ""
    values = np.array([e.response(name) if e.ok else np.nan for e in evaluations])
    admissible = np.array([results.admissible(e) for e in evaluations])
    figure, panels = plt.subplots(2, len(keys), sharex="col", sharey="row", height_ratios=(8, 1), squeeze=False,
                                  figsize=(min(2.2 + 2.4 * len(keys), 10), 3.2), layout="constrained")
    for (axes, rug), key in zip(panels.T, keys):
        places = np.array([_number(e.design.get(key)) for e in evaluations])
        axes.plot(places[admissible], values[admissible], "o", color=BLUE, ms=5)
        _outside(axes, places, np.where(admissible, np.nan, values))
        _failed_below(rug, places[[e.failed for e in evaluations]])
        unit = evaluations[0].units.get(key, "")
        rug.set_xlabel(key.split(".", 1)[-1].replace("_", " ") + (f"\n({unit})" if unit not in ("", "1") else ""))
        rug.xaxis.get_major_locator().set_params(nbins=4)
    panels[0, 0].set_ylabel(label(name).replace(" (", "\n("))
    panels[1, 0].set_ylabel("failed", rotation=0, ha="right", va="center")
    return image(figure, f"{name} over " + ", ".join(keys))


def _number(value) -> float:
    return float(value) if isinstance(value, (int, float)) else np.nan


def _outside(axes, places: np.ndarray, values: np.ndarray) -> None:
    if np.isfinite(values).any():
        axes.plot(places, values, "o", mfc="none", color=FAINT, ms=6, label="breaks a constraint")


def _failed_below(rug, places: np.ndarray) -> int:
    """Crosses where evaluations failed; how many."""
    rug.plot(places, np.zeros(len(places)), "x", color=VERMILION, ms=7)
    rug.set(yticks=[], ylim=(-1, 1))
    rug.grid(False)
    return len(places)


def best_so_far(values: np.ndarray, sign: int) -> np.ndarray:
    """The best value up to each evaluation; NaN before the first one that counts."""
    best = np.fmax.accumulate(sign * values)
    return sign * best
