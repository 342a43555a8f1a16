# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a results directory holds, read without Ballonet. Missing or torn files give empty data, never an error."""
import functools
import json
import tomllib
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from .history import History, marked, read_history
from .surface import Surface, read_surface


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
        return self.status == "ok"

    @property
    def status(self) -> str:
        return str(self.entry.get("status", "unknown"))

    @property
    def failed(self) -> bool:
        """Whether it ended without its result; one that is still at work has not."""
        return self.status not in ("ok", "unfinished")

    def response(self, name: str) -> float:
        """The response as a number; NaN if the evaluation has none of that name."""
        value = self.responses.get(name)
        return float(value) if isinstance(value, (int, float)) else float("nan")

    @property
    def responses(self) -> dict:
        return self.entry.get("responses") or {}

    @property
    def design(self) -> dict:
        return self.entry.get("design") or {}

    @property
    def judgement(self) -> dict:
        """The class of the path and the criteria behind it, if it was judged."""
        return self.entry.get("judgement") or {}

    @property
    def units(self) -> dict:
        return self.entry.get("units") or {}

    @functools.cached_property
    def history(self) -> History:
        return marked(read_history(self.folder / "history.csv"), self.entry.get("critical_points") or [])

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

    @functools.cached_property
    def settings(self) -> dict:
        """The resolved study; empty if it cannot be read."""
        try:
            return tomllib.loads(self.resolved)
        except tomllib.TOMLDecodeError:
            return {}

    def quantity(self, table: str, key: str) -> float:
        """The number of `"0.3 mm"` in a table of the resolved study; NaN if it is not set."""
        try:
            return float(str(self.settings[table][key]).split()[0])
        except (KeyError, TypeError, ValueError, IndexError):
            return float("nan")

    @property
    def objective(self) -> dict:
        return self.summary.get("objective") or self.settings.get("objective") or {}

    @property
    def reduced(self) -> bool:
        """Whether the reduced model computed the designs, and nothing else."""
        return (self.settings.get("method") or {}).get("model") == "reduced"

    @property
    def constraints(self) -> list[dict]:
        return self.settings.get("constraint", [])

    def own_responses(self) -> list[str]:
        """Names of the responses the study itself defines."""
        return [response["name"] for response in self.settings.get("response", []) if "name" in response]

    @property
    def running(self) -> bool:
        """Whether the run has not come to its end: at work, or killed."""
        return self.summary.get("status", "running") == "running"

    def admissible(self, evaluation: Evaluation) -> bool:
        """Whether it worked and keeps all constraints of the study."""
        return evaluation.ok and all(
            limit.get("min", -np.inf) <= evaluation.response(limit.get("response")) <= limit.get("max", np.inf)
            for limit in self.constraints)

    @property
    def named_best(self) -> int | None:
        """The evaluation the summary calls the best; None if it names none."""
        return (self.summary.get("best") or {}).get("id")

    @functools.cached_property
    def best(self) -> Evaluation | None:
        """The one shown: the named best, else the best so far, else the last that worked, else the longest path."""
        for candidates in ([e for e in self.evaluations if e.id == self.named_best], self._best_so_far(),
                           [e for e in self.evaluations if e.ok]):
            if candidates:
                return candidates[-1]
        return max(self.evaluations, key=lambda e: len(e.history), default=None)

    def _best_so_far(self) -> list[Evaluation]:
        name = self.objective.get("response")
        worked = [e for e in self.evaluations if self.admissible(e) and np.isfinite(e.response(name))]
        return sorted(worked, key=lambda e: self.goal_sign * e.response(name))

    @property
    def goal_sign(self) -> int:
        """+1 if larger is better, -1 if smaller is better."""
        return 1 if str(self.objective.get("goal", "")).startswith("max") else -1


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
    return Results(folder, _summary(folder / "summary.json"), evaluations, unreadable, _text(folder / "resolved.toml"))


def _summary(path: Path) -> dict:
    try:
        summary = json.loads(_text(path))
    except ValueError:
        return {}
    return summary if isinstance(summary, dict) else {}


def _text(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return ""
