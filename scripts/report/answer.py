# SPDX-License-Identifier: LGPL-2.1-or-later
"""The top of the page: the question, how the run ended, which design is shown, what it gave."""
import html
from collections import Counter

import numpy as np

from .data import Evaluation, Results
from .facts import facts
from .tables import design_table, table
from .units import bare, quantity, unit_of

STATUS_WORDS = {
    "done": "Finished", "no_result": "Ended without a result", "ok": "Ran to its end",
    "mesh_failed": "No valid mesh could be made", "diverged": "No equilibrium was found at the smallest step",
    "inverted": "An element turned inside out", "step_limit": "Stopped at the largest number of steps",
    "time_limit": "Stopped at the time limit", "failed": "Failed", "unfinished": "Not finished",
}


def headline(results: Results) -> str:
    """The study in words."""
    summary, study = results.summary, results.settings.get("study") or {}
    question = summary.get("question") or study.get("question") or ""
    parts = [f"<h1>{html.escape(study_name(results))}</h1>",
             f'<p class="question">{html.escape(question)}</p>' if question else "",
             f'<p><span class="status">{html.escape(status(results))}</span> {html.escape(counts(results))}</p>']
    best = results.best
    if best is None:
        return "".join(parts)
    answer = html.escape(" ".join(text for text in (lead(results, best), model(results)) if text))
    parts += [f'<p class="answer">{answer}</p>' if answer else "", design_table(results, best)]
    rows = facts(results, best)
    return "".join([*parts, table(["result", "value", "meaning"], rows) if rows else ""])


def study_name(results: Results) -> str:
    return results.summary.get("study") or (results.settings.get("study") or {}).get("name") or results.folder.name


def status(results: Results) -> str:
    """How the run ended, one sentence."""
    summary = results.summary
    if not summary:
        return "Not finished: there is no readable summary.json."
    if results.running:
        return "Still running, or interrupted: the same command with --resume goes on from here."
    words = STATUS_WORDS.get(summary["status"], str(summary["status"]))
    return f"{words}: {summary['reason']}." if summary.get("reason") else f"{words}."


def counts(results: Results) -> str:
    """How many evaluations ended how, from the journal."""
    endings = Counter(e.status for e in results.evaluations)
    if not endings:
        return "No evaluation yet."
    words = ", ".join(f"{name.replace('_', ' ')} {count}" for name, count in endings.items())
    torn = f" Unreadable lines in the journal: {results.unreadable_lines}." if results.unreadable_lines else ""
    return f"Evaluations: {len(results.evaluations)} ({words}).{torn}"


def lead(results: Results, shown: Evaluation) -> str:
    """Which evaluation is shown, why, and what it gave for the objective."""
    alone, name = len(results.evaluations) == 1, results.objective.get("response")
    if not shown.ok and alone:
        why = f" {failure(shown)}." if shown.entry.get("reason") != results.summary.get("reason") else ""
        return f"The path did not come to its end: {reached(shown)}.{why}"
    if not shown.ok:
        return f"No evaluation has worked. Shown is number {shown.id}: {reached(shown)}. {failure(shown)}."
    if not name:
        return "" if alone else f"Shown is evaluation {shown.id}, the last that worked; the study has no objective."
    goal = "largest" if results.goal_sign > 0 else "smallest"
    value = quantity(shown.response(name), unit_of(name))
    if not np.isfinite(shown.response(name)):
        return f"Shown is evaluation {shown.id}; it has no {bare(name)}."
    if not results.admissible(shown):
        return f"No evaluation keeps all constraints. Shown is number {shown.id}: {bare(name)} {value}."
    so_far = " so far" if results.running else ""
    return f"Best{so_far}: evaluation {shown.id} with {bare(name)} {value}, the {goal} found."


def model(results: Results) -> str:
    """What the numbers are worth, if no simulation made them."""
    return "All numbers are those of the reduced model, not of a simulation." if results.reduced else ""


def failure(evaluation: Evaluation) -> str:
    """How an evaluation ended, in words, with its reason."""
    words = STATUS_WORDS.get(evaluation.status, evaluation.status)
    return f"{words}: {evaluation.entry['reason']}" if evaluation.entry.get("reason") else words


def reached(evaluation: Evaluation) -> str:
    """How far the path came: `60 steps, to 35 kPa and 17.9°`."""
    history = evaluation.history
    if not len(history):
        return "no step recorded"
    ends = [quantity(history.numbers[column][-1], unit_of(column)) for column in ("pressure_kPa", "bending_angle_deg")
            if history.has(column)]
    return f"{len(history)} step{'s' if len(history) > 1 else ''}" + (", to " + " and ".join(ends) if ends else "")
