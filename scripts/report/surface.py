# SPDX-License-Identifier: LGPL-2.1-or-later
"""The recorded shapes of the actuator's surface (history.h5)."""
import re
from dataclasses import dataclass, field
from pathlib import Path

import h5py
import numpy as np


@dataclass
class ShapeState:
    """The surface at one recorded step."""

    points: np.ndarray  # (m, 3), mm
    stress: np.ndarray | None  # (m,), MPa
    facts: dict[str, float]  # step, time, pressure_kPa, bending_angle_deg, ... as recorded

    def title(self) -> str:
        """What identifies the state to a reader, for example `35.9 kPa, 42°`."""
        digits = {"pressure_kPa": (1, " kPa"), "bending_angle_deg": (0, "°")}
        parts = [f"{_rounded(self.facts[name], places)}{unit}" for name, (places, unit) in digits.items()
                 if np.isfinite(self.facts.get(name, np.nan))]
        return ", ".join(parts) or f"step {self.facts.get('step', 0):.0f}"


def _rounded(value: float, digits: int) -> str:
    """Fixed digits, and no `-0`."""
    return f"{round(value, digits) + 0.0:.{digits}f}"


@dataclass
class Surface:
    """Quadrilaterals of the exposed surface and where their corners were."""

    faces: np.ndarray  # (n, 4), corners in cyclic order
    face_body: np.ndarray  # (n,)
    bodies: list[str]
    states: list[ShapeState] = field(default_factory=list)
    symmetric: bool = False  # half model, to be mirrored in y

    def body_name(self, body: int) -> str:
        return self.bodies[body] if body < len(self.bodies) else f"body {body}"


def read_surface(path: Path) -> Surface | None:
    """Reads the recorded shapes; None if the file is missing, unreadable or holds none."""
    try:
        with h5py.File(path, "r") as file:
            return _surface(file)
    except (OSError, KeyError, RuntimeError):
        return None


def _surface(file: h5py.File) -> Surface | None:
    group = file["surface"]
    faces = group["faces"][()].astype(int)
    bodies = group["face_body"][()].astype(int) if "face_body" in group else np.zeros(len(faces), int)
    states = [_state(file["states"][name]) for name in sorted(file["states"])]
    states = [state for state in states if np.isfinite(state.points).all()]
    if not states or not len(faces) or faces.max() >= min(len(state.points) for state in states):
        return None
    symmetric = any(state.facts.get("symmetry", 0) == 1 for state in states)
    return Surface(cyclic(faces, states[0].points), bodies, _names(group.attrs.get("bodies", "")), states, symmetric)


def _state(group: h5py.Group) -> ShapeState:
    stress = np.nan_to_num(group["stress"][()].ravel()) if "stress" in group else None
    facts = {name: float(np.ravel(value)[0]) for name, value in group.attrs.items()
             if np.issubdtype(np.asarray(value).dtype, np.number)}
    return ShapeState(group["points"][()].reshape(-1, 3), stress, facts)


def _names(value) -> list[str]:
    """Body names, given as a list of strings or as one string with separators."""
    words = [value] if isinstance(value, (str, bytes)) else list(np.ravel(value))
    text = ",".join(word.decode() if isinstance(word, bytes) else str(word) for word in words)
    return [word for word in re.split(r"[,;\s]+", text) if word]


def cyclic(faces: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Brings corners from lexicographic order (0 1 / 2 3) into order around the face; leaves cyclic ones alone.

    The diagonals of a quadrilateral are longer together than two of its opposite edges.
    """
    def length(a: int, b: int) -> float:
        return np.linalg.norm(points[faces[:, a]] - points[faces[:, b]], axis=1).sum()

    if length(0, 3) + length(1, 2) > length(0, 2) + length(1, 3):
        return faces[:, [0, 1, 3, 2]]
    return faces
