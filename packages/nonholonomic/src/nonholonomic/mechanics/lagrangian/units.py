"""Units of momenta and multipliers of a mechanism, from the units of its parameters.

Every term of the kinetic energy is an energy. A term c s² with a coefficient c of known unit gives
the unit of the velocity s, and so that of a coordinate whose rate is s; such coordinates may occur
in the coefficients of other velocities. A multiplier times ∂f/∂s times s is a power.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from typing import TypeAlias

import sympy as sp

from flowlanes.system.system import Parameter

from .mechanism import Mechanism

#: Exponents of kg, m and s.
Dimension: TypeAlias = tuple[Fraction, ...]


def _dimension(kg: int = 0, m: int = 0, s: int = 0) -> Dimension:
    return Fraction(kg), Fraction(m), Fraction(s)


_NONE, _ENERGY, _POWER = _dimension(), _dimension(1, 2, -2), _dimension(1, 2, -3)
_FORCE = _dimension(1, 1, -2)
_UNITS = {
    "1": _NONE,
    "rad": _NONE,
    "kg": _dimension(1),
    "m": _dimension(m=1),
    "s": _dimension(s=1),
    "N": _FORCE,
    "J": _ENERGY,
    "Hz": _dimension(s=-1),
}
_FACTOR = re.compile(r"(\w+?)(?:\^(-?\d+))?")


def momentum_units(mechanism: Mechanism) -> dict[sp.Symbol, str]:
    """The unit of ∂L/∂s for every velocity s; empty if the parameters do not determine it."""
    known = _dimensions(mechanism)
    return {
        s: _text(_times(_ENERGY, known[s], -1)) if s in known else "" for s in mechanism.frame.w
    }


def multiplier_units(mechanism: Mechanism) -> tuple[str, ...]:
    """The unit of the multiplier of each constraint, velocity constraints first.

    The reaction along the velocity s is λ ∂f/∂s, so that λ s ∂f/∂s is a power; for a constraint
    F(q) = 0, which is kept by Ḟ = 0, the product λ q ∂F/∂q is an energy.  Empty text where the
    parameters do not determine the unit, or terms of the constraint contradict each other.
    """
    known = _dimensions(mechanism)
    frame = mechanism.frame
    return (
        *(_unit_of_multiplier(mechanism.expand(f), frame.w, _POWER, known) for f in mechanism.f),
        *(
            _unit_of_multiplier(mechanism.expand(F), frame.coordinates, _ENERGY, known)
            for F in mechanism.F
        ),
    )


def _unit_of_multiplier(
    constraint: sp.Expr,
    variables: Iterable[sp.Symbol],
    product: Dimension,
    dimensions: Mapping[sp.Symbol, Dimension],
) -> str:
    """The unit of λ that makes λ s ∂f/∂s have the dimension of `product`."""
    found = set()
    for s in variables:
        for term in sp.Add.make_args(sp.expand(sp.diff(constraint, s))):
            slope = _of_term(term, dimensions)
            if s in dimensions and slope is not None:
                found.add(_times(_times(product, dimensions[s], -1), slope, -1))
    if len(found) != 1:
        return ""
    (dimension,) = found
    return {_FORCE: "N", _ENERGY: "N m"}.get(dimension) or _text(dimension)


def _dimensions(mechanism: Mechanism) -> dict[sp.Symbol, Dimension]:
    """The dimensions of parameters, velocities and coordinates, where known."""
    known = _with_units(mechanism.parameters)
    while velocities := dict(_velocities(mechanism, known)):
        known |= velocities
        coordinates = zip(mechanism.frame.coordinates, mechanism.frame.qdot, strict=True)
        known |= {q: _times(known[w], _UNITS["s"]) for q, w in coordinates if w in velocities}
    return known


def _velocities(
    mechanism: Mechanism, dimensions: Mapping[sp.Symbol, Dimension]
) -> Iterator[tuple[sp.Symbol, Dimension]]:
    """Velocities not in `dimensions` whose square has a coefficient of known unit."""
    for s in mechanism.frame.w:
        if s in dimensions:
            continue
        for term in sp.Add.make_args(sp.expand(sp.diff(mechanism.L, s, 2))):
            coefficient = _of_term(term, dimensions)
            if coefficient is not None:
                half = Fraction(1, 2)
                yield s, tuple(half * (a - b) for a, b in zip(_ENERGY, coefficient, strict=True))
                break


def _of_term(term: sp.Expr, dimensions: Mapping[sp.Symbol, Dimension]) -> Dimension | None:
    """The dimension of a product of powers; None if that of a factor is unknown."""
    if term == 0:
        return None
    total = _NONE
    for factor in sp.Mul.make_args(term):
        base, exponent = factor.as_base_exp()
        if base.is_number or isinstance(base, sp.sin | sp.cos):
            continue
        if base not in dimensions or not exponent.is_Rational:
            return None
        total = _times(total, dimensions[base], Fraction(int(exponent.p), int(exponent.q)))
    return total


def _times(one: Dimension, other: Dimension, power: Fraction | int = 1) -> Dimension:
    return tuple(a + power * b for a, b in zip(one, other, strict=True))


def _with_units(parameters: Iterable[Parameter]) -> dict[sp.Symbol, Dimension]:
    """The dimensions of parameters whose unit is declared and known."""
    dimensions = ((parameter.symbol, _read(parameter.unit)) for parameter in parameters)
    return {symbol: value for symbol, value in dimensions if value is not None}


def _read(unit: str) -> Dimension | None:
    """The dimension of a unit such as ``kg m^2/s``; None if it is not known."""
    total = _NONE
    for place, part in enumerate(unit.split("/")):
        for word in part.strip("()").split():
            match = _FACTOR.fullmatch(word)
            if match is None or match[1] not in _UNITS:
                return None
            power = int(match[2] or 1)
            total = _times(total, _UNITS[match[1]], -power if place else power)
    return total if unit else None


def _text(dimension: Dimension) -> str:
    """The text of a unit; empty if an exponent is not an integer."""
    if any(exponent.denominator != 1 for exponent in dimension):
        return ""
    above: list[str] = []
    below: list[str] = []
    for name, exponent in zip(("kg", "m", "s"), dimension, strict=True):
        if exponent:
            power = "" if abs(exponent) == 1 else f"^{abs(exponent)}"
            (above if exponent > 0 else below).append(f"{name}{power}")
    under = f"/{below[0]}" if len(below) == 1 else f"/({' '.join(below)})" if below else ""
    return f"{' '.join(above) or '1'}{under}"
