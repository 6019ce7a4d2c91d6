"""Exact subdivision of the plane by algebraic curves: a cylindrical decomposition.

The curves are polynomials with rational coefficients in two variables x and y.  Over the open
intervals (columns) between the critical values of x they do not intersect and have no vertical
tangents, so they lie above each other in a fixed order: arcs, with cells between them.  A cell is
represented by a rational point.  Cells that share an open piece of a critical vertical line are
joined.  Vertical curves only separate columns.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations, pairwise
from typing import Any, TypeAlias

from flint import Ordering, arb, ctx, fmpq, fmpq_mpoly, fmpq_mpoly_ctx, fmpq_poly

from flowlanes.formulas.balls import exact

#: Polynomials in the two coordinates of the plane and the variable of the curve y² = P(z).
RING = fmpq_mpoly_ctx.get(("x", "y", "z"), Ordering.lex)
X, Y, _Z = RING.gens()

Cell: TypeAlias = tuple[int, int]

#: Initial precision, in bits, for isolating roots; it is doubled until they are separated.
FIRST_PRECISION = 64
#: Precision beyond which roots count as equal, contrary to the assumption.
MOST_PRECISION = 1 << 16


@dataclass(frozen=True)
class Arrangement:
    """Curves in the plane, and the cells between them.

    Attributes
    ----------
    curves : tuple of fmpq_mpoly
        Irreducible and different polynomials, none of a vertical line.
    critical : tuple of fmpq_poly
        Irreducible; their real roots are the critical values of x.
    abscissae : tuple of arb
        These values, increasing.
    samples : tuple of fmpq
        One x in every column, one more than there are abscissae.
    orders : tuple of tuple of int
        For every column the curves over it, by number, from below.
    joints : frozenset of pairs of cells
        Cells of neighbouring columns that touch.  A cell is (column, rank from below).
    """

    curves: tuple[fmpq_mpoly, ...]
    critical: tuple[fmpq_poly, ...]
    abscissae: tuple[arb, ...]
    samples: tuple[fmpq, ...]
    orders: tuple[tuple[int, ...], ...]
    joints: frozenset[tuple[Cell, Cell]]

    @property
    def cells(self) -> Iterator[Cell]:
        """All cells, column by column, from below."""
        for column, order in enumerate(self.orders):
            for rank in range(len(order) + 1):
                yield column, rank

    @property
    def arcs(self) -> Iterator[Cell]:
        """All arcs, as (column, rank): the arc lies above the cell of the same numbers."""
        for column, order in enumerate(self.orders):
            for rank in range(len(order)):
                yield column, rank

    def ordinates(self, column: int, x: fmpq) -> list[arb]:
        """The heights y (balls) of the arcs over an x of a column."""
        return [y for y, _ in stack(self.curves, x)]

    def sample(self, cell: Cell) -> tuple[fmpq, fmpq]:
        """A rational point of a cell."""
        column, rank = cell
        x = self.samples[column]
        return x, _gaps([y for y, _ in stack(self.curves, x)])[rank]

    def cell(self, x: fmpq, y: fmpq) -> Cell | None:
        """The cell of a point; on a critical vertical the one to its right; None on a curve."""
        crossings = [on_horizontal(curve, y) for curve in self.curves]
        if any(polynomial(x) == 0 for polynomial in crossings):
            return None
        (line,) = irreducible([fmpq_poly([-x, 1])])
        others = [p for p in irreducible(crossings) if str(p) not in map(str, self.critical)]
        factors = [*self.critical, *others]
        if line not in factors:
            factors.append(line)
        roots = ordered_roots(factors)
        here = next(n for n, (_, number) in enumerate(roots) if factors[number] == line)
        # Just right of the point, before any curve and any other critical vertical.
        beside = _gaps([root for root, _ in roots])[here + 1]
        column = sum(number < len(self.critical) for _, number in roots[: here + 1])
        return column, _rank(self.curves, beside, y)

    def arc(self, x: fmpq, y: fmpq) -> Cell | None:
        """The arc of a point; None on a critical vertical or off the curves."""
        here = [n for n, curve in enumerate(self.curves) if on_horizontal(curve, y)(x) == 0]
        if not here or any(polynomial(x) == 0 for polynomial in self.critical):
            return None
        roots = ordered_roots([*self.critical, fmpq_poly([-x, 1])])
        column = [number for _, number in roots].index(len(self.critical))
        (rank,) = (
            place
            for place, (height, number) in enumerate(stack(self.curves, x))
            if number == here[0] and lowest(height) <= fraction(y) <= highest(height)
        )
        return column, rank


def arrangement(curves: Iterable[fmpq_mpoly]) -> Arrangement:
    """Subdivide the plane by curves.

    Parameters
    ----------
    curves : iterable of fmpq_mpoly
        In x and y alone; factors are found and counted once.
    """
    factors: dict[str, fmpq_mpoly] = {}
    for curve in curves:
        for factor, _ in curve.factor()[1]:
            factors.setdefault(str(factor), factor)
    standing = tuple(f for f in factors.values() if f.degrees()[1] == 0)
    lying = tuple(f for f in factors.values() if f.degrees()[1] > 0)
    critical = _critical(lying, standing)
    roots = ordered_roots(critical)
    samples = tuple(_gaps([root for root, _ in roots]))
    orders = tuple(tuple(number for _, number in stack(lying, x)) for x in samples)
    abscissae = tuple(root for root, _ in roots)
    joints: set[tuple[Cell, Cell]] = set()
    for place, (_, number) in enumerate(roots):
        for y in _heights(lying, critical[number]):
            left, right = _neighbouring_abscissae(lying, critical, place, y)
            joints.add(((place, _rank(lying, left, y)), (place + 1, _rank(lying, right, y))))
    return Arrangement(lying, tuple(critical), abscissae, samples, orders, frozenset(joints))


def _critical(lying: Sequence[fmpq_mpoly], standing: Sequence[fmpq_mpoly]) -> list[fmpq_poly]:
    """Irreducible polynomials in x whose roots are the critical values."""
    # The projection of a cylindrical algebraic decomposition (Collins 1975): curves go to infinity
    # at zeros of their leading coefficients, are vertical or singular at zeros of their
    # discriminants, and meet at zeros of their resultants.
    polynomials = list(standing)
    for curve in lying:
        height = curve.degrees()[1]
        polynomials.append(_coefficient(curve, height))
        if height > 1:
            polynomials.append(curve.discriminant("y"))
    polynomials += [one.resultant(other, "y") for one, other in combinations(lying, 2)]
    return irreducible(map(_univariate, polynomials))


def _coefficient(curve: fmpq_mpoly, power: int) -> fmpq_mpoly:
    """The coefficient of a power of y."""
    return RING.from_dict(
        {(i, 0, 0): value for (i, j, _), value in curve.to_dict().items() if j == power}
    )


def _univariate(polynomial: fmpq_mpoly) -> fmpq_poly:
    """Convert a polynomial that involves only x to one variable."""
    restriction = fmpq_poly()
    for (power, _, _), value in polynomial.to_dict().items():
        restriction[power] = value
    return restriction


def on_vertical(curve: fmpq_mpoly, x: fmpq) -> fmpq_poly:
    """The restriction of a curve to one x, as a polynomial in y."""
    restriction = fmpq_poly()
    for (i, j, _), value in curve.to_dict().items():
        restriction[j] = restriction[j] + value * x**i
    return restriction


def on_horizontal(curve: fmpq_mpoly, y: fmpq) -> fmpq_poly:
    """The restriction of a curve to one y, as a polynomial in x."""
    restriction = fmpq_poly()
    for (i, j, _), value in curve.to_dict().items():
        restriction[i] = restriction[i] + value * y**j
    return restriction


def real_roots(polynomial: fmpq_poly) -> list[arb]:
    """The real roots of a polynomial, as disjoint balls, unordered."""
    if polynomial.degree() < 1:
        return []
    roots: Any = polynomial.complex_roots()
    return [root.real for root, _ in roots if isinstance(root, arb) or root.imag == 0]


def ordered_roots(polynomials: Sequence[fmpq_poly]) -> list[tuple[arb, int]]:
    """The real roots of coprime polynomials, increasing, each with the index of its polynomial."""
    precision = FIRST_PRECISION
    while precision <= MOST_PRECISION:
        with ctx.workprec(precision):
            roots = [(root, n) for n, p in enumerate(polynomials) for root in real_roots(p)]
            roots.sort(key=lambda pair: exact(pair[0]))
            if all(low < high for (low, _), (high, _) in pairwise(roots)):
                return roots
        precision *= 2
    raise ArithmeticError("polynomials without a common root were expected")


def stack(curves: Sequence[fmpq_mpoly], x: fmpq) -> list[tuple[arb, int]]:
    """The heights of the curves over a noncritical x, each with the index of its curve."""
    return ordered_roots([on_vertical(curve, x) for curve in curves])


def _rank(curves: Sequence[fmpq_mpoly], x: fmpq, y: fmpq) -> int:
    """The number of arcs below a point over a noncritical x."""
    line = fmpq_poly([-y, 1])
    roots = ordered_roots([*(on_vertical(curve, x) for curve in curves), line])
    return [number for _, number in roots].index(len(curves))


def _heights(curves: Sequence[fmpq_mpoly], critical: fmpq_poly) -> list[fmpq]:
    """Rational heights, at least one in every gap between the curves over a critical x."""
    # The resultant with the irreducible polynomial of x vanishes at the heights over all conjugate
    # values too.  That only adds gaps, and it stays rational.
    at = RING.from_dict({(n, 0, 0): value for n, value in enumerate(critical.coeffs()) if value})
    shadows = []
    for curve in curves:
        shadow = fmpq_poly()
        for (_, power, _), value in curve.resultant(at, "x").to_dict().items():
            shadow[power] = value
        shadows.append(shadow)
    return _gaps([root for root, _ in ordered_roots(irreducible(shadows))])


def _neighbouring_abscissae(
    curves: Sequence[fmpq_mpoly], critical: Sequence[fmpq_poly], place: int, y: fmpq
) -> tuple[fmpq, fmpq]:
    """One x on either side of a critical one, with no curve on the horizontal line in between."""
    crossings = irreducible(on_horizontal(curve, y) for curve in curves)
    known = {str(factor) for factor in critical}
    others = [factor for factor in crossings if str(factor) not in known]
    roots = ordered_roots([*critical, *others])
    here = [n for n, (_, number) in enumerate(roots) if number < len(critical)][place]
    gaps = _gaps([root for root, _ in roots])
    return gaps[here], gaps[here + 1]


def irreducible(polynomials: Iterable[fmpq_poly]) -> list[fmpq_poly]:
    """The irreducible factors of polynomials, each once, without constants."""
    factors: dict[str, fmpq_poly] = {}
    for polynomial in polynomials:
        for factor, _ in polynomial.factor()[1]:
            factors.setdefault(str(factor), factor)
    return list(factors.values())


def _gaps(roots: Sequence[arb]) -> list[fmpq]:
    """A short rational number below, between and above increasing real numbers."""
    if not roots:
        return [fmpq(0)]
    low, high = lowest(roots[0]), highest(roots[-1])
    inner = [short_rational(highest(a), lowest(b)) for a, b in pairwise(roots)]
    below, above = Fraction(math.floor(low) - 1), Fraction(math.ceil(high) + 1)
    return [rational(value) for value in (below, *inner, above)]


def short_rational(low: Fraction, high: Fraction) -> Fraction:
    """A rational number of small denominator strictly between two others, near the middle."""
    middle = (low + high) / 2
    limit = 1
    while not low < middle.limit_denominator(limit) < high:
        limit *= 2
    return middle.limit_denominator(limit)


def lowest(ball: arb) -> Fraction:
    """The lower end of a ball, exactly."""
    return exact(ball) - exact(ball.rad())


def highest(ball: arb) -> Fraction:
    """The upper end of a ball, exactly."""
    return exact(ball) + exact(ball.rad())


def fraction(number: fmpq) -> Fraction:
    """Convert a rational number from FLINT to Python."""
    return Fraction(int(number.p), int(number.q))


def rational(number: Fraction | int) -> fmpq:
    """Convert a rational number to FLINT."""
    value = Fraction(number)
    return fmpq(value.numerator, value.denominator)
