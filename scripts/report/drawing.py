# SPDX-License-Identifier: LGPL-2.1-or-later
"""The look that all figures share: colours that colour-blind readers can tell apart, legends beside the data."""
import base64
import html
import io

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of the backend)

# Okabe and Ito, "Color Universal Design" (2008)
BLUE, ORANGE, GREEN, VERMILION, PURPLE, SKY, BLACK = (
    "#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7", "#56B4E9", "#222222")
COLOURS = (BLUE, VERMILION, GREEN, ORANGE, PURPLE, SKY, BLACK)
FAINT = "#9AA5B1"
INK = "#3A444E"
STAGE_TINTS = {"separation": "#F2F4F6", "insufficient": "#FBE9C6", "sufficient": "#BFDDF0", "excessive": "#E9B79C"}
EVENT_MARKS = {"limit point": ("^", VERMILION), "stability lost": ("o", BLACK), "limit point, located": ("v", VERMILION),
               "volume turns, located": ("X", VERMILION), "bifurcation, located": ("D", BLACK)}

plt.rcParams.update({
    "font.size": 10, "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True, "grid.color": "#E3E6EA",
    "grid.linewidth": 0.6, "axes.axisbelow": True, "lines.linewidth": 1.8, "legend.frameon": False,
    "svg.fonttype": "path", "axes.prop_cycle": plt.cycler(color=COLOURS), "savefig.dpi": 144,
    "axes.edgecolor": "#77808A",
})


def legend_beside(axes, **options) -> None:
    """Puts the legend right of the axes, where it hides no data."""
    axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), borderaxespad=0, **options)


def image(figure, description: str, kind: str = "svg") -> str:
    """The figure as an HTML image that carries its data along; closes the figure."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format=kind, bbox_inches="tight", metadata={"Date": None} if kind == "svg" else None)
    plt.close(figure)
    data = buffer.getvalue()
    mime = {"svg": "svg+xml", "png": "png"}[kind]
    pixels = int.from_bytes(data[16:20], "big")  # of a PNG; shown so that letters are as large as in an SVG
    width = f' width="{pixels * 96 // 144}"' if kind == "png" else ""
    code = base64.b64encode(data).decode()
    return f'<img alt="{html.escape(description)}"{width} src="data:image/{mime};base64,{code}">'
