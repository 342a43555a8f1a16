# SPDX-License-Identifier: LGPL-2.1-or-later
"""The simulation and the reduced model side by side, for studies that ask both."""
import re

import numpy as np

from .curves import Missing
from .data import Evaluation, Results
from .tables import table
from .units import bare, number, unit_of

PREFIX = "reduced_"
ROUND_OFF = 1e-6  # in the response's unit: what is not there


def models(results: Results) -> str:
    """The responses in which the two models differ, for the evaluation shown, and in how many evaluations they do."""
    best = results.best
    if best is None or not any(name.startswith(PREFIX) for name in best.responses):
        raise Missing("the study asks one model only.")
    both = [name[len(PREFIX):] for name in best.responses if name.startswith(PREFIX)]
    rows = [_row(results, best, name) for name in both if _differs(best, name) and not _of_one_gap(name)]
    if not rows:
        return f"<p>The models agree within 5 % in all {len(both)} responses.</p>"
    titles = ["response", ("simulation", "number"), ("reduced model", "number"), "unit", ("evaluations that differ", "number")]
    note = f"More than 5 % apart, of {len(both)} responses; single gaps are left out."
    return table(titles, rows) + f'<p class="note">{note}</p>'


def _row(results: Results, best: Evaluation, name: str) -> list:
    count = sum(_differs(e, name) for e in results.evaluations)
    values = [(number(v) if np.isfinite(v) else "none", "number") for v in _pair(best, name)]
    return [bare(name), *values, unit_of(name), (f"{count} of {len(results.evaluations)}", "number")]


def _pair(evaluation: Evaluation, name: str) -> tuple[float, float]:
    return evaluation.response(name), evaluation.response(PREFIX + name)


def _differs(evaluation: Evaluation, name: str) -> bool:
    fem, reduced = _pair(evaluation, name)
    if not (np.isfinite(fem) and np.isfinite(reduced)):
        return bool(np.isfinite(fem) != np.isfinite(reduced))
    return abs(fem - reduced) > max(ROUND_OFF, 0.05 * max(abs(fem), abs(reduced)))


def _of_one_gap(name: str) -> bool:
    return re.match(r"gap_\d+_deg", name) is not None
