"""Factors of which a multiplier may be made, in the tangents of half angles.

With t = tan(x/2) in place of every angle x all coefficients are rational, and polynomials have
unique factors.  A factor F of degree d in t is back in the angle as F/(1 + t²)^(d/2).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations_with_replacement
from typing import Any

import sympy as sp
from flint import fmpq, fmpq_mat

from ..vectors import Vector, scalar
from .reduction_exact import Formulas, Quotient, Value, as_formula, circle, product, quotients
from .reduction_lift import Lift

__all__ = ["Chart", "determinant", "in_angles", "natural_factors", "on_sphere"]

HIGHEST = 6
"""Degree in the unit vector up to which a factor is recognised."""


@dataclass(frozen=True)
class Chart:
    """The coordinates as rational functions of a pair of variables.

    Attributes
    ----------
    coordinates : tuple of Symbol
    variables : tuple of Symbol
        tan(x/2) for an angle x, and x itself for another coordinate.
    angles : tuple of bool
        Which coordinates are angles.
    """

    coordinates: tuple[sp.Symbol, sp.Symbol]
    variables: tuple[sp.Symbol, sp.Symbol]
    angles: tuple[bool, bool]

    @classmethod
    def of(cls, coordinates: tuple[sp.Symbol, sp.Symbol], used: Sequence[sp.Symbol]) -> Chart:
        """The chart for formulas that use the symbols given."""
        angles = tuple(bool(set(circle(q)) & set(used)) for q in coordinates)
        names = [scalar(f"t_{q}") if a else q for q, a in zip(coordinates, angles, strict=True)]
        return cls(coordinates, (names[0], names[1]), (angles[0], angles[1]))

    def point(self, values: Sequence[Value]) -> dict[sp.Symbol, Value]:
        """Coordinates, sines and cosines by the values of the variables."""
        found: dict[sp.Symbol, Value] = {}
        for q, angle, t in zip(self.coordinates, self.angles, values, strict=True):
            if angle:
                sine, cosine = circle(q)
                square = t * t + 1
                found[sine], found[cosine] = 2 * t / square, (2 - square) / square
            else:
                found[q] = t
        return found

    def speed(self, index: int, value: Value) -> Value:
        """Derivative of the variable by its coordinate."""
        return (value * value + 1) / 2 if self.angles[index] else value * 0 + 1


def determinant(rows: Sequence[Sequence[Value]]) -> Value:
    """By the first row."""
    if len(rows) == 1:
        return rows[0][0]
    total = rows[0][0] * 0
    for j, entry in enumerate(rows[0]):
        if entry != 0:
            minor = determinant([[x for k, x in enumerate(row) if k != j] for row in rows[1:]])
            total = total + (-1) ** j * entry * minor
    return total


def _adjugate(rows: Sequence[Sequence[Value]]) -> list[list[Value]]:
    size = range(len(rows))
    return [
        [
            (-1) ** (i + j)
            * determinant([[rows[r][c] for c in size if c != i] for r in size if r != j])
            for j in size
        ]
        for i in size
    ]


def natural_factors(
    lift: Lift,
    forms: Sequence[sp.Matrix],
    chart: Chart,
    parameters: Sequence[sp.Symbol],
    owner: str,
) -> list[Any]:
    """Irreducible polynomials in the variables of the chart that the system itself brings along.

    They divide the determinants of K, of the quadratic forms Q given, and of Q on the velocities
    that integrals and constraints tie; 1 + t² is not among them.
    """
    one, names = quotients([*chart.variables, *parameters])
    place = {**names, **chart.point([names[t] for t in chart.variables])}

    def matrix(formulas: sp.Matrix) -> list[list[Quotient]]:
        values = Formulas(list(formulas), owner).at(place, one)
        return [values[i : i + formulas.cols] for i in range(0, len(values), formulas.cols)]

    found = [determinant(matrix(lift.matrix))]
    tied = matrix(lift.tied) if lift.tied.rows else []
    for form in forms:
        rows = matrix(form)
        found.append(determinant(rows))
        if tied:
            turned = [product(_adjugate(rows), row) for row in tied]
            found.append(determinant([product(tied, column) for column in turned]))
    circles = {str(t * t + 1) for t in (names[v].above for v in chart.variables)}
    factors: dict[str, Any] = {}
    for value in found:
        for poly in (value.above, value.below):
            for factor, _ in poly.factor()[1]:
                lead = factor.leading_coefficient()
                if any(factor.degrees()[:2]) and str(factor / lead) not in circles:
                    factors[str(factor / lead)] = factor / lead
    return list(factors.values())


def in_angles(poly: Any, chart: Chart) -> sp.Expr:
    """A polynomial of even degrees as F/(1 + t²)^(d/2) in sines and cosines."""
    degrees = [int(d) for d in poly.degrees()[:2]]
    names = [scalar(n) for n in poly.context().names()]
    total = sp.S.Zero
    for exponents, c in poly.to_dict().items():
        term = sp.Rational(int(c.p), int(c.q))
        for i, exponent in enumerate(exponents):
            power = int(exponent)
            if i < 2 and chart.angles[i]:
                odd, half, whole = power % 2, power // 2, degrees[i] // 2
                x = chart.coordinates[i]
                term *= ((1 - sp.cos(x)) / 2) ** half * (sp.sin(x) / 2) ** odd
                term *= ((1 + sp.cos(x)) / 2) ** (whole - half - odd)
            else:
                term *= names[i] ** power
        total += term
    # up to a number; every sine occurs to the first power at most
    return sp.primitive(sp.expand(total))[1]


def on_sphere(poly: Any, chart: Chart, vector: Vector) -> sp.Expr | None:
    """A polynomial of even degrees, over the powers of 1 + t², as a form in the unit vector.

    None if it is not one of a degree up to `HIGHEST`.
    """
    ring = poly.context()
    for degree in range(1, HIGHEST + 1):
        powers = list(combinations_with_replacement(range(3), degree))
        count = len(powers)
        rows, right = [], []
        for i in range(count + 3):
            t = [fmpq(2 * i + 3, i + 5), fmpq(i * i - 7, 3 * i + 2)]
            (s, c), (s2, c2) = _circles(t)
            unit = (s * s2, s * c2, c)
            rows.append([_power(unit, chosen) for chosen in powers])
            right.append(_over(poly, t))
        matrix = fmpq_mat(rows[:count])
        if matrix.det() == 0:
            continue
        solve = matrix.inv()
        found = [
            sum((solve[i, j] * right[j] for j in range(count)), ring.constant(0))
            for i in range(count)
        ]
        fits = all(
            sum((x * f for x, f in zip(row, found, strict=True)), ring.constant(0)) == value
            for row, value in zip(rows[count:], right[count:], strict=True)
        )
        if fits:
            terms = [
                as_formula(f) * sp.Mul(*(vector.symbols[i] for i in chosen))
                for f, chosen in zip(found, powers, strict=True)
            ]
            whole = sp.primitive(sp.expand(sp.Add(*terms)))[1]
            return sp.collect(
                whole, [sp.Mul(*(vector.symbols[i] for i in p)) for p in powers], sp.factor
            )
    return None


def _circles(t: Sequence[fmpq]) -> list[tuple[fmpq, fmpq]]:
    return [(2 * x / (1 + x * x), (1 - x * x) / (1 + x * x)) for x in t]


def _power(unit: Sequence[fmpq], chosen: Sequence[int]) -> fmpq:
    total = fmpq(1)
    for i in chosen:
        total *= unit[i]
    return total


def _over(poly: Any, t: Sequence[fmpq]) -> Any:
    """F/(1 + t²)^(d/2) at rational t, a polynomial in the parameters."""
    names = poly.context().names()
    value = poly.subs({names[0]: t[0], names[1]: t[1]})
    for x, degree in zip(t, poly.degrees()[:2], strict=True):
        value = value / (1 + x * x) ** (int(degree) // 2)
    return value
