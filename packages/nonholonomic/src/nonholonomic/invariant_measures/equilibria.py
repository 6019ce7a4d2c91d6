"""Equilibria that exclude an invariant measure.

Where a field f vanishes, the flow fixes the point and multiplies nearby volumes by exp(t tr Df).
An invariant measure with a continuous positive density there requires tr Df = 0, where the trace is
that on the phase space.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.formulas.array_evaluation import values
from flowlanes.printing.formula import text
from flowlanes.system.system import System

#: Number of candidate points, and the largest rate in doubles at which a candidate is verified
#: exactly.
_MOST_POINTS, _SMALL = 729, 1e-9


@dataclass(frozen=True)
class EquilibriumObstruction:
    """An equilibrium near which volumes change.

    Attributes
    ----------
    system : System
    point : tuple of sympy.Expr
        The equilibrium, in flat order.
    trace : sympy.Expr
        Trace of the linearisation on the phase space, at the default parameters; not zero.

    Examples
    --------
    >>> import flowlanes
    >>> import nonholonomic
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> damped = flowlanes.System("damped", "Damped oscillator", {x: v, v: -x - v / 10})
    >>> nonholonomic.invariant_measures.equilibrium_obstruction(damped).point
    (0, 0)
    """

    system: System
    point: tuple[sp.Expr, ...]
    trace: sp.Expr

    def __str__(self) -> str:
        place = ", ".join(
            f"{text(s)} = {text(x)}" for s, x in zip(self.system.symbols, self.point, strict=True)
        )
        return (
            f"no invariant measure has a density that is continuous and positive everywhere: at "
            f"the equilibrium {place} it would need a linearisation of trace 0, and the trace is "
            f"{text(self.trace)}"
        )


@arguments_checked
def equilibrium_obstruction(system: System) -> EquilibriumObstruction | None:
    """An equilibrium that excludes an invariant measure with a continuous, positive density.

    Parameters
    ----------
    system : System
        The system at its default parameters, taken as exact decimals.

    Returns
    -------
    EquilibriumObstruction or None
        None is no proof of existence: only points with coordinates −1, 0 and 1 are tried, or, if
        these are too many, the origin and its neighbours on the axes.

    Raises
    ------
    InputError
        If the argument is not a System.

    Examples
    --------
    >>> import flowlanes
    >>> import nonholonomic
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> damped = flowlanes.System("damped", "Damped oscillator", {x: v, v: -x - v / 10})
    >>> nonholonomic.invariant_measures.equilibrium_obstruction(damped).trace
    -1/10
    """
    numbers = {s: sp.Rational(str(x)) for s, x in system.defaults.items()}
    rates = sp.Matrix([system.expand(rate) for rate in system.rates])
    relations = sp.Matrix([system.expand(relation) for relation in system.relations])
    for point in _points(len(system.symbols)):
        if not _is_small(system, point):
            continue
        place = dict(zip(system.symbols, point, strict=True)) | numbers
        trace = _trace_at(rates, relations, system.symbols, place)
        if trace is not None and trace.is_nonzero:
            return EquilibriumObstruction(system, point, trace)
    return None


def _points(size: int) -> Iterator[tuple[sp.Expr, ...]]:
    digits = (sp.S.Zero, sp.S.One, sp.S.NegativeOne)
    if len(digits) ** size <= _MOST_POINTS:
        yield from itertools.product(digits, repeat=size)
        return
    yield (sp.S.Zero,) * size
    for i, sign in itertools.product(range(size), digits[1:]):
        yield tuple(sign if j == i else sp.S.Zero for j in range(size))


def _is_small(system: System, point: tuple[sp.Expr, ...]) -> bool:
    """Whether rates and relations are nearly zero at a point."""
    rows = values(system, [*system.rates, *system.relations], [[float(x) for x in point]])
    return bool((abs(rows) < _SMALL).all())


def _trace_at(
    rates: sp.Matrix,
    relations: sp.Matrix,
    symbols: tuple[sp.Symbol, ...],
    place: dict[sp.Symbol, sp.Expr],
) -> sp.Expr | None:
    """The trace on the phase space at an equilibrium; None at other or singular points."""
    there = [sp.simplify(f.subs(place)) for f in (*rates, *relations)]
    if not all(value.is_zero for value in there):
        return None
    jacobian = rates.jacobian(symbols).subs(place)
    trace = jacobian.trace()
    if len(relations):
        normal = relations.jacobian(symbols).subs(place)
        gram = normal * normal.T
        if gram.det().is_zero is not False:
            return None
        # The linearisation maps tangent vectors to tangent vectors, and acts on the quotient by
        # this matrix.
        trace -= (normal * jacobian * normal.T * gram.inv()).trace()
    return sp.simplify(trace)
