"""Where a motion of a separated system begins, in numbers of high precision.

A start is a row of numbers that are taken exactly and moved onto the phase space (and onto the
level of the separation) to far more digits than are asked of the motion.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp
from flint import arb, ctx

from ...formulas.balls import ball, components, evaluated
from ..base.exact_start import on_phase_space
from ..genus_two.separation import SeparatedSystem

__all__ = ["PRECISION", "Beginning", "begin", "constants_of"]

#: Bits in which starts are worked out.
PRECISION = 420


@dataclass(frozen=True)
class Beginning:
    """A separable system with all its numbers, at the beginning of a motion.

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

    values: Mapping[sp.Symbol, Any]
    state: tuple[Any, ...]
    nu: tuple[Any, ...]
    nuprime: tuple[Any, ...]
    poles: tuple[Any, ...]
    weights: tuple[Any, ...]
    roots: tuple[Any, ...]
    speeds: tuple[Any, ...]
    along: tuple[Any, ...]
    leading: Any
    total: tuple[Any, Any]
    product: tuple[Any, Any]

    def separating(self, e: Any) -> Any:
        """(e − z₁)(e − z₂)."""
        return e * e - e * self.total[0] + self.product[0]

    @property
    def size(self) -> Any:
        """The largest modulus of a root: the unit in which roots are told apart."""
        return max(abs(root) for root in self.roots)


def constants_of(
    separable: SeparatedSystem, state: Sequence[Any], values: Mapping[Any, Any]
) -> Any:
    """Values of the state, the definitions, parameters and constants of a separable system.

    Parameters
    ----------
    separable : Separable
    state : sequence of arb
        The reduced state.
    values : mapping of Symbol to arb
        The parameters.
    """
    known = {**values, **dict(zip(separable.system.symbols, state, strict=True))}
    for symbol, formula in separable.system.steps:
        (known[symbol],) = evaluated([formula], known)
    for symbol, formula in separable.constants:
        (known[symbol],) = evaluated(components(formula), known)
    return known


def begin(separable: SeparatedSystem, values: Mapping[Any, Any], start: Sequence[Any]) -> Beginning:
    """A separable system at a start.

    Parameters
    ----------
    separable : Separable
    values : mapping of Symbol to number
        The parameters of its system.
    start : sequence of numbers
        The state, reduced or lifted, in flat order; floats are taken as the decimals that they are
        written as.
    """
    with ctx.workprec(PRECISION):
        return _begin(separable, values, start)


def _begin(
    separable: SeparatedSystem, values: Mapping[Any, Any], start: Sequence[Any]
) -> Beginning:
    system = separable.system
    given = [ball(x) for x in start[: len(system.symbols)]]
    exact = {symbol: ball(value) for symbol, value in values.items()}
    state = on_phase_space(system, separable.level, given, exact)
    known = constants_of(separable, state, exact)

    def numbers(formulas: Any) -> tuple[Any, ...]:
        return tuple(evaluated(components(sp.Matrix(list(formulas))), known))

    poles, weights = numbers(separable.poles), numbers(separable.weights)
    nu = tuple(evaluated(components(separable.direction), known))
    nuprime = tuple(evaluated(components(separable.turning), known))
    total, product = _symmetric(poles, weights, nu, nuprime)
    (leading,) = numbers([separable.leading])
    names = {*values, *(symbol for symbol, _ in separable.constants)}
    return Beginning(
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


def _symmetric(poles: Any, weights: Any, nu: Any, nuprime: Any) -> tuple[Any, Any]:
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

    def quotient(factors: list[Any]) -> tuple[Any, Any]:
        above, below = (_weighted(shares, factors), sum(shares, arb(0)))
        value = above / below
        return value, (_weighted(rates, factors) - value * sum(rates, arb(0))) / below

    return quotient(sums), quotient(products)


def _weighted(numbers: list[Any], factors: list[Any]) -> Any:
    return sum((x * f for x, f in zip(numbers, factors, strict=True)), arb(0))
