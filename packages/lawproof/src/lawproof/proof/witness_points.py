"""Points of certificates: rational numbers, roots and formulas."""

from __future__ import annotations

import contextlib
from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp
from flint import arb, fmpq

from certificate_checker import CheckError
from certificate_checker.certificate_points import failing
from certificate_checker.claim.claim import Claim as CheckedClaim
from flowlanes.formulas.errors import NotExactError
from flowlanes.formulas.jets import Evaluator
from flowlanes.formulas.number_fields import Balls, Rationals
from flowlanes.system.formula_text import short_text

from .level.level_set import LevelSet
from .level.polynomial_problems import Claim
from .level.sample_points import number_text


def witness_point(
    claim: Claim, level: LevelSet, values: Mapping[str, fmpq | arb]
) -> dict[str, object] | None:
    """State and parameters of a system at a point; None if one of them has no formula.

    Parameters
    ----------
    claim : Claim
        The claim in the variables of the proof.
    level : LevelSet
        A component of its level.
    values : mapping of str to number
        The generators at the point, rational if possible.
    """
    rational = Rationals({n: v for n, v in values.items() if isinstance(v, fmpq)})
    evaluate = level.evaluator(rational)
    coordinates: dict[sp.Symbol, object] = {}
    for symbol in level.symbols:
        if isinstance(values.get(str(symbol)), fmpq):
            coordinates[symbol] = str(values[str(symbol)])
            continue
        # Values that depend on irrational numbers are skipped here.
        with contextlib.suppress(KeyError, NotExactError, ZeroDivisionError):
            coordinates[symbol] = str(evaluate.value(symbol))
    by_name = {str(s): s for s in level.symbols}
    roots = level.roots(values)
    for name, root in roots.items():
        if name in by_name and by_name[name] not in coordinates:
            coordinates[by_name[name]] = {"root": root}
    for symbol in level.symbols:
        if symbol not in coordinates and symbol in level.fixed_parameters:
            coordinates[symbol] = {"formula": short_text(level.fixed_parameters[symbol])}
    if set(level.symbols) - set(coordinates):
        return None
    return _original(claim, coordinates, level.evaluator(Balls(values)))


def point_shown(claim: Claim, level: LevelSet, field: Rationals | Balls) -> dict[str, str]:
    """Texts of state and parameters of a system at a point."""
    point = level.point_shown(field)
    for angle, sine, cosine, unit in claim.circles:
        evaluate = level.evaluator(Balls(field.values))
        s, c, multiple = (evaluate.value(formula) for formula in (sine, cosine, unit))
        # atan2 needs a definite quadrant; on the branch cut the angle is π.
        radians = arb.pi() if 0 in s and c < 0 else arb.atan2(s, c)
        del point[str(sine)], point[str(cosine)]
        point[str(angle)] = number_text(radians / multiple)
    return point


def _angle(sine: object, cosine: object, s: arb, c: arb) -> str | None:
    """An angle as a formula, from sine and cosine as text and as numbers."""
    if sine == "0" or cosine in ("1", "-1"):
        return "0" if c > 0 else "pi"
    if isinstance(sine, str) and isinstance(cosine, str):
        return f"atan2({sine}, {cosine})"
    if isinstance(sine, str):
        return f"asin({sine})" if c > 0 else f"pi - asin({sine})"
    if isinstance(cosine, str):
        return f"acos({cosine})" if s > 0 else f"-acos({cosine})"
    return None


def _original(
    claim: Claim, coordinates: Mapping[sp.Symbol, object], evaluate: Evaluator
) -> dict[str, object] | None:
    """The point in the variables of the system, with angles and eliminated variables."""
    point = dict(coordinates)
    for angle, sine, cosine, unit in claim.circles:
        s, c = (evaluate.value(symbol) for symbol in (sine, cosine))
        value = _angle(point.pop(sine), point.pop(cosine), s, c)
        if value is None:
            return None
        point[angle] = {"formula": value if unit == 1 else f"({value})/({unit})"}
    for symbol, formula in claim.expressions:
        point[symbol] = {"formula": short_text(formula)}
    # The root of one polynomial may be needed by another: rational numbers come first.
    ordered = sorted(point.items(), key=lambda pair: not isinstance(pair[1], str))
    return {str(symbol): value for symbol, value in ordered}


@dataclass(frozen=True)
class Witness:
    """A point at which a law fails, confirmed by the certificate checker.

    Attributes
    ----------
    place : mapping
        The point in the format of a certificate.
    index : int
        Index of the first residual that is not zero there.
    value : str
        The value of that residual.
    """

    place: dict[str, object]
    index: int
    value: str


def witness(
    read: CheckedClaim, claim: Claim, level: LevelSet, values: Mapping[str, fmpq | arb]
) -> Witness:
    """A point at which a law fails according to the certificate checker.

    Raises
    ------
    CheckError
        If the law does not fail there according to the checker; the error says why.
    """
    point = witness_point(claim, level, values)
    if point is None:
        raise CheckError("the coordinates of the point cannot be written")
    return Witness(point, *failing(read, point))
