"""Candidate factors of a multiplier, in the tangents of half angles.

With t = tan(x/2) for every angle x all coefficients are rational, and polynomials factor uniquely.
A factor F of degree d in t corresponds to F/(1 + t²)^(d/2) in the angle.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations_with_replacement

import sympy as sp
from flint import Ordering, fmpq, fmpq_mat, fmpq_mpoly, fmpq_mpoly_ctx

from flowlanes.system.vectors import Vector, real_symbol

from .horizontal_lift import Lift
from .linear_algebra import product
from .rational_evaluation import Formulas, circle, random_rational
from .rational_functions import Quotient, Value, as_formula, quotients

SEED = 1930
HIGHEST = 6
"""Largest degree in the unit vector of a factor that is recognised."""


@dataclass(frozen=True)
class HalfAngleChart:
    """Coordinates with sines and cosines as rational functions of two variables.

    Attributes
    ----------
    coordinates : tuple of Symbol
    variables : tuple of Symbol
        tan(x/2) for an angle x, and x itself for another coordinate.
    angles : tuple of bool
        Whether each coordinate is an angle.
    """

    coordinates: tuple[sp.Symbol, sp.Symbol]
    variables: tuple[sp.Symbol, sp.Symbol]
    angles: tuple[bool, bool]

    @classmethod
    def of(
        cls, coordinates: tuple[sp.Symbol, sp.Symbol], used: Sequence[sp.Symbol]
    ) -> HalfAngleChart:
        """The chart for formulas with the given symbols."""
        angles = tuple(bool(set(circle(q)) & set(used)) for q in coordinates)
        names = [
            real_symbol(f"t_{q}") if a else q for q, a in zip(coordinates, angles, strict=True)
        ]
        return cls(coordinates, (names[0], names[1]), (angles[0], angles[1]))

    def point(self, values: Sequence[Value]) -> dict[sp.Symbol, Value]:
        """Values of coordinates, sines and cosines from values of the variables."""
        point: dict[sp.Symbol, Value] = {}
        for q, angle, t in zip(self.coordinates, self.angles, values, strict=True):
            if angle:
                sine, cosine = circle(q)
                square = t * t + 1
                point[sine], point[cosine] = 2 * t / square, (2 - square) / square
            else:
                point[q] = t
        return point

    def speed(self, index: int, value: Value) -> Value:
        """Derivative of the variable by its coordinate."""
        return (value * value + 1) / 2 if self.angles[index] else value * 0 + 1


def determinant(rows: Sequence[Sequence[Value]]) -> Value:
    """The determinant, by expansion along the first row."""
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
    chart: HalfAngleChart,
    parameters: Sequence[sp.Symbol],
    owner: str,
) -> list[fmpq_mpoly]:
    """Irreducible factors of the natural determinants, in the variables of the chart.

    They divide the determinants of K, of the given quadratic forms Q, and of Q⁻¹ on the covectors
    of integrals and constraints; 1 + t² is excluded.
    """
    one, names = quotients([*chart.variables, *parameters])
    place = {**names, **chart.point([names[t] for t in chart.variables])}

    def matrix(formulas: sp.Matrix) -> list[list[Quotient]]:
        values = Formulas(list(formulas), owner).at(place, one)
        return [values[i : i + formulas.cols] for i in range(0, len(values), formulas.cols)]

    determinants = [determinant(matrix(lift.matrix))]
    tied = matrix(lift.constraint_rows) if lift.constraint_rows.rows else []
    for form in forms:
        rows = matrix(form)
        determinants.append(determinant(rows))
        if tied:
            turned = [product(_adjugate(rows), row) for row in tied]
            determinants.append(determinant([product(tied, column) for column in turned]))
    pairs = zip(chart.variables, chart.angles, strict=True)
    circles = {str(names[t].above ** 2 + 1) for t, angle in pairs if angle}
    factors: dict[str, fmpq_mpoly] = {}
    for value in determinants:
        for poly in (value.above, value.below):
            for factor, _ in poly.factor()[1]:
                lead = factor.leading_coefficient()
                if any(factor.degrees()[:2]) and str(factor / lead) not in circles:
                    factors[str(factor / lead)] = factor / lead
    return list(factors.values())


def has_even_degrees(poly: fmpq_mpoly, chart: HalfAngleChart) -> bool:
    """Whether F/(1 + t²)^(d/2) is a function of the full angles."""
    return not any(a and int(d) % 2 for d, a in zip(poly.degrees()[:2], chart.angles, strict=True))


def in_angles(poly: fmpq_mpoly, chart: HalfAngleChart) -> sp.Expr:
    """A polynomial as F/(1 + t²)^⌈d/2⌉ in sines and cosines, expanded."""
    names = poly.context().names()
    circles = [str(s) for q in chart.coordinates for s in circle(q)]
    ring = fmpq_mpoly_ctx.get([*circles, *names], Ordering.lex)
    gens = dict(zip(ring.names(), ring.gens(), strict=True))
    halves = [(int(d) + 1) // 2 for d in poly.degrees()[:2]]
    parts: dict[tuple[int, int], dict[tuple[int, ...], fmpq]] = {}
    for exponents, coefficient in poly.to_dict().items():
        first, second, *parameters = (int(e) for e in exponents)
        parts.setdefault((first, second), {})[0, 0, 0, 0, 0, 0, *parameters] = coefficient
    total = ring.constant(0)
    for powers, terms in parts.items():
        term = ring.from_dict(terms)
        for i, power in enumerate(powers):
            if not chart.angles[i]:
                term *= gens[names[i]] ** power
                continue
            sine, cosine = (gens[name] for name in circles[2 * i : 2 * i + 2])
            odd, half = power % 2, power // 2
            # t² = (1 − cos x)/(1 + cos x), t = sin x/(1 + cos x)
            term *= (1 - cosine) ** half * sine**odd * (1 + cosine) ** (halves[i] - half - odd)
        total += term
    scale = 2 ** sum(h for h, angle in zip(halves, chart.angles, strict=True) if angle)
    functions: dict[sp.Symbol, sp.Expr] = {}
    for q in chart.coordinates:
        sine, cosine = circle(q)
        functions |= {sine: sp.sin(q), cosine: sp.cos(q)}
    return as_formula(total / scale).xreplace(functions)


def on_sphere(poly: fmpq_mpoly, chart: HalfAngleChart, vector: Vector) -> sp.Expr | None:
    """A polynomial of even degrees, divided by powers of 1 + t², in the unit vector.

    It is homogeneous, or has terms of two consecutive degrees; None if it is not a polynomial of
    degree up to `HIGHEST` in the unit vector.
    """
    degree = int(poly.degrees()[0]) // 2
    if not (0 < degree <= HIGHEST and _at_pole(poly)):
        return None
    sample = _with_numbers(poly)
    for lower in (degree, degree - 1):
        powers = [
            chosen
            for d in range(lower, degree + 1)
            for chosen in combinations_with_replacement(range(3), d)
        ]
        # first with numbers for the parameters, since most polynomials are not functions on the
        # sphere
        if _coefficients_in_unit_vector(sample, powers) is not None:
            coefficients = _coefficients_in_unit_vector(poly, powers)
            return None if coefficients is None else _as_form(coefficients, powers, vector)
    return None


def _with_numbers(poly: fmpq_mpoly) -> fmpq_mpoly:
    """The polynomial with random values of the parameters."""
    rng = random.Random(SEED)
    return poly.subs({name: random_rational(rng) for name in poly.context().names()[2:]})


def _at_pole(poly: fmpq_mpoly) -> bool:
    """Whether the value at θ = 0 does not depend on φ, as on a sphere."""
    values = [_over(poly, [fmpq(0), x]) for x in (fmpq(1, 3), fmpq(5, 2))]
    return bool(values[0] == values[1])


def _as_form(
    coefficients: Sequence[fmpq_mpoly], powers: Sequence[tuple[int, ...]], vector: Vector
) -> sp.Expr:
    monomials = [sp.Mul(*(vector.symbols[i] for i in chosen)) for chosen in powers]
    terms = [as_formula(f) * x for f, x in zip(coefficients, monomials, strict=True)]
    return sp.collect(sp.expand(sp.Add(*terms)), monomials, sp.factor)


def _coefficients_in_unit_vector(
    poly: fmpq_mpoly, powers: Sequence[tuple[int, ...]]
) -> list[fmpq_mpoly] | None:
    """Coefficients of the monomials that represent the polynomial; None if there are none."""
    ring, count = poly.context(), len(powers)
    rows, right = [], []
    rng = random.Random(SEED)
    # As many points as there are monomials determine the coefficients; three more tell whether the
    # polynomial is a function of the unit vector at all.
    for _ in range(count + 3):
        t = [random_rational(rng), random_rational(rng)]
        (s, c), (s2, c2) = _circles(t)
        unit = (s * s2, s * c2, c)
        rows.append([_power(unit, chosen) for chosen in powers])
        right.append(_over(poly, t))
    matrix = fmpq_mat(rows[:count])
    if matrix.det() == 0:
        return None
    solve = matrix.inv()
    coefficients = [
        sum((solve[i, j] * right[j] for j in range(count)), ring.constant(0)) for i in range(count)
    ]
    fits = all(
        sum((x * f for x, f in zip(row, coefficients, strict=True)), ring.constant(0)) == value
        for row, value in zip(rows[count:], right[count:], strict=True)
    )
    return coefficients if fits else None


def _circles(t: Sequence[fmpq]) -> list[tuple[fmpq, fmpq]]:
    return [(2 * x / (1 + x * x), (1 - x * x) / (1 + x * x)) for x in t]


def _power(unit: Sequence[fmpq], indices: Sequence[int]) -> fmpq:
    total = fmpq(1)
    for i in indices:
        total *= unit[i]
    return total


def _over(poly: fmpq_mpoly, t: Sequence[fmpq]) -> fmpq_mpoly:
    """F/(1 + t²)^(d/2) at rational t, a polynomial in the parameters."""
    names = poly.context().names()
    value = poly.subs({names[0]: t[0], names[1]: t[1]})
    for x, degree in zip(t, poly.degrees()[:2], strict=True):
        value = value / (1 + x * x) ** (int(degree) // 2)
    return value
