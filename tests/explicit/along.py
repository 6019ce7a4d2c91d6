"""Separable systems along motions that were integrated with 34 digits."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import mpmath
import sympy as sp

from chaplygin.explicit.separable import Separable, nu, nuprime
from chaplygin.flow.trajectory import integrate
from chaplygin.system import System
from chaplygin.vectors import explicit

DIGITS = 34

Values = dict[sp.Symbol, Any]


def states(
    system: System, start: Sequence[Any], parameters: Mapping[str, Any], until: int = 20
) -> list[Values]:
    """State, definitions and parameters at a few moments of a motion, as mpmath numbers."""
    bare = replace(system, motion=None, observables=())
    with mpmath.workdps(DIGITS):
        motion = integrate(
            bare, start, range(0, until, until // 10), parameters=parameters, precision="quad"
        )
        known = {p.symbol: mpmath.mpf(parameters[str(p.symbol)]) for p in system.parameters}
        found = []
        for row in motion.states:
            values = {**known, **dict(zip(system.symbols, map(_number, row), strict=True))}
            for symbol, formula in system.steps:
                values[symbol] = at(formula, values)
            found.append(values)
    return found


def at(formula: Any, values: Mapping[sp.Symbol, Any]) -> Any:
    """A scalar formula with numbers put in."""
    symbols = sorted(explicit(sp.sympify(formula)).free_symbols, key=str)
    function = sp.lambdify(symbols, explicit(sp.sympify(formula)), "mpmath")
    return mpmath.mpf(function(*(values[s] for s in symbols)))


def located(separable: Separable, values: Values) -> Values:
    """The values with the constants, ν and ν′."""
    known = dict(values)
    for symbol, formula in separable.constants:
        known[symbol] = at(formula, known)
    for name, formula in ((nu, separable.direction), (nuprime, separable.turning)):
        parts = explicit(formula)
        known |= {s: at(part, known) for s, part in zip(name.symbols, parts, strict=True)}
    return known


def abel_sums(separable: Separable, known: Values) -> tuple[Any, Any]:
    """Σ z′/y and Σ zz′/y, with z from ν, z′ from ν′ and y from the curve.

    y is a root of the curve's polynomial, with the sign of z₁′(z₁ − z₂) and z₂′(z₂ − z₁).
    """
    poles = [at(e, known) for e in separable.poles]
    weights = [at(w, known) for w in separable.weights]
    values = [known[s] ** 2 / w for s, w in zip(nu.symbols, weights, strict=True)]
    slopes = [
        2 * known[s] * known[d] / w
        for s, d, w in zip(nu.symbols, nuprime.symbols, weights, strict=True)
    ]
    second, first, constant = _parabola(poles, values)
    moved = _parabola(poles, slopes)
    distance = mpmath.sqrt(first**2 - 4 * second * constant)
    sums = [mpmath.mpf(0), mpmath.mpf(0)]
    a, b = (at(speed, known) for speed in separable.speeds)
    roots = [(-first + sign * distance) / (2 * second) for sign in (1, -1)]
    for z, other in (roots, roots[::-1]):
        rate = -(moved[0] * z**2 + moved[1] * z + moved[2]) / (2 * second * z + first)
        square = at(separable.leading, known)
        for root in separable.roots:
            square *= z - at(root, known)
        y = mpmath.sqrt(square) * mpmath.sign(rate * (z - other) * (b - a * other))
        sums[0] += rate / y
        sums[1] += z * rate / y
    return sums[0], sums[1]


def restored(separable: Separable, known: Values) -> Values:
    """The state by the formulas in ν and ν′."""
    found: Values = {}
    for name, formula in separable.state:
        symbols = (name,) if isinstance(name, sp.Symbol) else name.symbols
        parts = explicit(formula)
        for symbol, part in zip(symbols, parts, strict=True):
            found[symbol] = at(part, known)
    return found


def _parabola(places: Sequence[Any], values: Sequence[Any]) -> tuple[Any, Any, Any]:
    """Coefficients of z², z, 1 of the parabola through three points."""
    matrix = mpmath.matrix([[e**2, e, 1] for e in places])
    solution = mpmath.lu_solve(matrix, mpmath.matrix(values))
    return solution[0], solution[1], solution[2]


def _number(value: Any) -> Any:
    return mpmath.mpf(str(value))
