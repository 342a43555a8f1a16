# SPDX-License-Identifier: LGPL-2.1-or-later
"""What happens along a path: limit points, loss of stability, stages."""
from dataclasses import dataclass

import numpy as np

from .data import History

SMALLEST_DROP = 0.02  # of the largest pressure: smaller dips are no limit points but noise of the steps


@dataclass
class Event:
    """Something worth a mark in a curve."""

    index: int  # row of the history
    name: str


def limit_points(pressure: np.ndarray, smallest_drop: float = SMALLEST_DROP) -> list[int]:
    """Rows of the local pressure maxima that are followed by a drop of at least that share of the largest pressure."""
    found: list[int] = []
    if not np.isfinite(pressure).any():
        return found
    tolerance = smallest_drop * np.nanmax(np.abs(pressure))
    extreme, rising = 0, True
    for i, value in enumerate(pressure):
        sign = 1 if rising else -1
        if sign * (value - pressure[extreme]) >= 0:
            extreme = i
        elif abs(value - pressure[extreme]) > tolerance:
            if rising:
                found.append(extreme)
            extreme, rising = i, not rising
    return found


def events(history: History) -> list[Event]:
    """All events of a path in order."""
    found = [Event(i, "limit point") for i in limit_points(history.numbers.get("pressure_kPa", np.array([])))]
    pivots = history.numbers.get("negative_eigenvalues", np.array([]))
    found += [Event(i + 1, "stability lost") for i in np.flatnonzero((pivots[:-1] == 0) & (pivots[1:] > 0))]
    found += [Event(i, word) for i, word in enumerate(history.words.get("event", [])) if word]
    return sorted(found, key=lambda event: event.index)


def stages(history: History) -> list[tuple[str, int, int]]:
    """Runs of equal words in the column `stage`: name, first row, last row."""
    runs: list[tuple[str, int, int]] = []
    for i, name in enumerate(history.words.get("stage", [])):
        if runs and runs[-1][0] == name:
            runs[-1] = (name, runs[-1][1], i)
        else:
            runs.append((name, i, i))
    return [run for run in runs if run[0]]


def first_passages(pressure: np.ndarray, levels: np.ndarray) -> np.ndarray:
    """For each level the first row whose running maximum of the pressure reaches it: what a slow rise would show.

    Levels that are never reached give -1.
    """
    highest = np.maximum.accumulate(np.nan_to_num(pressure, nan=-np.inf))
    rows = np.searchsorted(highest, levels, side="left")
    return np.where(rows < len(pressure), rows, -1)
