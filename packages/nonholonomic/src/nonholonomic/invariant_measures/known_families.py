"""Families of bodies known to have an invariant measure, as conditions on their parameters.

Each family is a level in the parameters; that the 1-form is closed there is proved again for every
body. docs/measures.md has the theorems and their proofs.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

import sympy as sp

from flowlanes.parsing.exact_decimals import exact_number
from flowlanes.system.system import Parameter
from flowlanes.system.vectors import Diagonal, Vector, real_symbol

from ..mechanics.rolling.equations import RollingBody

Level = tuple[sp.Expr, ...]

I, c = Diagonal("I"), Vector("c")
m, R, a, delta = real_symbol("m"), real_symbol("R"), real_symbol("a"), real_symbol("delta")
b = tuple(real_symbol(f"b_{i}") for i in (1, 2, 3))
#: All principal moments are equal.
SPHERICAL: Level = (I.symbols[0] - I.symbols[1], I.symbols[1] - I.symbols[2])
#: Groups of moments and lengths that may coincide.
_ALIKE = (I.symbols, b)


def collinearity() -> sp.Expr:
    """The determinant that vanishes if the points (I_i b_i², I_i − m b_i²) are collinear."""
    x = [i * s**2 for i, s in zip(I.symbols, b, strict=True)]
    y = [i - m * s**2 for i, s in zip(I.symbols, b, strict=True)]
    return sp.expand(sp.Add(*(x[i - 1] * y[i] - x[i] * y[i - 1] for i in range(3))))


def levels(rolling: RollingBody, parameters: Sequence[Parameter]) -> Iterator[Level]:
    """Levels that contain the parameters of the body, the most general ones first."""
    values = {p.symbol: exact_number(p.default) for p in parameters}
    yield ()
    for level in (SPHERICAL, coincidences(values), *_special(rolling)):
        known = all(e.free_symbols <= set(values) for e in level)
        if level and known and all(e.xreplace(values) == 0 for e in level):
            yield level
    yield tuple(s - v for s, v in values.items())


def coincidences(values: dict[sp.Symbol, sp.Rational]) -> Level:
    """The level of parameters that are zero and of moments or lengths that coincide."""
    zeros = [s for s, v in values.items() if v == 0]
    equal = []
    for group in _ALIKE:
        known = [s for s in group if s in values and values[s] != 0]
        seen: set[sp.Rational] = set()
        for first, second in combinations(known, 2):
            if values[first] == values[second] and second not in seen:
                seen.add(second)
                equal.append(first - second)
    return (*zeros, *equal)


def _special(rolling: RollingBody) -> tuple[Level, ...]:
    """Levels of the families of bodies with this shape."""
    shape, rubber = rolling.body.shape, rolling.contact == "rubber"
    plane = rolling.surface.is_flat
    if shape.is_ball and rubber and not plane:
        return ((a - shape.gauss().support,),)
    if shape.is_ellipsoid and not any(shape.centre) and not shape.is_turned:
        shifted = tuple(i - m * s**2 for i, s in zip(I.symbols, b, strict=True))
        along = (shifted[0] - shifted[1], shifted[1] - shifted[2])
        return ((collinearity(),), along) if rubber and plane else (along,)
    return ()


_SPHERICAL = "of equal principal moments of inertia (whatever its shape and centre of mass)"


def criterion(rolling: RollingBody) -> str:
    """The theorem about all bodies of this shape, contact and surface, as a sentence."""
    shape, rubber = rolling.body.shape, rolling.contact == "rubber"
    plane = rolling.surface.is_flat
    contact = f"a {rolling.contact}"
    where = f"a {rolling.surface.kind}"
    centred = not any(shape.centre)
    if shape.is_ball:
        equal = "" if plane or not rubber else ", or the sphere is as large as the ball (R = a)"
        return (
            f"{contact} ball on {where} has such a measure if and only if its centre is its "
            "centre of mass, or the line through both is an axis of dynamical symmetry" + equal
        )
    if shape.is_ellipsoid and centred and plane and not rubber:
        return (
            f"{contact} ellipsoid on {where}, its centre being its centre of mass, has such a "
            f"measure if and only if it is {_SPHERICAL}, or a ball, or a body of revolution with "
            "its inertia, or its semi-axes are principal axes of inertia and the three "
            "differences I_i − m b_i² agree"
        )
    if shape.is_ellipsoid and centred and plane:
        return (
            f"{contact} ellipsoid on {where}, its centre being its centre of mass, has such a "
            "measure if and only if its semi-axes are principal axes of inertia and the three "
            "points (I_i b_i², I_i − m b_i²) lie on a line"
        )
    revolution = f"{contact} body on {where} has such a measure if it is a body of revolution"
    revolution += " with its inertia"
    if rubber and not plane:
        return revolution
    return f"{revolution}, or {_SPHERICAL}"
