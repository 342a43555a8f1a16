# SPDX-License-Identifier: LGPL-2.1-or-later
"""What each section of the page says. Every function takes the results and returns HTML, or raises Missing."""
import html

import numpy as np

from . import curves, loop, picture, viewer
from .curves import Missing
from .data import Evaluation, History, Results
from .surface import Surface
from .tables import design_table, evaluations_table, fact_table, response_table
from .units import number

STATUS_WORDS = {
    "done": "Finished", "ok": "Evaluated", "mesh_failed": "No valid mesh could be made",
    "diverged": "The path stopped: no equilibrium was found at the smallest step",
    "inverted": "The path stopped: an element turned inside out",
    "step_limit": "The path stopped at its largest number of steps", "time_limit": "Stopped at the time limit",
    "failed": "Failed", "unfinished": "Not finished", "interrupted": "Interrupted",
}
VIEWER = """
<div id="viewer">
<canvas id="view" tabindex="0" aria-label="Orbit view of the deformed actuator"></canvas>
<input id="state" type="range" min="0" value="0" step="1" aria-label="recorded state">
<div class="controls"><button id="play" type="button">play / pause</button><span id="state-title"></span>
<label>colour: <select id="colouring"><option value="stress">stress</option>
<option value="displacement">displacement</option><option value="body">body</option></select></label>
<label><input id="whole" type="checkbox" checked> whole (off: the computed half, open)</label>
<button id="reset" type="button">reset view</button></div>
<div class="controls"><span>0 <span id="scale"></span> <span id="scale-end"></span></span></div>
</div>
<p class="note">Drag to turn, pinch (or click, then wheel) to zoom.</p>
"""


def _best(results: Results) -> Evaluation:
    if results.best is None:
        raise Missing("the journal holds no evaluation.")
    return results.best


def _history(results: Results) -> History:
    best = _best(results)
    if not len(best.history):
        raise Missing(f"evaluation {best.id} has no history.csv with rows.")
    return best.history


def headline(results: Results) -> str:
    summary = results.summary
    name = html.escape(summary.get("study") or results.folder.name)
    question = html.escape(summary.get("question") or "")
    parts = [f"<h1>{name}</h1>", f'<p class="question">{question}</p>' if question else "", _status(results)]
    best = results.best
    if best is None:
        return "".join(parts)
    design, responses = design_table(best), response_table(best)
    title = "best design" if results.named_best == best.id and best.entry.get("design") else "shown here"
    parts.append(f'<p>Evaluation {best.id} ({title}):</p><div class="columns">{design}{responses}</div>')
    return "".join(parts)


def _status(results: Results) -> str:
    summary = results.summary
    if not summary:
        return '<p class="status">Not finished: there is no readable summary.json.</p>'
    status = summary.get("status", "")
    words = STATUS_WORDS.get(status, status)
    reason = f" – {summary['reason']}" if summary.get("reason") else ""
    endings = (summary.get("counts") or {}).items()
    counts = ", ".join(f"{count} {name.replace('_', ' ')}" for name, count in endings if count)
    facts = f" Evaluations: {counts}." if counts else ""
    return f'<p><span class="status">{html.escape(words + reason)}.</span>{html.escape(facts)}</p>'


def shapes(results: Results) -> str:
    best = _best(results)
    surface = best.surface
    if surface is None:
        raise Missing(f"evaluation {best.id} has no readable history.h5 with recorded shapes.")
    data = f'<script type="application/json" id="shapes">{viewer.packed(surface)}</script>'
    return f'{picture.pictures(surface)}<p class="note">{html.escape(_colour_caption(surface))}</p>{VIEWER}{data}'


def _colour_caption(surface: Surface) -> str:
    if not any(state.stress is not None for state in surface.states):
        return "Colour: body."
    names = viewer.body_names(surface)
    ends = ", ".join(f"{names[body]} {end:.3g} MPa" for body, end in picture.stress_ranges(surface).items())
    return f"Colour: stress, each body on its own scale from 0 (dark) to {ends} and above (bright)."


