"""Polynomials in one variable: whether the positivity of some implies that of another.

Signs change only at real roots.  Roots of irreducible factors are isolated in disjoint balls.  The
signs are then determined at every root and at a rational point of every gap: exactly, or at a root
of another factor with a ball that does not contain zero.
"""

from __future__ import annotations

from collections.abc import Sequence

from flint import acb, arb, ctx, fmpq, fmpq_poly, fmpz_poly

from ..claim.polynomials import Poly

PRECISIONS = (128, 512, 2048, 8192)
DEGREE = 200


def is_positive_where(poly: Poly, facts: Sequence[tuple[Poly, bool]]) -> bool:
    """True if a polynomial is positive where others are positive or nonnegative.

    All polynomials must depend on one generator, the same for all; False if it is not certain.
    """
    places = {i for p in (poly, *(f for f, _ in facts)) for i, n in enumerate(p.degrees()) if n}
    if len(places) != 1:
        return False
    (place,) = places
    own = _univariate(poly, place)
    others = [(_univariate(fact, place), strict) for fact, strict in facts]
    if sum(p.degree() for p in (own, *(f for f, _ in others))) > DEGREE:
        return False
    factors = _factors([own, *(fact for fact, _ in others)])
    for precision in PRECISIONS:
        with ctx.workprec(precision):
            certain = _at_all_points(own, others, factors)
        if certain is not None:
            return certain
    return False


def _univariate(poly: Poly, place: int) -> fmpq_poly:
    numbers = [fmpq(0)] * (int(poly.degrees()[place]) + 1)
    for exponents, number in poly.to_dict().items():
        numbers[int(exponents[place])] = number
    return fmpq_poly(numbers)


def _factors(polys: Sequence[fmpq_poly]) -> list[fmpz_poly]:
    """Irreducible factors of polynomials, without repetitions."""
    factors: list[fmpz_poly] = []
    for poly in polys:
        factors += [part for part, _ in poly.numer().factor()[1] if part not in factors]
    return factors


def _at_all_points(
    own: fmpq_poly, others: Sequence[tuple[fmpq_poly, bool]], factors: Sequence[fmpz_poly]
) -> bool | None:
    """True if the first is positive at all points where the others are; None if undecided."""
    roots: list[tuple[arb, fmpq_poly]] = []
    for factor in factors:
        found: list[tuple[acb, int]] = factor.complex_roots()  # type: ignore[assignment]
        rational = fmpq_poly(list(map(int, factor)))
        roots += [(root.real, rational) for root, _ in found if root.imag.contains(0)]
    roots.sort(key=lambda pair: float(pair[0].mid()))
    ends = [(_number(ball.mid()), _number(ball.rad())) for ball, _ in roots]
    points, last = [], None
    for middle, radius in ends:
        # Overlapping balls may hide a gap between two roots, so a higher precision is needed.
        if last is not None and not last < middle - radius:
            return None
        points.append(middle - radius - 1 if last is None else (last + middle - radius) / 2)
        last = middle + radius
    points.append(fmpq(0) if last is None else last + 1)
    for at in points:
        if all(fact(at) > 0 for fact, _ in others) and not own(at) > 0:
            return False
    for ball, solved in roots:
        signs = [_sign(poly, solved, ball) for poly in (own, *(fact for fact, _ in others))]
        if None in signs:
            return None
        here = all(
            sign is not None and (sign > 0 or (sign == 0 and not strict))
            for sign, (_, strict) in zip(signs[1:], others, strict=True)
        )
        if here and signs[0] != 1:
            return False
    return True


def _sign(poly: fmpq_poly, factor: fmpq_poly, root: arb) -> int | None:
    """Sign of a polynomial at a root of an irreducible one; None if the ball is too wide."""
    if (poly % factor).degree() < 0:
        return 0
    value = arb(0)
    for number in reversed(list(poly)):
        value = value * root + arb(number)
    return 1 if value > 0 else -1 if value < 0 else None


def _number(exact: arb) -> fmpq:
    """Number represented by a ball of radius zero."""
    mantissa, exponent = map(int, exact.man_exp())
    return fmpq(mantissa << max(exponent, 0), 1 << max(-exponent, 0))
