"""Exact values at rational points, for formulas rational in coordinates, sines and cosines.

Every coordinate x has a rational value of its own, and sin x and cos x are a rational point of the
circle: what vanishes at generic such points vanishes as a function of x, sin x, cos x.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any, Protocol

import sympy as sp
from flint import Ordering, fmpq, fmpq_mpoly_ctx

from ...core.vectors import real_symbol
from ...errors import InputError
from ...formulas.program import FieldArithmetic, StraightLineProgram

#: A rational number, or a fraction of polynomials in some parameters.
Value = Any
Point = Mapping[sp.Symbol, Value]


def circle(angle: sp.Symbol) -> tuple[sp.Symbol, sp.Symbol]:
    """The names of sin x and cos x."""
    return real_symbol(f"sin_{angle}"), real_symbol(f"cos_{angle}")


def on_circles(formula: sp.Expr, owner: str = "") -> sp.Expr:
    """A formula with named sines and cosines.

    Raises
    ------
    InputError
        If it is not rational in coordinates, their sines and cosines.
    """
    formula = formula.rewrite([sp.tan, sp.cot, sp.sec, sp.csc], sp.cos).rewrite(sp.tan, sp.cos)
    if formula.has(sp.Function):
        formula = sp.expand_trig(formula)
    constants = sorted(map(str, formula.atoms(sp.NumberSymbol)))
    if constants:
        raise InputError(
            f"{owner}: {constants[0]} stands where the search for a multiplier needs rational "
            f"coefficients; give it a name, as a parameter with the value "
            f"{float(sp.sympify(constants[0])):.16g}"
        )
    names = {}
    for f in formula.atoms(sp.Function):
        if not (isinstance(f, sp.sin | sp.cos) and isinstance(f.args[0], sp.Symbol)):
            raise InputError(
                f"{owner}: {f} stands where the search for a multiplier needs coefficients that "
                "are rational in the coordinates, their sines and cosines"
            )
        names[f] = circle(f.args[0])[isinstance(f, sp.cos)]
    taken = sorted(map(str, formula.free_symbols & set(names.values())))
    if taken:
        raise InputError(
            f"{owner}: the name {taken[0]} is needed for a sine or cosine; rename what has it"
        )
    formula = formula.xreplace(names)
    if any(not p.exp.is_Integer for p in formula.atoms(sp.Pow)):
        raise InputError(
            f"{owner}: a root or power stands where the search for a multiplier needs "
            "coefficients that are rational in the coordinates, their sines and cosines"
        )
    return formula


def is_rational(formula: sp.Expr) -> bool:
    """Whether a formula is rational in coordinates, their sines and cosines."""
    try:
        on_circles(formula)
    except InputError:
        return False
    return True


class Evaluable(Protocol):
    """Formulas with values at points."""

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The symbols that need a value."""

    def at(self, point: Point, like: Value) -> list[Value]:
        """The values; `like` is the number one of the field."""


class Formulas:
    """Formulas made ready for evaluation in any field.

    Parameters
    ----------
    formulas : sequence of Expr
    owner : str
        Named where a formula is refused.
    """

    def __init__(self, formulas: Iterable[sp.Expr], owner: str = "") -> None:
        shared, parts = sp.cse([on_circles(sp.sympify(f), owner) for f in formulas], list=False)
        symbols = {s for f in (*dict(shared).values(), *parts) for s in f.free_symbols}
        self.symbols = tuple(sorted(symbols - dict(shared).keys(), key=str))
        self._program = StraightLineProgram(self.symbols, parts, tuple(shared))

    def at(self, point: Point, like: Value) -> list[Value]:
        """The values; `like` is the number one of the field."""
        values = self._program.run([point[s] for s in self.symbols], FieldArithmetic(like))
        return [like * value for value in values]


def bare(symbols: Iterable[sp.Symbol]) -> list[sp.Symbol]:
    """The symbols that do not name sines or cosines."""
    return [s for s in symbols if not str(s).startswith(("sin_", "cos_"))]


def number(dice: random.Random) -> fmpq:
    """A random rational number."""
    sign = dice.choice((-1, 1))
    return fmpq(sign * dice.randint(2, 40), dice.randint(11, 30))


def near(default: float, dice: random.Random) -> fmpq:
    """A rational number near a default that is not zero."""
    if default == 0:
        return number(dice)
    exact = Fraction(repr(float(default))) * dice.randint(90, 115) / 100
    return fmpq(exact.numerator, exact.denominator)


def point(
    symbols: Iterable[sp.Symbol], dice: random.Random, start: Point | None = None
) -> dict[sp.Symbol, Value]:
    """Values of coordinates with their sines and cosines, or of whatever else is named."""
    values: dict[sp.Symbol, Value] = dict(start or {})
    for s in symbols:
        if s in values:
            continue
        values[s] = number(dice)
        half = number(dice)
        square = 1 + half * half
        sine, cosine = circle(s)
        values[sine], values[cosine] = 2 * half / square, (1 - half * half) / square
    return values


def product(rows: Sequence[Sequence[Value]], column: Sequence[Value]) -> list[Value]:
    """A matrix times a column."""
    return [sum((a * b for a, b in zip(row, column, strict=True)), 0 * column[0]) for row in rows]