def pressure_angle(results: Results) -> str:
    return curves.pressure_angle(_best(results), results.evaluations)


def along_path(results: Results) -> str:
    return curves.along_path(_history(results))


def responses(results: Results) -> str:
    history = _history(results)
    known = curves.KNOWN.union(history.gaps())
    own = [name for name in history.numbers if name not in known and history.has(name)]
    if not own:
        raise Missing("the study names no responses of its own.")
    return curves.responses_along_path(history, own)


def gap_map(results: Results) -> str:
    note = ("Red gaps open, blue ones close. The left panel jumps where a slowly raised pressure would make the "
            "actuator jump; the right one follows the computed path, on which the pressure may fall.")
    return curves.gap_map(_history(results)) + f'<p class="note">{note}</p>'


def expansion(results: Results) -> str:
    columns = {"axial_ratio": "axial", "radial_ratio": "radial"}
    return curves.against_pressure(_history(results), columns, "expansion ratio (–)")


def stress(results: Results) -> str:
    columns = {"balloon_stress_max_MPa": "balloon", "backbone_stress_max_MPa": "backbone"}
    return curves.against_pressure(_history(results), columns, "largest stress (MPa)", one_scale=False)


def force(results: Results) -> str:
    columns = {"head_force_N": "on the head", "tip_force_N": "at the tip"}
    return curves.against_pressure(_history(results), columns, "force (N)")


def convergence(results: Results) -> str:
    figure = loop.convergence(results.evaluations, results.summary.get("objective") or {})
    reasons = [f"<li>{e.id}: {html.escape(_failure(e))}</li>" for e in results.evaluations if not e.ok]
    return figure + (f"<p>Failed evaluations:</p><ul>{''.join(reasons)}</ul>" if reasons else "")


def _failure(evaluation: Evaluation) -> str:
    status = evaluation.entry.get("status", "unknown")
    return f"{status}: {evaluation.entry.get('reason') or STATUS_WORDS.get(status, 'no reason given')}"


def evaluation_table(results: Results) -> str:
    _best(results)
    unreadable = results.unreadable_lines
    note = f'<p class="note">Unreadable lines in the journal: {unreadable}.</p>' if unreadable else ""
    return evaluations_table(results) + note


def numerics(results: Results) -> str:
    history = _history(results)
    facts = {"steps": str(len(history)), "cut steps": _total(history, "cuts"),
             "Newton iterations": _total(history, "newton_iterations")}
    for column, name in (("dissipated_share", "largest dissipated share"), ("kinetic_share", "largest kinetic share")):
        facts[name] = f"{np.nanmax(history.numbers[column]):.2%}" if history.has(column) else "not recorded"
    facts["mesh"] = _best(results).entry.get("mesh_hash") or "not recorded"
    note = ("Dissipated share: viscous work of a step over all energy moved in it. Kinetic share: kinetic over "
            "stored energy. Small shares mean that the path is close to equilibrium.")
    return f'{fact_table(facts)}<p class="note">{note}</p>'


def _total(history: History, column: str) -> str:
    return number(float(np.nansum(history.numbers[column]))) if history.has(column) else "not recorded"


def reproduce(results: Results) -> str:
    summary = results.summary
    facts = {"version": summary.get("version"), "commit": summary.get("commit"), "ranks": summary.get("ranks"),
             "wall time": f"{number(summary['wall_seconds'])} s" if "wall_seconds" in summary else None,
             "evaluations": summary.get("evaluations"), "of these taken from the journal": summary.get("replayed")}
    table = fact_table({name: "not recorded" if value in (None, "") else str(value) for name, value in facts.items()})
    if not results.resolved:
        return table + '<p class="missing">resolved.toml is missing, so there is no study file to run again.</p>'
    command = f"scripts/run {results.folder}/resolved.toml -o results/again"
    return (f"{table}<p>With the resolved study of this directory, every default written out:</p>"
            f"<pre>{html.escape(command)}</pre>"
            f"<details><summary>resolved.toml</summary><pre>{html.escape(results.resolved)}</pre></details>")
