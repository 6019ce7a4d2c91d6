"""Exact methods for the sign of a polynomial.

There are three. *Completing squares*: a polynomial is written as a sum of squares with positive
weights, starting from its leading term. The *S-lemma* (Yakubovich): if g > 0 implies p ≥ 0 for
quadratic polynomials, p − λ g is a sum of squares for some λ ≥ 0, which is sought among the roots
of a determinant and between them. *One variable*: the sign is read off at the real roots of all
polynomials and at points between them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from flint import acb, arb, ctx, fmpq, fmpq_mat, fmpq_mpoly_ctx, fmpq_poly, fmpz_poly

from .quotient_ring import Poly

#: Maximum number of squares to complete.
MOST_SQUARES = 30
#: Maximum number of variables for the S-lemma.
MOST_VARIABLES = 10
#: Maximum total degree of the polynomials in one variable.
MOST_DEGREE = 40
PRECISIONS = (128, 512, 2048)

Squares = list[tuple[fmpq, Poly]]


def completed_squares(poly: Poly, ring: fmpq_mpoly_ctx) -> Squares | None:
    """Weights and polynomials with poly = Σ weight · polynomial², or None.

    Squares are completed from the leading term downwards, in one way only; the result is None
    unless all weights are positive. The last polynomial is 1 if a positive constant remains.
    """
    squares: Squares = []
    remainder = poly
    while remainder and not remainder.is_constant():
        lead = tuple(map(int, remainder.monoms()[0]))
        weight = remainder.leading_coefficient()
        if any(n % 2 for n in lead) or not weight > 0 or len(squares) == MOST_SQUARES:
            return None
        half = tuple(n // 2 for n in lead)
        mixed = {}
        # With leading term w m² and other terms r m, w (m + Σ r / (2w))² removes all terms
        # divisible by m except those that are squares with positive coefficients already.
        for exponents, number in remainder.to_dict().items():
            rest = tuple(int(n) - h for n, h in zip(exponents, half, strict=True))
            square = number > 0 and not any(n % 2 for n in exponents)
            if min(rest) >= 0 and not square:
                mixed[rest] = number
        base = ring.from_dict({half: fmpq(1)}) + ring.from_dict(mixed) / (2 * weight)
        squares.append((weight, base))
        remainder = remainder - weight * base * base
    if remainder:
        if not remainder.leading_coefficient() > 0:
            return None
        squares.append((remainder.leading_coefficient(), ring.constant(1)))
    return squares


def less_a_multiple(
    poly: Poly, other: Poly, ring: fmpq_mpoly_ctx, either_sign: bool
) -> tuple[fmpq, Squares] | None:
    """λ and squares with poly = λ · other + squares, for quadratic polynomials; or None.

    Parameters
    ----------
    either_sign : bool
        True if λ may be negative, which is possible if `other` is zero, but not if it is positive.
    """
    if poly.total_degree() > 2 or other.total_degree() > 2:
        return None
    places = [
        i for i, (a, b) in enumerate(zip(poly.degrees(), other.degrees(), strict=True)) if a or b
    ]
    if not places or len(places) > MOST_VARIABLES:
        return None
    for ratio in _ratios(_matrix(poly, places), _matrix(other, places)):
        # With g > 0 only λ > 0 is useful; with g = 0 any λ is.
        if ratio > 0 or (ratio < 0 and either_sign):
            squares = completed_squares(poly - ratio * other, ring)
            if squares is not None:
                return ratio, squares
    return None


def _matrix(poly: Poly, places: Sequence[int]) -> list[list[fmpq]]:
    """The symmetric matrix of a quadratic polynomial, with the constant term in row 0."""
    size = len(places) + 1
    rows = [[fmpq(0)] * size for _ in range(size)]
    for exponents, number in poly.to_dict().items():
        # With the constant 1 as variable 0, every term of degree ≤ 2 is an entry of the matrix.
        own = [k + 1 for k, i in enumerate(places) for _ in range(int(exponents[i]))]
        first, second = [0, 0, *own][-2:]
        if first == second:
            rows[first][first] = number
        else:
            rows[first][second] = rows[second][first] = number / 2
    return rows


def _ratios(first: list[list[fmpq]], second: list[list[fmpq]]) -> Iterator[fmpq]:
    """Candidates λ for which first − λ second may be positive semidefinite.

    The set of such λ is an interval that ends at roots of the determinant.
    """
    size = len(first)
    # Lagrange interpolation of det(first − λ second), a polynomial in λ of degree ≤ size.
    points = [fmpq(k) for k in range(size + 1)]
    determinant = fmpq_poly([])
    for at in points:
        entries = [
            a - at * b
            for row, other in zip(first, second, strict=True)
            for a, b in zip(row, other, strict=True)
        ]
        share = fmpq_poly([fmpq_mat(size, size, entries).det()])
        for other_point in points:
            if other_point != at:
                share = share * fmpq_poly([-other_point, 1]) / (at - other_point)
        determinant = determinant + share
    if determinant.degree() < 1:
        # The determinant is constant in λ, so its roots give no candidates; a few simple ones are
        # tried.
        yield from (fmpq(1), fmpq(-1), fmpq(1, 2), fmpq(-1, 2))
        return
    with ctx.workprec(PRECISIONS[0]):
        roots = [root for root, _ in _real_roots([determinant])]
        between = _between([root.ball for root in roots])
    yield from (root.value for root in roots if root.value is not None)
    # Rational numbers between the roots are interior points of the interval; with them all
    # certificates stay rational.
    yield from between


@dataclass(frozen=True)
class _Root:
    """A real root: an enclosing ball, and the exact value if it is rational."""

    ball: arb
    value: fmpq | None


def _real_roots(polys: Sequence[fmpq_poly]) -> list[tuple[_Root, fmpz_poly]]:
    """The distinct real roots of polynomials in order, each with its irreducible factor."""
    factors: dict[str, fmpz_poly] = {}
    for poly in polys:
        for part, _ in poly.numer().factor()[1]:
            factors[str(part)] = part
    roots = []
    for part in factors.values():
        value = fmpq(-int(part[0]), int(part[1])) if part.degree() == 1 else None
        found: list[tuple[acb, int]] = part.complex_roots()  # type: ignore[assignment]
        # python-flint gives real roots an imaginary part that is exactly zero.
        roots += [(_Root(root.real, value), part) for root, _ in found if root.imag.is_zero()]
    return sorted(roots, key=lambda pair: float(pair[0].ball.mid()))


def _between(balls: Sequence[arb]) -> list[fmpq]:
    """Rational numbers below, between and above disjoint balls in increasing order."""
    if not balls:
        return [fmpq(0)]
    middles = [_exact(ball.mid()) for ball in balls]
    radii = [_exact(ball.rad()) for ball in balls]
    lows = [m - r for m, r in zip(middles, radii, strict=True)]
    highs = [m + r for m, r in zip(middles, radii, strict=True)]
    inner = [_simplest(high, low) for high, low in zip(highs, lows[1:], strict=False)]
    return [fmpq(lows[0].floor()) - 1, *inner, fmpq(highs[-1].ceil()) + 1]


def _simplest(low: fmpq, high: fmpq) -> fmpq:
    """The rational number with the smallest denominator in an interval, by continued fractions."""
    if low < 0 < high:
        return fmpq(0)
    if high <= 0:
        return -_simplest(-high, -low)
    whole = fmpq(low.floor())
    if whole + 1 < high:
        return whole + 1
    if low == whole:
        return whole + 1 / (fmpq((1 / (high - whole)).floor()) + 1)
    return whole + 1 / _simplest(1 / (high - whole), 1 / (low - whole))


def _exact(number: arb) -> fmpq:
    mantissa, exponent = number.man_exp()
    power = int(exponent)
    return fmpq(int(mantissa) * 2 ** max(power, 0), 2 ** max(-power, 0))


def signs_in_one_variable(
    poly: fmpq_poly, facts: Sequence[tuple[fmpq_poly, bool]]
) -> frozenset[int]:
    """The signs of a polynomial where other polynomials are positive, strictly or not.

    The result is exact; it is empty if undecided or if there are no such points.
    """
    polys = [poly, *(fact for fact, _ in facts)]
    if any(p.degree() < 1 for p in polys) or sum(p.degree() for p in polys) > MOST_DEGREE:
        return frozenset()
    for precision in PRECISIONS:
        with ctx.workprec(precision):
            found = _signs(polys, [strict for _, strict in facts])
        if found is not None:
            return found
    return frozenset()


def _signs(polys: Sequence[fmpq_poly], strict: Sequence[bool]) -> frozenset[int] | None:
    """The signs of the first polynomial where the others are positive; None if inaccurate."""
    roots = _real_roots(polys)
    balls = [root.ball for root, _ in roots]
    # Overlapping balls leave the order of the roots open.
    if any(not a < b for a, b in pairwise(balls)):
        return None
    found = set()
    # All signs are constant between adjacent roots, so one point in each interval suffices.
    for at in _between(balls):
        own, *others = (_sign(poly(at)) for poly in polys)
        if all(sign > 0 for sign in others):
            found.add(own)
    for root, factor in roots:
        # A value is zero exactly if the irreducible factor of the root divides the polynomial.
        at_root = [0 if _divides(factor, poly) else _ball_sign(poly, root.ball) for poly in polys]
        own, *others = (sign for sign in at_root if sign is not None)
        if None in at_root:
            return None
        if all(sign > 0 or (sign == 0 and not s) for sign, s in zip(others, strict, strict=True)):
            found.add(own)
    return frozenset(found)


def _divides(factor: fmpz_poly, poly: fmpq_poly) -> bool:
    return not divmod(poly, fmpq_poly(list(map(int, factor))))[1]


def _ball_sign(poly: fmpq_poly, at: arb) -> int | None:
    """The sign at a ball; None if the ball is too wide."""
    total = arb(0)
    for number in reversed(list(poly)):
        total = total * at + arb(number)
    return _sign(total) or None


def _sign(number: fmpq | arb) -> int:
    return int(number > 0) - int(number < 0)


def in_one_variable(poly: Poly, position: int) -> fmpq_poly:
    """A polynomial in one generator as a univariate polynomial."""
    coefficients = [fmpq(0)] * (int(poly.degrees()[position]) + 1)
    for exponents, number in poly.to_dict().items():
        coefficients[int(exponents[position])] = number
    return fmpq_poly(coefficients)


def only_variable(poly: Poly) -> int | None:
    """The index of the only variable of a polynomial; None if there are several or none."""
    places = [i for i, degree in enumerate(poly.degrees()) if degree]
    return places[0] if len(places) == 1 else None


def meets(first: Poly, second: Poly) -> bool:
    """True if two polynomials have a variable in common."""
    return any(a and b for a, b in zip(first.degrees(), second.degrees(), strict=True))
