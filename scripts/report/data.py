# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a results directory holds, read without Ballonet. Missing or torn files give empty data, never an error."""
import csv
import functools
import json
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from .surface import Surface, read_surface


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


@dataclass
class Evaluation:
    """One line of the journal and the folder that belongs to it."""

    entry: dict
    folder: Path

    @property
    def id(self) -> int:
        return self.entry.get("id", 0)

    @property
    def ok(self) -> bool:
        return self.entry.get("status") == "ok"

    def response(self, name: str) -> float:
        """The response as a number; NaN if the evaluation has none of that name."""
        value = self.entry.get("responses", {}).get(name)
        return float(value) if isinstance(value, (int, float)) else float("nan")

    @functools.cached_property
    def history(self) -> History:
        return read_history(self.folder / "history.csv")

    @functools.cached_property
    def surface(self) -> Surface | None:
        return read_surface(self.folder / "history.h5")


@dataclass
class Results:
    """The whole directory."""

    folder: Path
    summary: dict
    evaluations: list[Evaluation]
    unreadable_lines: int
    resolved: str

    @property
    def named_best(self) -> int | None:
        """The evaluation the summary calls the best; None if it names none."""
        return (self.summary.get("best") or {}).get("id")

    @functools.cached_property
    def best(self) -> Evaluation | None:
        """The best evaluation; where the summary names none, the last one that worked, else the last one at all."""
        named = [e for e in self.evaluations if e.id == self.named_best]
        working = [e for e in self.evaluations if e.ok]
        candidates = named or working or self.evaluations
        return candidates[-1] if candidates else None


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
            history.numbers[name] = np.array([float(value) if value.strip() else np.nan for value in column])
        except ValueError:
            history.words[name] = [value.strip() for value in column]
    return history


def read_journal(path: Path) -> tuple[dict[int, dict], int]:
    """Entries by evaluation number (the last line of a number counts) and how many lines could not be read."""
    entries: dict[int, dict] = {}
    unreadable = 0
    for line in _text(path).splitlines():
        if not line.strip():
            continue
        try:
            entry = json.loads(line)
            entries[int(entry["id"])] = entry
        except (ValueError, KeyError, TypeError):
            unreadable += 1
    return entries, unreadable


def read_results(folder: Path) -> Results:
    """Reads everything the report shows except the histories and surfaces, which are read when first asked for."""
    entries, unreadable = read_journal(folder / "journal.jsonl")
    for found in sorted((folder / "evaluations").glob("[0-9]*")):  # begun but not yet in the journal
        if found.name.isdigit():
            entries.setdefault(int(found.name), {"id": int(found.name), "status": "unfinished"})
    evaluations = [Evaluation(entries[i], folder / "evaluations" / f"{i:04d}") for i in sorted(entries)]
    try:
        summary = json.loads(_text(folder / "summary.json") or "{}")
    except ValueError:
        summary = {}
    return Results(folder, summary, evaluations, unreadable, _text(folder / "resolved.toml"))


def _text(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return ""
