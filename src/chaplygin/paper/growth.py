"""The span of vector fields and their commutators, by exact ranks at a rational point."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence

import sympy as sp

from ..laws.verdict import Verdict

__all__ = ["Field", "along", "commutator", "counted", "growth"]

Field = Mapping[sp.Symbol, sp.Expr]
Point = Mapping[sp.Symbol, sp.Expr]


def along(field: Field, function: sp.Expr) -> sp.Expr:
    """A field applied to a function."""
    return sp.Add(*(value * sp.diff(function, symbol) for symbol, value in field.items()))


def commutator(first: Field, second: Field, coordinates: Sequence[sp.Symbol]) -> Field:
    """[u, w] = uw − wu; components that are not named are zero."""
    none = sp.S.Zero
    return {
        s: sp.expand(along(first, second.get(s, none)) - along(second, first.get(s, none)))
        for s in coordinates
    }


def _rank(fields: Sequence[Field], coordinates: Sequence[sp.Symbol], point: Point) -> int:
    rows = [
        [field.get(s, sp.S.Zero).xreplace(dict(point)) for s in coordinates] for field in fields
    ]
    return int(sp.Matrix(rows).rank())


def growth(
    fields: Sequence[Field], coordinates: Sequence[sp.Symbol], point: Point
) -> tuple[int, ...]:
    """Dimensions of the span of fields, with their commutators, with those of these, and so on.

    Parameters
    ----------
    fields : sequence of mapping from coordinate to component
    coordinates : sequence of Symbol
        They may be redundant; the fields are then tangent to the relations between them.
    point : mapping of Symbol to exact number
        Coordinates and parameters.

    Returns
    -------
    tuple of int
        Until the dimension is reached a second time.
    """
    span, last = list(fields), list(fields)
    found = [_rank(span, coordinates, point)]
    while len(found) < 2 or found[-1] > found[-2]:
        last = [commutator(u, w, coordinates) for u in fields for w in last]
        span += last
        found.append(_rank(span, coordinates, point))
    return tuple(found)


def counted(claimed: int, counts: tuple[int, ...], dimension: int, started: float) -> Verdict:
    """The verdict on a number of holonomic constraints, from the growth of a distribution.

    A function F with η(F) = 0 for every admissible field has dF annul their commutators too, so
    that there are as many independent ones as the dimension exceeds that of the span.

    Parameters
    ----------
    claimed : int
        How many independent holonomic constraints there are said to be.
    counts : tuple of int
        As from `growth`.
    dimension : int
        Of the configuration space.
    started : float
        Monotonic time at which the computation began.
    """
    true = dimension - counts[-1]
    return Verdict(
        "holonomic_constraints",
        "proven" if claimed == true else "refuted",
        shown=f"the span grows as {', '.join(map(str, counts))} in dimension {dimension}: "
        f"{true} holonomic constraints",
        seconds=time.monotonic() - started,
        witness=None if claimed == true else {"claimed": claimed, "true": true},
    )
