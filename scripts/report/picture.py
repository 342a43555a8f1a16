# SPDX-License-Identifier: LGPL-2.1-or-later
"""Still pictures of the deformed surface, drawn back to front."""
import numpy as np
from matplotlib.collections import PolyCollection

from .drawing import INK, image, plt
from .surface import ShapeState, Surface

AZIMUTH, ELEVATION = np.radians(-65), np.radians(14)  # the side on which the bending shows
LIGHT = np.array([0.35, -0.75, 0.56])
PANELS = 4
LIMITS = np.array([-0.03, 1.0])  # of a panel, in shares of its size
HEIGHT, MOST_WIDE, NARROWEST = 3.4, 10.0, 1.5  # of a panel, of all panels together, of a panel; inches
TITLE, SCALES = 0.3, 1.0  # above and below the panels, inches


def camera() -> np.ndarray:
    """Rows: right, up and towards the viewer, in the coordinates of the model (z up)."""
    towards = np.array([np.cos(ELEVATION) * np.cos(AZIMUTH), np.cos(ELEVATION) * np.sin(AZIMUTH), np.sin(ELEVATION)])
    right = np.array([-np.sin(AZIMUTH), np.cos(AZIMUTH), 0.0])
    return np.array([right, np.cross(towards, right), towards])


def corners(surface: Surface, state: ShapeState) -> np.ndarray:
    """Corner positions (n, 4, 3) of all faces, the mirrored half included."""
    half = state.points[surface.faces]
    return np.concatenate([half, half * [1, -1, 1]]) if surface.symmetric else half


def stress_ranges(surface: Surface) -> dict[int, float]:
    """Per body the upper end of the colour scale, MPa: exceeded by one value in a hundred over all states."""
    ranges = {}
    for body in np.unique(surface.face_body):
        nodes = np.unique(surface.faces[surface.face_body == body])
        values = [state.stress[nodes] for state in surface.states if state.stress is not None]
        ranges[int(body)] = float(np.nanpercentile(np.concatenate(values), 99)) if values else 0.0
    return ranges


def face_colours(surface: Surface, state: ShapeState, ranges: dict[int, float]) -> np.ndarray:
    """Colour of each face: its stress relative to its body's range, or one colour per body without stresses."""
    if state.stress is None:
        return plt.get_cmap("Set2")(surface.face_body % 8)
    scale = np.array([max(ranges[int(body)], 1e-12) for body in surface.face_body])
    return plt.get_cmap("viridis")(np.clip(state.stress[surface.faces].mean(axis=1) / scale, 0, 1))


def chosen_states(surface: Surface, count: int = PANELS) -> list[ShapeState]:
    """The first, the last and some in between, equally far apart in angle if angles were recorded, else in number."""
    measure = np.array([state.facts.get("bending_angle_deg", np.nan) for state in surface.states])
    if not np.isfinite(measure).all() or np.ptp(measure) == 0:
        measure = np.arange(len(surface.states))
    targets = np.linspace(measure[0], measure[-1], min(count, len(measure)))
    rows = sorted({0, len(measure) - 1, *(int(np.abs(measure - target).argmin()) for target in targets[1:-1])})
    return [surface.states[row] for row in rows]


def pictures(surface: Surface) -> str:
    """A row of shapes in one scale, with a bar of length and the scale of stress of each body below."""
    states = chosen_states(surface)
    ranges = stress_ranges(surface)
    views = [corners(surface, state) @ camera().T for state in states]
    low = np.min([view[..., :2].min(axis=(0, 1)) for view in views], axis=0)
    width, height = np.maximum(np.max([view[..., :2].max(axis=(0, 1)) for view in views], axis=0) - low, 1e-6) * 1.06
    tall = min(HEIGHT, max(MOST_WIDE / len(states), NARROWEST) * height / width)
    panel = max(tall * width / height, NARROWEST)
    total = tall + TITLE + SCALES
    figure = plt.figure(figsize=(panel * len(states), total))
    for i, (state, view) in enumerate(zip(states, views)):
        axes = figure.add_axes([i / len(states), SCALES / total, 1 / len(states), tall / total])
        _draw(axes, view, face_colours(surface, state, ranges))
        axes.set(xlim=low[0] + width * LIMITS, ylim=low[1] + height * LIMITS, aspect="equal")
        axes.set_title(state.title(), fontsize=10)
        axes.axis("off")
    _length_bar(figure.axes[0], low, max(width, height / 4))
    if any(state.stress is not None for state in states):
        _stress_scales(figure, {surface.body_name(body): end for body, end in ranges.items()}, total)
    return image(figure, "Shapes of the actuator: " + "; ".join(state.title() for state in states), "png")


def _length_bar(axes, low: np.ndarray, size: float) -> None:
    """A bar of a round length under the shape: 1, 2 or 5 times a power of ten, about a third of the size."""
    third = size / 3
    power = 10.0 ** np.floor(np.log10(third))
    length = power * max(factor for factor in (1, 2, 5) if factor * power <= third)
    place = low[1] - 0.06 * size
    axes.plot([low[0], low[0] + length], [place, place], color=INK, lw=2, clip_on=False)
    axes.annotate(f"{length:g} mm", (low[0] + length / 2, place), xytext=(0, -3), textcoords="offset points",
                  ha="center", va="top", fontsize=9, annotation_clip=False)


def _stress_scales(figure, ends: dict[str, float], total: float) -> None:
    """One colour bar per body side by side; `ends` in MPa."""
    share = min(1 / len(ends), 2.4 / figure.get_figwidth())
    for i, (body, end) in enumerate(ends.items()):
        axes = figure.add_axes([(i + 0.08) * share, 0.42 / total, 0.84 * share, 0.12 / total])
        scale = plt.cm.ScalarMappable(plt.Normalize(0, max(end, 1e-12)), "viridis")
        bar = figure.colorbar(scale, cax=axes, orientation="horizontal", extend="max")
        bar.locator = plt.MaxNLocator(3)
        bar.set_label(f"stress, {body} (MPa)", fontsize=9)
        bar.ax.tick_params(labelsize=9)


def _draw(axes, view: np.ndarray, colours: np.ndarray) -> None:
    """Painter's algorithm with a little light; `view` in camera coordinates, mirrored faces repeat the colours."""
    colours = np.tile(colours, (len(view) // len(colours), 1))
    normals = np.cross(view[:, 2] - view[:, 0], view[:, 3] - view[:, 1])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    shade = 0.45 + 0.55 * np.abs(normals @ (camera() @ LIGHT))
    order = view[..., 2].mean(axis=1).argsort()
    shaded = np.clip(colours[:, :3] * shade[:, None], 0, 1)[order]
    outlines = view[order][..., :2]
    axes.add_collection(PolyCollection(outlines, facecolors=shaded, edgecolors=shaded * 0.8, linewidths=0.25))
