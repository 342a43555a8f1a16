# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure of the design loop: how the objective came on, and which evaluations failed."""
import numpy as np

from .curves import Missing
from .data import Evaluation
from .drawing import BLUE, FAINT, VERMILION, image, legend_beside, plt
from .units import label


def convergence(evaluations: list[Evaluation], objective: dict) -> str:
    """The objective of each evaluation, the best so far, and the failed ones on a line of their own below."""
    if not objective.get("response"):
        raise Missing("This study has no objective.")
    name = objective["response"]
    values = np.array([e.response(name) if e.ok else np.nan for e in evaluations])
    if not np.isfinite(values).any():
        raise Missing(f"No evaluation has the response {name}.")
    admissible = np.array([e.entry.get("feasible", True) for e in evaluations], bool)
    numbers = np.array([e.id for e in evaluations])
    figure, (axes, rug) = plt.subplots(2, sharex=True, figsize=(6.4, 4.0), height_ratios=(8, 1), layout="constrained")
    axes.plot(numbers[admissible], values[admissible], "o", color=BLUE, ms=5, alpha=0.7, label="evaluation")
    if not admissible.all():
        axes.plot(numbers[~admissible], values[~admissible], "o", mfc="none", color=FAINT, ms=5,
                  label="breaks a constraint")
    best = best_so_far(np.where(admissible, values, np.nan), goal_sign(objective))
    axes.step(numbers, best, where="post", color=BLUE, label="best so far")
    axes.set_ylabel(label(name))
    legend_beside(axes)
    failed = [e.id for e in evaluations if not e.ok]
    rug.plot(failed, np.zeros(len(failed)), "x", color=VERMILION, ms=7)
    rug.set(yticks=[], xlabel="evaluation", ylim=(-1, 1))
    rug.set_ylabel("failed", rotation=0, ha="right", va="center")
    rug.grid(False)
    rug.xaxis.get_major_locator().set_params(integer=True)
    return image(figure, f"{name} over {len(evaluations)} evaluations, {len(failed)} of them failed")


def goal_sign(objective: dict) -> int:
    """+1 if larger is better, -1 if smaller is better."""
    return 1 if str(objective.get("goal", "")).startswith("max") else -1


def best_so_far(values: np.ndarray, sign: int) -> np.ndarray:
    """The best value up to each evaluation; NaN before the first one that counts."""
    best = np.fmax.accumulate(sign * values)
    return sign * best