def inverse(rows: Sequence[Sequence[Value]], like: Value) -> list[list[Value]]:
    """The inverse of a small matrix.

    Raises
    ------
    ZeroDivisionError
        If it is singular.
    """
    size = len(rows)
    wide = [[*row, *(like * int(i == j) for j in range(size))] for i, row in enumerate(rows)]
    left, pivots = reduced_echelon_form(wide)
    if pivots != list(range(size)):
        raise ZeroDivisionError
    return [row[size:] for row in left]


def reduced_echelon_form(rows: Sequence[Sequence[Value]]) -> tuple[list[list[Value]], list[int]]:
    """The reduced echelon form without zero rows, and the columns of its pivots."""
    left = [list(row) for row in rows]
    pivots: list[int] = []
    for k in range(len(left[0])):
        top = len(pivots)
        pivot = next((i for i in range(top, len(left)) if left[i][k] != 0), None)
        if pivot is None:
            continue
        left[top], left[pivot] = left[pivot], left[top]
        left[top] = [x / left[top][k] for x in left[top]]
        for i, row in enumerate(left):
            if i != top and row[k] != 0:
                factor = row[k]
                left[i] = [x - factor * y for x, y in zip(row, left[top], strict=True)]
        pivots.append(k)
    return left[: len(pivots)], pivots


def kernel(rows: Sequence[Sequence[Value]], like: Value) -> list[list[Value]]:
    """A basis of the solutions of a homogeneous system, one for each free unknown."""
    left, pivots = reduced_echelon_form(rows)
    size = len(rows[0])
    basis = []
    for free in (j for j in range(size) if j not in pivots):
        solution = [like * 0] * size
        solution[free] = like
        for row, pivot in zip(left, pivots, strict=True):
            solution[pivot] = -row[free]
        basis.append(solution)
    return basis


class Quotient:
    """A fraction of polynomials over the rationals without common factors; immutable."""

    __slots__ = ("above", "below")

    def __init__(self, above: Any, below: Any) -> None:
        if below == 0:
            raise ZeroDivisionError
        shared = above.gcd(below)
        if not shared.is_constant():
            above, below = divmod(above, shared)[0], divmod(below, shared)[0]
        lead = below.leading_coefficient()
        self.above, self.below = above / lead, below / lead

    def _as_quotient(self, other: Any) -> Quotient:
        if isinstance(other, Quotient):
            return other
        home = self.above.context()
        return Quotient(home.constant(other), home.constant(1))

    def __add__(self, other: Any) -> Quotient:
        o = self._as_quotient(other)
        if self.below == o.below:
            return Quotient(self.above + o.above, self.below)
        return Quotient(self.above * o.below + o.above * self.below, self.below * o.below)

    def __mul__(self, other: Any) -> Quotient:
        o = self._as_quotient(other)
        return Quotient(self.above * o.above, self.below * o.below)

    def __truediv__(self, other: Any) -> Quotient:
        o = self._as_quotient(other)
        return Quotient(self.above * o.below, self.below * o.above)

    def __neg__(self) -> Quotient:
        return self * -1

    def __sub__(self, other: Any) -> Quotient:
        opposite: Quotient = -self._as_quotient(other)
        return self + opposite

    def __rsub__(self, other: Any) -> Quotient:
        return self._as_quotient(other) - self

    def __rtruediv__(self, other: Any) -> Quotient:
        quotient: Quotient = self._as_quotient(other) / self
        return quotient

    def __pow__(self, exponent: int) -> Quotient:
        if exponent < 0:
            return Quotient(self.below**-exponent, self.above**-exponent)
        return Quotient(self.above**exponent, self.below**exponent)

    def __eq__(self, other: object) -> bool:
        return bool((self - other).above == 0)

    def __hash__(self) -> int:
        return hash((str(self.above), str(self.below)))

    __radd__ = __add__
    __rmul__ = __mul__

    def formula(self) -> sp.Expr:
        """A SymPy formula in real symbols."""
        return as_formula(self.above) / as_formula(self.below)


def quotients(names: Sequence[sp.Symbol]) -> tuple[Quotient, dict[sp.Symbol, Quotient]]:
    """The number one of the field of fractions in `names`, and the names as its elements."""
    ring = fmpq_mpoly_ctx.get([str(s) for s in names], Ordering.lex)
    one = ring.constant(1)
    gens = {s: Quotient(g, one) for s, g in zip(names, ring.gens(), strict=True)}
    return Quotient(one, one), gens


def as_formula(poly: Any) -> sp.Expr:
    """A polynomial as a SymPy formula in real symbols."""
    names = [real_symbol(n) for n in poly.context().names()]
    terms = []
    for exponents, c in poly.to_dict().items():
        power = sp.Mul(*(s ** int(e) for s, e in zip(names, exponents, strict=True)))
        terms.append(sp.Rational(int(c.p), int(c.q)) * power)
    return sp.Add(*terms)


def as_expression(value: Value) -> sp.Expr:
    """A number or a fraction as a SymPy formula."""
    return (
        value.formula() if isinstance(value, Quotient) else sp.Rational(int(value.p), int(value.q))
    )
