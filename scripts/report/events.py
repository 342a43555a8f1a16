# SPDX-License-Identifier: LGPL-2.1-or-later
"""What happens along a path: limit points, loss of stability, stages."""
from dataclasses import dataclass

import numpy as np

from .history import History

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
    rows = np.flatnonzero(np.isfinite(pressure))
    extreme, rising = rows[0], True
    for i in rows:
        value, sign = pressure[i], 1 if rising else -1
        if sign * (value - pressure[extreme]) >= 0:
            extreme = i
        elif abs(value - pressure[extreme]) > tolerance:
            if rising:
                found.append(int(extreme))
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


def jumps(pressure: np.ndarray) -> list[tuple[int, int]]:
    """From and to which row a slowly raised pressure jumps: from a limit point to the next state of that pressure.

    Only limit points above all pressures before them are met that way; after the last one there may be no such state.
    """
    found = []
    for start in limit_points(pressure):
        later = np.flatnonzero(pressure[start + 1:] >= pressure[start])
        if len(later) and pressure[start] >= np.nanmax(pressure[:start + 1]):
            found.append((start, start + 1 + int(later[0])))
    return found
