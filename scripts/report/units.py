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


def _split(column: str) -> tuple[str, str]:
    """The name without its unit, and the unit."""
    stem, _, extreme = re.fullmatch(r"(.*?)(_(max|min))?", column).groups()
    words, _, ending = stem.rpartition("_")
    if not words or ending not in UNITS:
        return column, ""
    return f"{words} {extreme}" if extreme else words, UNITS[ending]


def number(value) -> str:
    """Four significant digits; words stay words, nothing becomes a dash."""
    if isinstance(value, bool) or isinstance(value, str):
        return str(value)
    if value is None or not math.isfinite(value):
        return "–"
    if value == int(value) and abs(value) < 1e6:
        return str(int(value))
    return f"{value:.4g}"
