# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path of one evaluation (history.csv)."""
import csv
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np


@dataclass
class History:
    """The path of one evaluation: one entry per step in every column."""

    numbers: dict[str, np.ndarray] = field(default_factory=dict)
    words: dict[str, list[str]] = field(default_factory=dict)

    def has(self, *names: str) -> bool:
        """Whether all these columns are there and hold at least one number each."""
        return all(name in self.numbers and np.isfinite(self.numbers[name]).any() for name in names)

    def __len__(self) -> int:
        return max((len(column) for column in (*self.numbers.values(), *self.words.values())), default=0)

    def gaps(self) -> list[str]:
        """The columns gap_01_deg, gap_02_deg, ... that hold numbers, from the base upwards."""
        return sorted(name for name in self.numbers if name.startswith("gap_") and self.has(name))


def read_history(path: Path) -> History:
    """Reads history.csv; a row cut short by a crash is left out."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            header, *rows = list(csv.reader(file)) or [[]]
    except OSError:
        return History()
    rows = [row for row in rows if len(row) == len(header)]
    history = History()
    for name, column in zip((name.strip() for name in header), zip(*rows)):
        try:
            numbers = np.array([float(value) if value.strip() else np.nan for value in column])
            history.numbers[name] = np.where(np.isfinite(numbers), numbers, np.nan)
        except ValueError:
            history.words[name] = [value.strip() for value in column]
    return history


# Kinds of critical points that are marked in the curves, and what they are called there.
CRITICAL_MARKS = {"limit_point": "limit point, located", "volume_limit": "volume turns, located",
                  "bifurcation": "bifurcation, located"}


def marked(history: History, critical_points: list[dict]) -> History:
    """The history with a column of events: the critical points of the journal, each in the row of its step."""
    steps = {int(step): row for row, step in enumerate(history.numbers.get("step", [])) if np.isfinite(step)}
    found = [(steps[int(point["step"])], CRITICAL_MARKS[point["kind"]]) for point in critical_points
             if point.get("kind") in CRITICAL_MARKS and point.get("step") in steps]
    if found:
        words = history.words.setdefault("event", [""] * len(history))
        for row, word in found:
            words[row] = word
    return history
