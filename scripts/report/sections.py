# SPDX-License-Identifier: LGPL-2.1-or-later
"""What each section of the page says. Every function takes the results and returns HTML, or raises Missing."""
import html

import numpy as np

from . import curves, gaps, loop, picture, viewer
from .answer import failure, reached
from .curves import Missing
from .data import Evaluation, Results
from .history import History
from .tables import criteria_table, evaluations_table, responses_table, shown_responses, table
from .units import duration, label, number, quantity

SHARES = {"dissipated_share": "viscous share\n(–)", "kinetic_share": "kinetic share\n(–)"}

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


def shapes(results: Results) -> str:
    best = _best(results)
    surface = best.surface
    if surface is None:
        raise Missing(f"evaluation {best.id} has no readable history.h5 with recorded shapes.")
    data = f'<script type="application/json" id="shapes">{viewer.packed(surface)}</script>'
    coloured = any(state.stress is not None for state in surface.states)
    note = "stress, each body on its own scale; above its end, the brightest colour" if coloured else "body"
    return f'{picture.pictures(surface)}<p class="note">All shapes to one scale. Colour: {note}.</p>{VIEWER}{data}'


def pressure_angle(results: Results) -> str:
    _history(results)
    window_end = 1e3 * results.quantity("judge", "window_max")
    return curves.pressure_angle(_best(results), results.evaluations, window_end)


def along_path(results: Results) -> str:
    return curves.along_path(_history(results))


def responses(results: Results) -> str:
    own = results.own_responses()
    if not own:
        raise Missing("the study names no responses of its own.")
    return curves.columns_along_path(_history(results), {name: label(name).replace(" (", "\n(") for name in own})


def gap_map(results: Results) -> str:
    history = _history(results)
    note = ("Red gaps open, blue ones close. Where the pressure falls on the way, the picture goes along the path "
            "instead and the pressure stands above it.")
    return gaps.gap_map(history) + (f'<p class="note">{note}</p>' if len(history) > 1 else "")


def expansion(results: Results) -> str:
    columns = {"axial_ratio": "axial", "radial_ratio": "radial"}
    return curves.against_pressure(_history(results), columns, "expansion ratio (–)")


def stress(results: Results) -> str:
    columns = {"balloon_stress_max_MPa": "balloon", "backbone_stress_max_MPa": "backbone"}
    return curves.against_pressure(_history(results), columns, "largest stress (MPa)", one_scale=False)


def force(results: Results) -> str:
    columns = {"head_force_N": "on the head", "tip_force_N": "at the tip"}
    return curves.against_pressure(_history(results), columns, "force (N)")


def progress(results: Results) -> str:
    """The loop: figures where there is a number to draw, and always every failure with its reason."""
    _best(results)
    if len(results.evaluations) < 2:
        raise Missing("there is one evaluation only.")
    name = results.objective.get("response") or next(iter(shown_responses(results)), None)
    try:
        figures = loop.convergence(results, name) + loop.over_variables(results, name)
    except Missing as reason:
        figures = f'<p class="missing">No figure: {html.escape(str(reason))}</p>'
    return f"{figures}{_failures(results)}<h3>All evaluations</h3>{evaluations_table(results)}"


def _failures(results: Results) -> str:
    ended = [e for e in results.evaluations if not e.ok]
    if not ended:
        return "<p>No evaluation failed.</p>"
    rows = [[e.id, ", ".join(f"{key.split('.', 1)[-1]} {quantity(value, e.units.get(key, ''))}"
                             for key, value in e.design.items()), reached(e), failure(e)] for e in ended]
    kinds = {i: "failed" for i, e in enumerate(ended) if e.failed}
    return "<h3>Failed or not finished</h3>" + table(["number", "design", "path", "reason"], rows, kinds)


def judgement(results: Results) -> str:
    best = _best(results)
    if not best.judgement.get("criteria"):
        raise Missing("the path was not judged.")
    note = "Margin: distance to the limit as a share of it, negative beyond. Else: what the path is if it is not met."
    return f'{criteria_table(best)}<p class="note">{note}</p>'


def numerics(results: Results) -> str:
    best, history = _best(results), _history(results)
    if results.reduced:
        return table([], [("model", "reduced: a tube in a chain of rigid units"), ("states", str(len(history))),
                          ("computing time", duration(best.entry.get("seconds")))])
    facts = [("steps", str(len(history))), ("cut steps", _total(history, "cuts")),
             ("Newton iterations", _total(history, "newton_iterations")),
             ("factorisations", _total(history, "factorisations")),
             ("computing time", duration(best.entry.get("seconds"))),
             ("mesh", best.entry.get("mesh_hash") or "not recorded")]
    note = ("Viscous share: viscous work of a step over all energy moved in it. Kinetic share: kinetic over "
            "stored energy. Small shares mean that the path is close to equilibrium.")
    try:
        figure = curves.columns_along_path(history, SHARES, "log")
    except Missing:
        figure = ""
    return f'{table([], facts)}{figure}<p class="note">{note}</p>'


def _total(history: History, column: str) -> str:
    return number(float(np.nansum(history.numbers[column]))) if history.has(column) else "not recorded"


def reproduce(results: Results) -> str:
    summary = results.summary
    seconds = [e.entry.get("seconds") for e in results.evaluations]
    facts = {"version": summary.get("version"), "ranks": summary.get("ranks"),
             "wall time": None if results.running else duration(summary.get("wall_seconds")),
             "computing time of all evaluations": duration(sum(s for s in seconds if isinstance(s, (int, float)))),
             "taken from the journal": None if results.running else summary.get("replayed")}
    rows = [(name, "not recorded" if value in (None, "") else str(value)) for name, value in facts.items()]
    if not results.resolved:
        return table([], rows) + '<p class="missing">resolved.toml is missing: there is no study file to run again.</p>'
    commit = summary.get("commit")
    command = f"scripts/run {results.folder}/resolved.toml -o results/again"
    command = f"git checkout {commit}\n{command}" if commit else command
    return (f"{table([], rows)}<p>With the resolved study of this directory, every default written out:</p>"
            f"<pre>{html.escape(command)}</pre>"
            f"<details><summary>resolved.toml</summary><pre>{html.escape(results.resolved)}</pre></details>")


def all_responses(results: Results) -> str:
    best = _best(results)
    if not best.responses:
        raise Missing(f"evaluation {best.id} has no responses.")
    title = f"All {len(best.responses)} numbers of evaluation {best.id}"
    return f"<details><summary>{title}</summary>{responses_table(best)}</details>"
