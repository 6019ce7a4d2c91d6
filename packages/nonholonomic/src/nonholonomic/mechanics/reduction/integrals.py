"""Integrals linear and quadratic in the momenta, found by exact linear algebra.

With m = ∂L/∂u and ṁ = f the condition that F(q, m) be constant is linear in the coefficients of F.
It is solved at rational points first, which determines the terms that occur, and then for these
terms with the parameters as symbols.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations_with_replacement

import sympy as sp
from flint import fmpq

from flowlanes.system.vectors import real_symbol

from ..lagrangian.mechanism import Mechanism
from .base_coordinates import Base
from .linear_algebra import kernel
from .momenta import ReducedMomenta
from .rational_evaluation import Evaluable, Formulas, plain_symbols, rational_point
from .rational_functions import Value, as_expression, quotients

SEED = 1911
DEGREE = 2
"""Largest degree in the coordinates of coefficients of an integral linear in the momenta."""


@dataclass(frozen=True)
class Linear:
    """An integral Σ a_s(q) m_s + a_0(q).

    Attributes
    ----------
    value : Expr
        The integral in q and u.
    in_momenta : Expr
        The integral in q and momenta named M_1, M_2, …
    """

    value: sp.Expr
    in_momenta: sp.Expr


def linear_integrals(mechanism: Mechanism, motion: ReducedMomenta, base: Base) -> list[Linear]:
    """Independent integrals Σ a_s(q) m_s + a_0(q) of lowest degree.

    Parameters
    ----------
    mechanism : Mechanism
    motion : ReducedMomenta
        In the coordinates of the mechanism, without constraints C u = 0.
    base : Base
    """
    functions = _functions(motion, base)
    for degree in range(DEGREE + 1):
        monomials = _monomials(functions, degree)
        names = [real_symbol(f"M_{i + 1}") for i in range(len(motion.velocities))]
        written = [f * M for M in names for f in monomials]
        written += [f for f in monomials if f != 1]
        momenta = dict(zip(names, motion.momenta, strict=True))
        terms = [term.xreplace(momenta) for term in written]
        combinations = _constants(mechanism, motion, base, terms)
        if combinations:
            sums = [sp.Add(*(c * written[i] for i, c in each.items())) for each in combinations]
            return [Linear(each.xreplace(momenta), each) for each in sums]
    return []


@dataclass(frozen=True)
class QuadraticForm:
    """An integral ½(m, Bm) + φ(q).

    Attributes
    ----------
    matrix : Matrix
        B, constant and symmetric.
    potential : Expr
        φ, in the coordinates of the mechanism.
    """

    matrix: sp.Matrix
    potential: sp.Expr


def quadratic_integrals(
    mechanism: Mechanism, motion: ReducedMomenta, base: Base
) -> list[QuadraticForm]:
    """Integrals ½(m, Bm) + φ(q) with B constant and φ of a degree of at most two."""
    size = len(motion.velocities)
    pairs = list(combinations_with_replacement(range(size), 2))
    m = motion.momenta
    # a system without potential needs no φ
    functions = [] if motion.potential == 0 else _monomials(_functions(motion, base), DEGREE)
    heights = [f for f in functions if f != 1]
    terms = [*(m[a] * m[b] for a, b in pairs), *heights]
    forms = []
    for chosen in _constants(mechanism, motion, base, terms):
        form, potential = sp.zeros(size), sp.S.Zero
        for i, factor in chosen.items():
            if i >= len(pairs):
                potential += factor * heights[i - len(pairs)]
                continue
            a, b = pairs[i]
            form[a, b] += factor
            form[b, a] += factor
        forms.append(QuadraticForm(form, potential))
    return forms


def _functions(motion: ReducedMomenta, base: Base) -> list[sp.Expr]:
    if base.normal is not None:
        return list(base.normal.symbols)
    functions: list[sp.Expr] = []
    for q in base.coordinates:
        has_angle = any(e.has(sp.sin(q)) or e.has(sp.cos(q)) for e in motion.force)
        functions += [sp.sin(q), sp.cos(q)] if has_angle else [q]
    return functions


def _monomials(functions: Sequence[sp.Expr], degree: int) -> list[sp.Expr]:
    monomials = [
        sp.Mul(*chosen)
        for height in range(degree + 1)
        for chosen in combinations_with_replacement(functions, height)
    ]
    # on a sphere or circle the square of the last function follows from the others
    square = functions[-1] ** 2 if functions else sp.S.Zero
    return [f for f in monomials if sp.rem(f, square, *functions) != 0] if degree > 1 else monomials


def _constants(
    mechanism: Mechanism, motion: ReducedMomenta, base: Base, terms: Sequence[sp.Expr]
) -> list[dict[int, sp.Expr]]:
    """Constant coefficients of the combinations of terms that are integrals."""
    rates = [_derivative(motion, term).xreplace(base.inside) for term in terms]
    return solutions(mechanism, base, Formulas(rates, mechanism.name), len(terms))


def _derivative(motion: ReducedMomenta, value: sp.Expr) -> sp.Expr:
    """The time derivative of a polynomial in m with coefficients in q, without accelerations."""
    names = [real_symbol(f"m_{i}_") for i in range(len(motion.velocities))]
    momenta = list(motion.momenta)
    # terms are products of momenta and functions of q, so that each momentum occurs as one sum
    named = value.xreplace(dict(zip(momenta, names, strict=True)))
    by_name = sp.Add(
        *(sp.diff(named, n) * f for n, f in zip(names, motion.force + motion.pull, strict=True))
    )
    total = by_name + motion.rate(named)
    return total.xreplace(dict(zip(names, momenta, strict=True)))


def solutions(
    mechanism: Mechanism, base: Base, formulas: Evaluable, count: int
) -> list[dict[int, sp.Expr]]:
    """Coefficients x_i, free of the coordinates, with Σ x_i formula_i = 0.

    The number of equations in `formulas` is a multiple of `count`: each row of `count` must vanish.
    """
    rng = random.Random(SEED)
    names = plain_symbols(formulas.symbols)
    parameters = [p.symbol for p in mechanism.parameters]
    one = fmpq(1)
    fixed = rational_point(parameters, rng)
    rows: list[list[Value]] = []
    while len(rows) < count + 4:
        try:
            values = formulas.at(rational_point([*names, *base.coordinates], rng, fixed), one)
        except ZeroDivisionError:
            continue
        rows += [values[i : i + count] for i in range(0, len(values), count)]
    # The kernel at fixed parameters determines the terms of each integral; in the reduced echelon
    # form each basis vector has few of them, and their coefficients are then found symbolically.
    combinations = []
    for solution in kernel(rows, one):
        chosen = [i for i, x in enumerate(solution) if x != 0]
        combinations.append(_with_parameters(mechanism, base, formulas, count, chosen))
    return combinations


def _with_parameters(
    mechanism: Mechanism, base: Base, formulas: Evaluable, count: int, indices: Sequence[int]
) -> dict[int, sp.Expr]:
    """The coefficients of a combination with the parameters as symbols."""
    parameters = [p.symbol for p in mechanism.parameters if p.symbol in formulas.symbols]
    if len(indices) == 1:
        return {indices[0]: sp.S.One}
    one, symbols = quotients(parameters) if parameters else (fmpq(1), {})
    rng = random.Random(SEED + 1)
    names = plain_symbols(formulas.symbols)
    rows: list[list[Value]] = []
    while len(rows) < len(indices) + 2:
        place = rational_point([n for n in names if n not in symbols] + list(base.coordinates), rng)
        values = formulas.at({**{s: one * v for s, v in place.items()}, **symbols}, one)
        rows += [[values[i + j] for j in indices] for i in range(0, len(values), count)]
    (row,) = kernel(rows, one)
    return dict(zip(indices, primitive([as_expression(x) for x in row]), strict=True))


def primitive(values: Sequence[sp.Expr]) -> list[sp.Expr]:
    """Rational functions scaled to polynomials without a common factor."""
    parts = [sp.fraction(sp.cancel(x)) for x in values]
    below = sp.lcm_list([b for _, b in parts])
    whole = [sp.cancel(below / b) * a for a, b in parts]
    shared = sp.gcd_list(whole)
    return [sp.factor(sp.cancel(x / shared)) for x in whole]
