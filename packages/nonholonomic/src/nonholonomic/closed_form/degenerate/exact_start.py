"""The start of a motion of a separated system, in high precision.

The numbers of a start count as exact.  They are projected onto the phase space (and onto the level
of the separation) with far more digits than are requested for the motion.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import TypeAlias

import sympy as sp
from flint import arb

from flowlanes.arguments import NumberOrText
from flowlanes.formulas.balls import ball, ball_values, components
from flowlanes.formulas.relative_zero import vanishes
from flowlanes.system.tuple_vectors import dot

from ..base.exact_start import on_phase_space, with_definitions
from ..genus_two.separation import SeparatedSystem

Balls: TypeAlias = tuple[arb, ...]

#: Precision in bits of a start.
PRECISION = 420


@dataclass(frozen=True)
class ExactStart:
    """The quantities of a separable system at the start of a motion.

    Attributes
    ----------
    values : mapping of Symbol to arb
        Parameters and constants.
    state : tuple of arb
        The reduced state, in flat order, on the phase space.
    nu, nuprime : tuples of three arb
        ν and ν′.
    poles, weights, roots, speeds : tuples of arb
    along : (arb, arb)
        The speeds of the flow along which ν′ is the derivative.
    leading : arb
    total, product : (arb, arb)
        z₁ + z₂ and z₁z₂, each with its derivative along that flow.
    """

    values: Mapping[sp.Symbol, arb]
    state: Balls
    nu: Balls
    nuprime: Balls
    poles: Balls
    weights: Balls
    roots: Balls
    speeds: Balls
    along: Balls
    leading: arb
    total: tuple[arb, arb]
    product: tuple[arb, arb]

    def separating(self, e: arb) -> arb:
        """(e − z₁)(e − z₂)."""
        return e * e - e * self.total[0] + self.product[0]

    @property
    def size(self) -> arb:
        """The largest modulus of a root: the unit in which roots are compared."""
        return max(abs(root) for root in self.roots)

    @property
    def double_roots(self) -> list[tuple[arb, list[arb]]]:
        """The double roots of the curve, each with the roots that remain without it.

        Poles come first in the list of roots, so a collision with a pole counts as located at the
        pole.
        """
        return [
            (one, [*self.roots[:i], *self.roots[i + 1 : j], *self.roots[j + 1 :]])
            for (i, one), (j, other) in combinations(enumerate(self.roots), 2)
            if vanishes((one - other).mid(), self.size)
        ]


def exact_start(
    separable: SeparatedSystem,
    values: Mapping[sp.Symbol, NumberOrText],
    start: Sequence[NumberOrText],
) -> ExactStart:
    """The quantities of a separable system at a start; requires sufficient working precision.

    Parameters
    ----------
    separable : SeparatedSystem
    values : mapping of Symbol to number
        The parameters of its system.
    start : sequence of numbers
        The state, reduced or lifted, in flat order; floats are taken as the decimals that they are
        written as.
    """
    system = separable.system
    exact = {symbol: ball(value) for symbol, value in values.items()}
    reduced = [ball(x) for x in start[: len(system.symbols)]]
    state = on_phase_space(system, separable.level, reduced, exact)
    known = with_definitions(system, exact, state)
    for symbol, formula in separable.constants:
        (known[symbol],) = ball_values(components(formula), known)

    def numbers(formulas: Sequence[sp.Expr]) -> Balls:
        return tuple(ball_values(components(sp.Matrix(list(formulas))), known))

    poles, weights = numbers(separable.poles), numbers(separable.weights)
    nu = tuple(ball_values(components(separable.direction), known))
    nuprime = tuple(ball_values(components(separable.turning), known))
    total, product = _symmetric(poles, weights, nu, nuprime)
    (leading,) = numbers([separable.leading])
    names = {*values, *(symbol for symbol, _ in separable.constants)}
    return ExactStart(
        {symbol: value for symbol, value in known.items() if symbol in names},
        state,
        nu,
        nuprime,
        poles,
        weights,
        numbers(separable.roots),
        numbers(separable.speeds),
        numbers(separable.along or separable.speeds),
        leading,
        total,
        product,
    )


def _symmetric(
    poles: Balls, weights: Balls, nu: Balls, nuprime: Balls
) -> tuple[tuple[arb, arb], tuple[arb, arb]]:
    """z₁ + z₂ and z₁z₂ with their rates: νᵢ²/weightᵢ is proportional to (eᵢ − z₁)(eᵢ − z₂)."""
    shares, rates = [], []
    for i, own in enumerate(poles):
        gap = weights[i]
        for other in (*poles[:i], *poles[i + 1 :]):
            gap = gap * (own - other)
        shares.append(nu[i] * nu[i] / gap)
        rates.append(2 * nu[i] * nuprime[i] / gap)
    sums = [sum(poles, arb(0)) - own for own in poles]
    products = [poles[1] * poles[2], poles[2] * poles[0], poles[0] * poles[1]]

    def quotient(factors: list[arb]) -> tuple[arb, arb]:
        above, below = dot(shares, factors), sum(shares, arb(0))
        value = above / below
        return value, (dot(rates, factors) - value * sum(rates, arb(0))) / below

    return quotient(sums), quotient(products)
