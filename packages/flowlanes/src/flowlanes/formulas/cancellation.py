"""Small rational formulas in lowest terms, with common factors extracted."""

from __future__ import annotations

from functools import reduce
from math import gcd

import sympy as sp
from sympy.polys.polyerrors import PolynomialError
from sympy.polys.rings import PolyElement, sring


def in_lowest_terms(formula: sp.Expr) -> sp.Expr:
    """Result of `factor_terms(cancel(formula))`, computed faster in simple cases.

    Simple cases are quotients of polynomials with integer coefficients in symbols, and in sines
    and cosines of symbols, their sums and differences.

    Examples
    --------
    >>> x, y = sp.symbols("x y")
    >>> in_lowest_terms((2 * x**2 * y + 2 * x * y) / (x + 1) / (x**2 + x * y))
    2*y/(x + y)
    """
    above, below = formula.as_numer_denom()
    try:
        ring, (p, q) = sring((above, below))
    except PolynomialError:
        return sp.factor_terms(sp.cancel(formula))
    if not ring.ngens or not ring.domain.is_ZZ or not all(map(_is_plain, ring.symbols)):
        return sp.factor_terms(sp.cancel(formula))
    p, q = p.cancel(q)
    if not p:
        return sp.S.Zero
    number, letters, remainder = _taken_out(p)
    divisor, below_letters, other = _taken_out(q)
    common = gcd(number, divisor)
    factors = [a ** (m - n) for a, m, n in zip(ring.symbols, letters, below_letters, strict=True)]
    factors += [e for e in (remainder, 1 / other) if e != 1]
    share = sp.Rational(number // common, divisor // common)
    product = sp.Mul(*factors)
    if share == 1:
        return product
    if product.is_Add:
        return sp.Mul(share, product, evaluate=False)
    return sp.Mul(share, product)


def _is_plain(generator: sp.Expr) -> bool:
    return bool(
        generator.is_Symbol
        or (
            isinstance(generator, sp.sin | sp.cos)
            and all(t.is_Symbol or (-t).is_Symbol for t in sp.Add.make_args(generator.args[0]))
        )
    )


def _taken_out(p: PolyElement) -> tuple[int, list[int], sp.Expr]:
    """Number and powers of symbols that divide all terms, and the quotient."""
    numbers = [int(c) for c in p.values()]
    number = reduce(gcd, numbers)
    if all(c < 0 for c in numbers):
        number = -number
    letters = [min(powers) for powers in zip(*p.keys(), strict=True)]
    rest = {
        tuple(n - m for n, m in zip(powers, letters, strict=True)): c // number
        for powers, c in p.items()
    }
    return number, letters, p.ring.from_dict(rest).as_expr()
