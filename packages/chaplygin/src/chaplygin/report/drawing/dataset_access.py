"""Values, units and labels of a trajectory's dataset, for figures."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterable

import numpy as np
import xarray as xr
from matplotlib.mathtext import MathTextParser

from flowlanes.errors import InputError
from flowlanes.printing.formula import latex
from flowlanes.printing.symbol_names import GREEK
from flowlanes.system.arrays import FloatArray
from flowlanes.system.vectors import real_symbol

VARIABLES = {
    "scene": ("contact", "centre", "attitude", "gamma"),
    "contact_path": ("contact",),
    "normal_on_sphere": ("gamma",),
    "angular_velocity": ("omega",),
    "attitude": ("attitude",),
    "normal_force": ("normal_force",),
    "friction_ratio": ("normal_force", "friction_force"),
}
"""Variables required by each figure."""

NOTHING = 1e-9
"""Bound below which numbers count as zero and are not magnified."""

CURVE_POINTS = 1200
"""Number of points of a smooth path."""


def require(dataset: xr.Dataset, figure: str) -> None:
    """Raise InputError unless the dataset has what the figure needs."""
    require_all(dataset, figure, VARIABLES[figure])


def require_all(dataset: xr.Dataset, figure: str, names: Iterable[str]) -> None:
    """Raise InputError unless the dataset has all variables of these names."""
    missing = [name for name in names if name not in dataset]
    if missing:
        raise InputError(
            f"the figure {figure} needs {', '.join(missing)}, which the trajectory of "
            f"{title_of(dataset)} does not have"
        )


def title_of(dataset: xr.Dataset) -> str:
    """Title of the system."""
    return str(dataset.attrs.get("system", "this system"))


def values_of(dataset: xr.Dataset, name: str) -> FloatArray:
    """Values of a variable, time along the first axis."""
    return np.asarray(dataset[name].transpose("time", ...).values, dtype=np.float64)


def times_of(dataset: xr.Dataset) -> FloatArray:
    """Instants of the samples, shape (n,)."""
    return np.asarray(dataset["time"].values, dtype=np.float64)


def time_shares(times: FloatArray, since: float | None = None) -> FloatArray:
    """Fraction of elapsed time at each sample, from `since` or the first sample."""
    start = float(times[0]) if since is None else since
    span = float(times[-1]) - start
    return (times - start) / span if span != 0.0 else np.ones_like(times)


#: Superscript and subscript characters that the typeface of the figures lacks.
_SUPERSCRIPTS = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-", strict=True))
_SUBSCRIPTS = dict(zip("₀₁₂₃₄₅₆₇₈₉", "0123456789", strict=True))


def readable(text: str) -> str:
    """The text if its formulas can be typeset, otherwise with literal dollar signs.

    Superscript and subscript characters become exponents and indices.
    """
    text = re.sub(
        f"[{''.join(_SUPERSCRIPTS)}]+", lambda match: _script(match[0], "^", _SUPERSCRIPTS), text
    )
    text = re.sub(
        f"[{''.join(_SUBSCRIPTS)}]+", lambda match: _script(match[0], "_", _SUBSCRIPTS), text
    )
    try:
        MathTextParser("path").parse(text)
    except ValueError:
        return text.replace("$", r"\$")
    return text


def _script(characters: str, mark: str, table: dict[str, str]) -> str:
    return f"${mark}{{{''.join(table[c] for c in characters)}}}$"


#: A name with an index, or the name of a Greek letter: set as a symbol within a text.
_LETTER = re.compile(rf"\b(?:[A-Za-z]+_\w+|{'|'.join(GREEK)})\b")


def typeset(name: str) -> str:
    """A name as set in formulas: M_1 as M₁, gamma_3 as γ₃; words are unchanged."""
    if "/" in name:
        return "/".join(map(typeset, name.split("/")))
    letter = name.partition("_")[0]
    if len(letter) > 1 and letter not in GREEK:
        return readable(name.replace("_", " "))
    return f"${latex(real_symbol(name))}$"


#: First of the private-use characters.
_NOBODYS = 0xE000


def wrapped_text(text: str, width: int = 50) -> str:
    """A text in lines of about `width` characters, with names set as symbols."""
    names = list(map(typeset, _LETTER.findall(text)))
    # A name counts as one character wide: a private-use character replaces it.
    places = iter(range(_NOBODYS, _NOBODYS + len(names)))
    short = _LETTER.sub(lambda _: chr(next(places)), re.sub(r",(?=\S)", ", ", text))
    line = "\n".join(textwrap.wrap(short, width, break_long_words=False, break_on_hyphens=False))
    for place, name in enumerate(names, _NOBODYS):
        line = line.replace(chr(place), name)
    return "\n".join(map(readable, line.split("\n")))


def unit_of(dataset: xr.Dataset, name: str) -> str:
    """Unit of a variable with superscript exponents; empty if it is one or unknown."""
    units = str(dataset[name].attrs.get("units", "")).strip()
    if units in ("", "1", "unknown"):
        return ""
    return re.sub(r"(?:\*\*|\^)\{?(-?\d+)\}?", r"$^{\1}$", units).replace("*", r"$\,$")


def with_unit(text: str, units: str) -> str:
    """A text, and the unit in brackets if there is one."""
    return f"{text}  ({units})" if units else text
