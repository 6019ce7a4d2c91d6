"""Separable systems put to the test: along motions of 34 digits, and with slips in them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache
from typing import Any

import mpmath
import sympy as sp

from flowlanes.flow.integrator import integrate
from flowlanes.system.laws import Law
from flowlanes.system.system import System
from flowlanes.system.vectors import cross, to_components
from nonholonomic.closed_form.genus_two.separation import SeparatedSystem, nu, nuprime
from nonholonomic.closed_form.genus_two.separation_laws import separation_laws

DIGITS = 34

Values = dict[sp.Symbol, Any]


def states(
    system: System, start: Sequence[Any], parameters: Mapping[str, Any], until: int = 20
) -> list[Values]:
    """State, definitions and parameters at a few moments of a motion, as mpmath numbers."""
    bare = replace(system, reconstruction=None, observables=())
    with mpmath.workdps(DIGITS):
        motion = integrate(
            bare, start, range(0, until, until // 10), parameters=parameters, precision="quad"
        )
        known = {p.symbol: mpmath.mpf(parameters[str(p.symbol)]) for p in system.parameters}
        found = []
        for row in motion.states:
            values = {**known, **dict(zip(system.symbols, map(_number, row), strict=True))}
            for symbol, formula in system.scalar_definitions:
                values[symbol] = at(formula, values)
            found.append(values)
    return found


def at(formula: Any, values: Mapping[sp.Symbol, Any]) -> Any:
    """A scalar formula with numbers put in."""
    symbols, function = _function(sp.sympify(formula))
    return mpmath.mpf(function(*(values[s] for s in symbols)))


def located(separable: SeparatedSystem, values: Values) -> Values:
    """The values with the constants, ν and ν′."""
    known = dict(values)
    for symbol, formula in separable.constants:
        known[symbol] = at(formula, known)
    for name, formula in ((nu, separable.direction), (nuprime, separable.turning)):
        parts = to_components(formula)
        known |= {s: at(part, known) for s, part in zip(name.symbols, parts, strict=True)}
    return known


def abel_sums(separable: SeparatedSystem, known: Values) -> tuple[Any, Any]:
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


def follows(
    separable: SeparatedSystem, start: Sequence[Any], parameters: Mapping[str, Any], error: float
) -> None:
    """Assert all that a Separable says, along a motion, up to `error`."""
    motion = states(separable.system, start, parameters)
    with mpmath.workdps(DIGITS):
        begin = located(separable, motion[0])
        for values in motion:
            known = located(separable, values)
            for found, speed in zip(abel_sums(separable, known), separable.speeds, strict=True):
                assert abs(found - at(speed, known)) < error
            for symbol, _ in separable.constants:
                assert abs(known[symbol] - begin[symbol]) < error
            for symbol, value in restored(separable, known).items():
                assert abs(value - known[symbol]) < error
            assert at(separable.time_rescaling, known) > 0


def slips(separable: SeparatedSystem) -> Iterator[tuple[str, Law]]:
    """What a Separable would claim with one formula wrong; every one of the claims is false."""
    roots, (a, b), weights = separable.roots, separable.speeds, separable.weights
    wrong: dict[str, tuple[str, dict[str, Any]]] = {
        "leading": ("separation", {"leading": 2 * separable.leading}),
        "root": ("separation", {"roots": (*roots[:-1], 2 * roots[-1])}),
        "weight": ("separation", {"weights": (2 * weights[0], *weights[1:])}),
        "speed": ("separation", {"speeds": (a, 2 * b)}),
        "time_rescaling": ("direction", {"time_rescaling": 2 * separable.time_rescaling}),
        "state": ("reconstruction", {"state": tuple((n, 2 * v) for n, v in separable.state)}),
    }
    if separable.fixed:
        moving = cross(separable.fixed[0], separable.system.symbols[0] * separable.fixed[-1])
        wrong["fixed"] = ("fixed_1", {"fixed": (moving + separable.fixed[-1],)})
    for slip, (name, changes) in wrong.items():
        (law,) = (law for law in separation_laws(replace(separable, **changes)) if law.name == name)
        yield slip, law


def restored(separable: SeparatedSystem, known: Values) -> Values:
    """The state by the formulas in ν and ν′."""
    found: Values = {}
    for name, formula in separable.state:
        symbols = (name,) if isinstance(name, sp.Symbol) else name.symbols
        parts = to_components(formula)
        for symbol, part in zip(symbols, parts, strict=True):
            found[symbol] = at(part, known)
    return found


def _parabola(places: Sequence[Any], values: Sequence[Any]) -> tuple[Any, Any, Any]:
    """Coefficients of z², z, 1 of the parabola through three points."""
    matrix = mpmath.matrix([[e**2, e, 1] for e in places])
    solution = mpmath.lu_solve(matrix, mpmath.matrix(values))
    return solution[0], solution[1], solution[2]


@cache
def _function(formula: Any) -> tuple[list[sp.Symbol], Any]:
    written = to_components(formula)
    symbols = sorted(written.free_symbols, key=str)
    return symbols, sp.lambdify(symbols, written, "mpmath")


def _number(value: Any) -> Any:
    return mpmath.mpf(str(value))
