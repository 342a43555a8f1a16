# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes an invented results directory for the tests of the report: an arm that bends while a tube in it swells."""
import csv
import json
from pathlib import Path

import h5py
import numpy as np

GAPS = 20
STEPS = 60
STAGES = [(0.15, "separation"), (0.35, "insufficient"), (0.95, "sufficient"), (2.0, "excessive")]


def write_results(folder: Path, evaluations: int = 8, best: int = 5) -> Path:
    """The whole directory; evaluation 3 failed, evaluation `best` is the best."""
    folder.mkdir(parents=True, exist_ok=True)
    entries = [journal_entry(i, best) for i in range(1, evaluations + 1)]
    (folder / "journal.jsonl").write_text("".join(json.dumps(entry) + "\n" for entry in entries))
    for entry in entries:
        if entry["status"] == "ok":
            write_evaluation(folder / "evaluations" / f"{entry['id']:04d}", entry["responses"]["angle_40kPa"])
    (folder / "summary.json").write_text(json.dumps(summary(entries, best)))
    (folder / "resolved.toml").write_text('[study]\nname = "invented"\n')
    return folder


def journal_entry(number: int, best: int) -> dict:
    failed = number == 3
    diameter = 6 + 0.25 * number
    return {
        "id": number, "hash": f"{number:016x}", "design": {"actuator.balloon.diameter": diameter},
        "units": {"actuator.balloon.diameter": "mm"}, "status": "diverged" if failed else "ok",
        "reason": "no convergence at dt = 1e-6 s & <less>" if failed else "",
        "responses": {} if failed else {"angle_40kPa": 200.0 - 8 * abs(number - best), "instability": "normal"},
        "seconds": 12.5, "mesh_hash": "ab12",
    }


def summary(entries: list[dict], best: int) -> dict:
    chosen = entries[best - 1]
    return {
        "study": "invented <arm>", "question": "Which balloon bends the arm furthest at 40 kPa?", "status": "done",
        "reason": "budget used up", "best": {k: chosen[k] for k in ("id", "design", "responses")},
        "objective": {"response": "angle_40kPa", "goal": "maximize"},
        "counts": {"ok": len(entries) - 1, "diverged": 1}, "evaluations": len(entries), "replayed": 2,
        "wall_seconds": 93.4, "version": "0.1.0", "commit": "0123abc", "ranks": 2,
    }


def write_evaluation(folder: Path, angle_end: float) -> None:
    folder.mkdir(parents=True)
    columns = path_columns(angle_end)
    with open(folder / "history.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        writer.writerows(zip(*columns.values()))
    write_shapes(folder / "history.h5", columns)


def path_columns(angle_end: float) -> dict[str, list]:
    """A path whose pressure rises to a limit point, falls and rises again."""
    s = np.linspace(0, 1, STEPS)
    pressure = 36 * np.sin(np.pi * np.minimum(s / 0.6, 1) * 0.5) - 3 * np.exp(-((s - 0.7) / 0.08) ** 2) + 4 * s**2
    angle = -30 * (1 - s) ** 2 + angle_end * s**2
    columns = {
        "step": np.arange(STEPS), "control": 1 + 5 * s, "pressure_kPa": pressure, "bending_angle_deg": angle,
        "volume_ratio": 1 + 5 * s, "axial_ratio": 1 + 0.1 * s, "radial_ratio": 1 + 1.2 * s,
        "balloon_stress_max_MPa": 1.2 * s, "backbone_stress_max_MPa": 14 * s**2,
        "head_force_N": 6 * s, "tip_force_N": 0 * s,
        "max_bulge_mm": 2 * s**2, "rib_contact_fraction": np.minimum(1, 2 * s),
        "negative_eigenvalues": ((s > 0.55) & (s < 0.75)).astype(int), "newton_iterations": np.full(STEPS, 6),
        "factorisations": np.full(STEPS, 5),
        "cuts": (s > 0.6).astype(int), "dissipated_share": 0.01 * s, "kinetic_share": 0.002 * s,
    }
    for k in range(1, GAPS + 1):
        columns[f"gap_{k:02d}_deg"] = angle / GAPS * (0.4 + 1.2 * k / GAPS)
    columns["stage"] = [next(name for end, name in STAGES if x < end) for x in s]
    return {name: list(values) for name, values in columns.items()}


def write_shapes(path: Path, columns: dict[str, list], around: int = 12, along: int = 40) -> None:
    """Half tubes about a circular arc: radius 4 mm (balloon) and 8 mm (backbone), length 96 mm, symmetric in y."""
    with h5py.File(path, "w") as file:
        faces = grid_faces(around, along)
        count = (around + 1) * (along + 1)
        surface = file.create_group("surface")
        surface["faces"] = np.vstack([faces, faces + count])
        surface["face_body"] = np.repeat([0, 1], len(faces))
        surface.attrs["bodies"] = "balloon,backbone"
        for number in range(0, STEPS, 6):
            state = file.create_group(f"states/{number:04d}")
            angle = columns["bending_angle_deg"][number]
            radii = (3 * columns["radial_ratio"][number], 8)
            state["points"] = np.vstack([bent_tube(radius, angle, around, along) for radius in radii])
            state["stress"] = np.tile(np.linspace(0, columns["balloon_stress_max_MPa"][number], count), 2)
            state.attrs.update(step=number, time=0.1 * number, pressure_kPa=columns["pressure_kPa"][number],
                               bending_angle_deg=angle, symmetry=1)


def grid_faces(around: int, along: int) -> np.ndarray:
    i, j = np.meshgrid(np.arange(around), np.arange(along))
    first = (i + j * (around + 1)).ravel()
    return np.column_stack([first, first + 1, first + around + 2, first + around + 1])


def bent_tube(radius: float, angle_deg: float, around: int, along: int, length: float = 96.0) -> np.ndarray:
    phi, s = np.meshgrid(np.linspace(0, np.pi, around + 1), np.linspace(0, length, along + 1))
    kappa = np.radians(angle_deg) / length + 1e-9
    offset = radius * np.cos(phi)
    x = (1 - np.cos(kappa * s)) / kappa + offset * np.cos(kappa * s)
    z = np.sin(kappa * s) / kappa - offset * np.sin(kappa * s)
    return np.column_stack([x.ravel(), (radius * np.sin(phi)).ravel(), z.ravel()])
