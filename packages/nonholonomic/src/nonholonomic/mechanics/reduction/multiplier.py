"""The reducing multiplier N: d ln N = A₂ dq₁ − A₁ dq₂ (Theorem 6).

ln N is sought among Σ e_j ln F_j for the natural factors F_j; the exponents e_j solve linear
equations, one pair at each rational point. Whether the 1-form is closed follows from its
derivatives, taken exactly along the coordinate lines through a rational point.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp
from flint import fmpq, fmpq_mpoly

from flowlanes.system.system import Parameter
from flowlanes.system.vectors import Vector

from .factors import HalfAngleChart, has_even_degrees, in_angles, on_sphere
from .horizontal_lift import PointwiseForm
from .linear_algebra import reduced_echelon_form
from .rational_evaluation import Point, random_rational, rational_near
from .rational_functions import Quotient, Value, quotients

SEED = 1961
SPARE = 3
"""Number of additional points at which the solution must hold as well."""


@dataclass(frozen=True)
class Multiplier:
    """N as a product of powers.

    Attributes
    ----------
    powers : tuple of (Expr, Expr)
        Bases, in the coordinates q or in the unit vector, with their exponents.
    """

    powers: tuple[tuple[sp.Expr, sp.Expr], ...]

    @property
    def value(self) -> sp.Expr:
        """N as one formula."""
        return sp.Mul(*(base**exponent for base, exponent in self.powers))


@dataclass(frozen=True)
class Obstruction:
    """A point at which the 1-form is not closed.

    Attributes
    ----------
    point : mapping of str to str
        Exact values of parameters, coordinates and constants; tan(x/2) for an angle x.
    curl : fmpq
        ∂A₂/∂q₂ + ∂A₁/∂q₁ there, exactly; it is not zero.
    vanishing : tuple of Expr
        Expressions in the parameters at whose zeros the form is closed, if any were found.
    """

    point: dict[str, str]
    curl: fmpq
    vanishing: tuple[sp.Expr, ...]


def positive_symbols(parameters: Sequence[Parameter]) -> dict[sp.Symbol, sp.Symbol]:
    """Positive symbols for the parameters that must be positive."""
    return {
        p.symbol: sp.Symbol(str(p.symbol), positive=True)
        for p in parameters
        if (p.symbol > 0) in p.admissible
    }


def _form_at(
    local: PointwiseForm,
    chart: HalfAngleChart,
    values: Sequence[Value],
    numbers: Point,
    like: Value,
) -> tuple[Value, Value]:
    """The 1-form at a point of the chart."""
    place = {**numbers, **chart.point([like * v for v in values])}
    return local.at(place, like).form(like)


def _parameters(local: PointwiseForm, chart: HalfAngleChart) -> list[sp.Symbol]:
    moving = {*chart.coordinates, *chart.point([fmpq(2), fmpq(3)])}
    return [s for s in local.symbols if s not in moving]


# --- whether the form is closed ---------------------------------------------------------------


def curl(
    local: PointwiseForm,
    chart: HalfAngleChart,
    values: Sequence[fmpq],
    numbers: Point,
    others: Sequence[sp.Symbol],
) -> Value:
    """∂A₂/∂q₂ + ∂A₁/∂q₁ at a point; `others` are parameters to be kept as symbols."""
    total: Value = None
    for moved in (0, 1):
        one, names = quotients([chart.variables[moved], *others])
        place = {s: one * v for s, v in numbers.items()} | {s: names[s] for s in others}
        at = [one * v for v in values]
        at[moved] = names[chart.variables[moved]]
        # the component along the other coordinate
        component = _form_at(local, chart, at, place, one)[1 - moved]
        rate = _derivative(component, 0) * chart.speed(moved, at[moved])
        rate = _at_value(rate, str(chart.variables[moved]), values[moved])
        term = rate if moved else -rate
        total = term if total is None else _sum_as_formula(total, term)
    return total


def _derivative(value: Quotient, index: int) -> Quotient:
    name = value.above.context().names()[index]
    above, below = value.above.derivative(name), value.below.derivative(name)
    return Quotient(above * value.below - value.above * below, value.below**2)


def _at_value(value: Quotient, name: str, at: fmpq) -> Quotient:
    return Quotient(value.above.subs({name: at}), value.below.subs({name: at}))


def _sum_as_formula(first: Quotient, second: Quotient) -> sp.Expr:
    """The sum of two fractions over different rings, as a formula."""
    return sp.cancel(sp.together(first.formula() + second.formula()))


def poles(multiplier: Multiplier) -> tuple[sp.Expr, ...]:
    """Factors of denominators of the exponents of N; the formula for N fails where one vanishes."""
    below = {
        factor
        for _, exponent in multiplier.powers
        for factor, _ in sp.factor_list(sp.denom(sp.together(exponent)))[1]
    }
    return tuple(sorted(below, key=str))


def obstruction_point(
    local: PointwiseForm, chart: HalfAngleChart, parameters: Sequence[Parameter]
) -> Obstruction | None:
    """A point at which the form is not closed, or None.

    Parameters
    ----------
    local : PointwiseForm
    chart : HalfAngleChart
    parameters : sequence of Parameter
        The point has values near their defaults; other constants are random.
    """
    rng = random.Random(SEED)
    defaults = {p.symbol: p.default for p in parameters}
    for _ in range(2):
        while True:
            numbers = {
                s: rational_near(defaults.get(s, 0.0), rng) for s in _parameters(local, chart)
            }
            values = [random_rational(rng), random_rational(rng)]
            try:
                value = curl(local, chart, values, numbers, [])
            except ZeroDivisionError:
                continue
            break
        if value != 0:
            exact = fmpq(int(value.p), int(value.q))
            at = {**numbers, **dict(zip(chart.variables, values, strict=True))}
            shown = {str(s): str(v) for s, v in at.items()}
            return Obstruction(shown, exact, exceptional_factors(local, chart, parameters))
    return None


def is_closed(local: PointwiseForm, chart: HalfAngleChart) -> bool:
    """Whether the form is closed, with coordinates and parameters as symbols."""
    one, names = quotients([*chart.variables, *_parameters(local, chart)])
    at = [names[t] for t in chart.variables]
    first, second = _form_at(local, chart, at, names, one)
    change = _derivative(first, 1) * chart.speed(1, at[1])
    return bool(change == _derivative(second, 0) * chart.speed(0, at[0]))


def exceptional_factors(
    local: PointwiseForm, chart: HalfAngleChart, signed_parameters: Sequence[Parameter]
) -> tuple[sp.Expr, ...]:
    """Factors of the curl that depend on parameters only and may vanish."""
    rng = random.Random(SEED + 1)
    parameters = _parameters(local, chart)
    shared: sp.Expr | None = None
    for _ in range(2):
        values = [random_rational(rng), random_rational(rng)]
        form = curl(local, chart, values, {}, parameters)
        above = sp.fraction(sp.together(form))[0]
        shared = above if shared is None else sp.gcd(shared, above)
    factors = [base for base, _ in sp.factor_list(shared)[1]]
    signs = positive_symbols(signed_parameters)
    return tuple(
        f
        for f in factors
        if f.free_symbols & set(parameters) and f.xreplace(signs).is_zero is not False
    )


# --- integrating it ---------------------------------------------------------------------------


def multiplier(
    local: PointwiseForm,
    chart: HalfAngleChart,
    factors: Sequence[fmpq_mpoly],
    vector: Vector | None,
) -> Multiplier | None:
    """N as a product of powers of the factors; None if it has no such form.

    The exponents are rational numbers, or rational functions of parameters.
    """
    parameters = _parameters(local, chart)
    rng = random.Random(SEED)
    numbers = {s: random_rational(rng) for s in parameters}
    values = _exponents(local, chart, factors, numbers, ())
    if values is None:
        return None
    # only parameters that change the exponents are kept as symbols, which keeps the fractions small
    moving = []
    for s in parameters:
        other = _exponents(local, chart, factors, {**numbers, s: random_rational(rng)}, ())
        if other != values:
            moving.append(s)
    if moving:
        fixed = {s: v for s, v in numbers.items() if s not in moving}
        symbolic = _exponents(local, chart, factors, fixed, tuple(moving))
        if symbolic is None:
            return None
        exponents = [sp.factor(x.formula()) for x in symbolic]
    else:
        exponents = [sp.Rational(int(x.p), int(x.q)) for x in values]
    return Multiplier(_powers(chart, factors, exponents, vector))


def _exponents(
    local: PointwiseForm,
    chart: HalfAngleChart,
    factors: Sequence[fmpq_mpoly],
    numbers: Point,
    symbols: tuple[sp.Symbol, ...],
) -> list[Value] | None:
    """Exponents of the factors, then of 1 + t² for each angle."""
    rng = random.Random(SEED + 2)
    like: Value = fmpq(1)
    place = dict(numbers)
    if symbols:
        like, names = quotients(symbols)
        place = {s: like * v for s, v in numbers.items()} | dict(names)
    count = len(factors) + sum(chart.angles)
    rows: list[list[Value]] = []
    right: list[Value] = []
    while len(rows) < count + SPARE:
        values = [random_rational(rng), random_rational(rng)]
        try:
            pair = _form_at(local, chart, values, place, like)
            slopes = _slopes(chart, factors, values, place, like)
        except ZeroDivisionError:
            continue
        rows += slopes
        right += pair
    return _overdetermined_solution(rows, right)


def _slopes(
    chart: HalfAngleChart,
    factors: Sequence[fmpq_mpoly],
    values: Sequence[fmpq],
    numbers: Point,
    like: Value,
) -> list[list[Value]]:
    """Derivatives of ln F_j and ln(1 + t²) by both coordinates."""
    at = {**numbers, **dict(zip(chart.variables, (like * v for v in values), strict=True))}
    rows = []
    for i in (0, 1):
        speed = chart.speed(i, like * values[i])
        row = []
        for poly in factors:
            name = poly.context().names()[i]
            row.append(_value(poly.derivative(name), at, like) / _value(poly, at, like) * speed)
        for j in (0, 1):
            if chart.angles[j]:
                # d ln(1 + t²)/dx = t
                row.append(like * values[i] if i == j else like * 0)
        rows.append(row)
    return rows


def _value(poly: fmpq_mpoly, at: Point, like: Value) -> Value:
    names = poly.context().names()
    by_name = {str(s): v for s, v in at.items()}
    total = like * 0
    for exponents, c in poly.to_dict().items():
        term = like * c
        for name, e in zip(names, exponents, strict=True):
            if e:
                term = term * by_name[name] ** int(e)
        total = total + term
    return total


def _overdetermined_solution(rows: list[list[Value]], right: list[Value]) -> list[Value] | None:
    """The unique solution of an overdetermined linear system, or None."""
    left, pivots = reduced_echelon_form([[*row, x] for row, x in zip(rows, right, strict=True)])
    if pivots != list(range(len(rows[0]))):
        return None
    return [row[-1] for row in left]


def _powers(
    chart: HalfAngleChart,
    factors: Sequence[fmpq_mpoly],
    exponents: Sequence[sp.Expr],
    vector: Vector | None,
) -> tuple[tuple[sp.Expr, sp.Expr], ...]:
    """The powers of N with every factor in the angles, or in the unit vector."""
    powers: list[tuple[sp.Expr, sp.Expr]] = []
    own = list(exponents[: len(factors)])
    circles = iter(exponents[len(factors) :])
    circle_powers = [next(circles) if angle else sp.S.Zero for angle in chart.angles]
    groups: dict[sp.Expr, fmpq_mpoly] = {}
    for poly, exponent in zip(factors, own, strict=True):
        if exponent == 0:
            continue
        for i in (0, 1):
            if chart.angles[i]:
                circle_powers[i] += exponent * int(poly.degrees()[i]) / sp.Integer(2)
        if has_even_degrees(poly, chart):
            powers.append((_base(poly, chart, vector), exponent))
        else:
            groups[exponent] = groups[exponent] * poly if exponent in groups else poly
    for exponent, poly in groups.items():
        if has_even_degrees(poly, chart):
            powers.append((_monic(in_angles(poly, chart)), exponent))
        else:
            # a polynomial of odd degree is a function of half angles; its square is one of full
            # angles
            powers.append((_monic(in_angles(poly**2, chart)), exponent / 2))
    for x, exponent in zip(chart.coordinates, circle_powers, strict=True):
        if sp.cancel(exponent) != 0:
            powers.append((1 + sp.cos(x), -sp.cancel(exponent)))
    return tuple(powers)


def _base(poly: fmpq_mpoly, chart: HalfAngleChart, vector: Vector | None) -> sp.Expr:
    known = on_sphere(poly, chart, vector) if vector is not None else None
    return _monic(in_angles(poly, chart) if known is None else known)


def _monic(base: sp.Expr) -> sp.Expr:
    """A factor normalised up to a number, without a leading minus sign."""
    whole = sp.primitive(sp.expand(base))[1]
    sign = -1 if whole.could_extract_minus_sign() else 1
    if base.is_Add and not base.has(sp.cos, sp.sin):
        number = sp.cancel(base / whole)
        return sp.Add(*(sp.factor(sign * term / number) for term in base.args))
    return sp.expand(sign * whole)


def over_rational(multiplier: Multiplier, b: sp.Expr) -> sp.Expr:
    """The product N b with common factors combined."""
    powers = dict(b.as_powers_dict())
    remainder = sp.S.One
    for base, exponent in multiplier.powers:
        for other in [k for k in powers if not k.is_Symbol and k.free_symbols == base.free_symbols]:
            ratio = sp.cancel(other / base)
            if ratio.is_number:
                remainder *= ratio ** powers[other]
                powers[base] = powers.pop(other) + exponent
                break
        else:
            remainder *= base**exponent
    return remainder * sp.Mul(*(base**power for base, power in powers.items()))
