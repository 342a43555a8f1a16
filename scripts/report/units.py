# SPDX-License-Identifier: LGPL-2.1-or-later
"""How columns and numbers are written for a reader."""
import math
import re

UNITS = {"kPa": "kPa", "MPa": "MPa", "mm3": "mm³", "mm": "mm", "deg": "°", "N": "N", "s": "s"}


def unit_of(column: str) -> str:
    """The unit a name ends with, before the _max or _min of a response; empty for pure numbers."""
    return _split(column)[1]


def label(column: str) -> str:
    """`balloon_stress_max_MPa` becomes `balloon stress max (MPa)`."""
    words, unit = _split(column)
    return words.replace("_", " ") + (f" ({unit})" if unit else "")


def bare(column: str) -> str:
    """The label without the unit."""
    return _split(column)[0].replace("_", " ")


def quantity(value, unit: str = "") -> str:
    """`38.9 kPa`, `74.1°`, a dash without a unit where there is no number."""
    text = number(value)
    return text + ("" if text == "–" or not unit else unit if unit == "°" else f" {unit}")


def duration(seconds) -> str:
    """`4.8 s`, `3 min 37 s`, `2 h 5 min`."""
    if not isinstance(seconds, (int, float)) or not math.isfinite(seconds):
        return "–"
    if seconds < 60:
        return f"{seconds:.2g} s"
    minutes, rest = divmod(round(seconds), 60)
    return f"{minutes} min {rest} s" if minutes < 60 else f"{minutes // 60} h {minutes % 60} min"


def _split(column: str) -> tuple[str, str]:
    """The name without its unit, and the unit."""
    stem, _, extreme = re.fullmatch(r"(.*?)(_(max|min))?", column).groups()
    words, _, ending = stem.rpartition("_")
    if not words or ending not in UNITS:
        return column, ""
    already = words.endswith(f"_{extreme}")  # the largest of the largest
    return f"{words} {extreme}" if extreme and not already else words, UNITS[ending]


def number(value) -> str:
    """Four significant digits; words stay words, nothing becomes a dash."""
    if isinstance(value, bool) or isinstance(value, str):
        return str(value)
    if value is None or not math.isfinite(value):
        return "–"
    if value == int(value) and abs(value) < 1e6:
        return str(int(value))
    return f"{value:.4g}"
