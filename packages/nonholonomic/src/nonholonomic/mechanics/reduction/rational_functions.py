"""The field of rational functions: exact fractions of polynomials over the rationals."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp
from flint import Ordering, fmpq_mpoly_ctx

from flowlanes.system.vectors import real_symbol

#: A rational number, or a fraction of polynomials in some parameters.
Value = Any


class Quotient:
    """A fraction of polynomials over the rationals without common factors; immutable."""

    __slots__ = ("above", "below")

    def __init__(self, above: Any, below: Any) -> None:
        if below == 0:
            raise ZeroDivisionError
        # lowest terms with a monic denominator, so that equal fractions have equal parts
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
    """The unit element of the field of rational functions in `names`, and the names as elements."""
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
