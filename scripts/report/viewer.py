# SPDX-License-Identifier: LGPL-2.1-or-later
"""Packs the recorded shapes into the page for viewer.js."""
import base64
import json

import numpy as np

from .drawing import plt
from .picture import stress_ranges
from .surface import Surface

MAX_BYTES = 12_000_000  # of packed states; beyond it states are left out evenly
LEVELS = 65535  # of 16-bit numbers


def packed(surface: Surface) -> str:
    """JSON for viewer.js: corner positions and stresses as 16-bit numbers in base64, one entry per state."""
    nodes, faces = np.unique(surface.faces, return_inverse=True)
    states = _thinned(surface.states, len(nodes) * 8)
    points = [state.points[nodes] for state in states]
    low = np.min([p.min(axis=0) for p in points], axis=0)
    extent = max(float(np.max([p.max(axis=0) - low for p in points])), 1e-9)
    ranges = stress_ranges(surface)
    largest = max([1e-12, *(float(np.nanmax(s.stress[nodes])) for s in states if s.stress is not None)])
    return json.dumps({
        "faces": _base64(faces.astype("<u4")), "faceBody": _base64(surface.face_body.astype("u1")),
        "bodies": {int(body): surface.body_name(body) for body in np.unique(surface.face_body)},
        "stressRanges": {body: round(value, 6) for body, value in ranges.items()},
        "low": [float(value) for value in low], "extent": extent, "largestStress": largest,
        "symmetric": surface.symmetric, "colours": _base64(_colours()),
        "states": [_state(state, p, low, extent, largest, nodes) for state, p in zip(states, points)],
    }).replace("</", "<\\/")


def _state(state, points: np.ndarray, low: np.ndarray, extent: float, largest: float, nodes: np.ndarray) -> dict:
    stress = None if state.stress is None else _base64(_levels(state.stress[nodes] / largest))
    places = _base64(_levels((points - low) / extent))
    return {"title": state.title(), "step": state.facts.get("step"), "points": places, "stress": stress}


def _thinned(states: list, bytes_each: int) -> list:
    count = max(2, min(len(states), MAX_BYTES // max(bytes_each, 1)))
    return [states[i] for i in sorted(set(np.linspace(0, len(states) - 1, count).round().astype(int)))]


def _levels(shares: np.ndarray) -> np.ndarray:
    return np.round(np.clip(np.nan_to_num(shares), 0, 1) * LEVELS).astype("<u2")


def _colours() -> np.ndarray:
    """256 colours of a scale that stays in order for colour-blind readers and in grey."""
    return np.round(plt.get_cmap("viridis")(np.linspace(0, 1, 256))[:, :3] * 255).astype("u1")


def _base64(array: np.ndarray) -> str:
    return base64.b64encode(np.ascontiguousarray(array).tobytes()).decode()
