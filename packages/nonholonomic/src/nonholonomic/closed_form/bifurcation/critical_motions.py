"""The motions over a curve of a bifurcation diagram: circles and their stability.

Over a rational x, the height y of an arc is an algebraic number.  Signs of formulas in it are
decided in ball arithmetic, with as many digits as necessary.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TypeVar

from flint import acb, arb, arb_poly, ctx, fmpq, fmpq_mpoly

from flowlanes.formulas.balls import exact

from .arrangement import FIRST_PRECISION, stack
from .tori import SHEETS, Oval, group, ovals

#: Precision in bits at which a sign counts as undecidable.
LAST_PRECISION = 4096


class UndecidedError(ArithmeticError):
    """A ball is too wide to decide a sign; more digits may suffice."""


@dataclass(frozen=True, order=True)
class Circles:
    """Periodic motions along which one separated coordinate rests at a double root of the curve.

    Attributes
    ----------
    pole : int
        Number i of the pole that the double root is: νᵢ vanishes; 0 for another double root.
    coordinate : int
        1 or 2, the coordinate that rests; 0 at the second pole, where either may.
    oval : Oval
        Where the other coordinate moves.
    count : int
        Number of circles in the phase space, on every level of the arc.
    stable : bool
        Whether tori surround them; if not, they have separatrices.
    """

    pole: int
    coordinate: int
    oval: Oval
    count: int
    stable: bool


@dataclass(frozen=True)
class Arc:
    """A point of an arc, available to any precision.

    Attributes
    ----------
    curves : tuple of fmpq_mpoly
        All curves of the arrangement.
    rank : int
        Number of arcs below this one over x.
    """

    curves: tuple[fmpq_mpoly, ...]
    x: fmpq
    rank: int

    def restriction(self, polynomial: fmpq_mpoly) -> arb_poly:
        """A polynomial in x, y, z as a polynomial in z with ball coefficients."""
        y, _ = stack(self.curves, self.x)[self.rank]
        coefficients: dict[int, arb] = {}
        for (i, j, power), value in polynomial.to_dict().items():
            coefficients[power] = coefficients.get(power, arb(0)) + arb(value * self.x**i) * y**j
        return arb_poly([coefficients.get(power, arb(0)) for power in range(max(coefficients) + 1)])


T = TypeVar("T")


def with_enough_digits(question: Callable[[], T]) -> T:
    """The value of a function of balls, evaluated with increasing precision until it is decided."""
    precision = FIRST_PRECISION
    while True:
        with ctx.workprec(precision):
            try:
                return question()
            except (UndecidedError, ValueError):
                if precision >= LAST_PRECISION:
                    raise
        precision *= 2


def circles_at_a_pole(
    arc: Arc, poles: Sequence[fmpq], cofactor: fmpq_mpoly, number: int
) -> tuple[Circles, ...]:
    """The motions with νᵢ = 0 where a root meets the pole e_i, i = `number`."""
    pole = poles[number - 1]
    others = [other for other in poles if other != pole]
    first, last = {1: (1, 2), 2: (0, 2), 3: (0, 1)}[number]

    def answer() -> tuple[Circles, ...]:
        left = _quotient(arc.restriction(cofactor), arb(pole))
        curvature = left
        for other in others:
            curvature = curvature * arb_poly([-arb(other), 1])
        # At the second pole: the whole interval between the others, which this pole does not
        # interrupt.
        intervals = _allowed_ovals(curvature, left, poles, (first, last), omitted_pole=number)
        # There y² = (z − e_i)² · curvature.  Where it is negative the double root is an isolated
        # point of the real curve; where it is positive, separatrices meet.
        stable = not _positive(curvature(arb(pole)))
        coordinate = {1: 1, 2: 0, 3: 2}[number]
        return tuple(
            Circles(number, coordinate, oval, SHEETS // 2 // len(group([oval.flips])), stable)
            for oval in intervals
        )

    return tuple(with_enough_digits(answer))


def circles_at_a_double_root(
    arc: Arc, poles: Sequence[fmpq], cofactor: fmpq_mpoly
) -> tuple[Circles, ...]:
    """The motions along which a coordinate rests at a double root other than a pole."""

    def answer() -> tuple[Circles, ...]:
        whole = arc.restriction(cofactor)
        place = _double(whole)
        if place is None:
            return ()
        inside = [_positive(place - arb(pole)) for pole in poles]
        if inside[0] == inside[2]:
            return ()
        coordinate = 2 if inside[1] else 1
        left = _quotient(_quotient(whole, place), place)
        curvature = left
        for pole in poles:
            curvature = curvature * arb_poly([-arb(pole), 1])
        between = (0, 1) if coordinate == 2 else (1, 2)
        intervals = _allowed_ovals(curvature, left, poles, between, omitted_pole=0)
        stable = not _positive(curvature(place))
        return tuple(
            Circles(0, coordinate, oval, SHEETS // len(group([oval.flips])), stable)
            for oval in intervals
        )

    return tuple(with_enough_digits(answer))


def _positive(ball: arb) -> bool:
    """The sign of a number known not to be zero: whether it is positive."""
    if ball > 0:
        return True
    if ball < 0:
        return False
    raise UndecidedError


def _quotient(polynomial: arb_poly, root: arb) -> arb_poly:
    """Divide a polynomial by a linear factor z − root, by Horner's scheme."""
    quotient, carried = [], arb(0)
    for coefficient in reversed(polynomial.coeffs()):
        carried = carried * root + coefficient
        quotient.append(carried)
    return arb_poly(quotient[-2::-1])


def _double(polynomial: arb_poly) -> arb | None:
    """The real double root of a polynomial with one double root, or one complex pair of them.

    Returns
    -------
    arb or None
        None if the double roots are a complex pair.
    """
    candidates = [
        root for root in polynomial.derivative().complex_roots() if polynomial(root).contains(0)
    ]
    if len(candidates) == 2 and not any(root.imag.contains(0) for root in candidates):
        return None
    if len(candidates) != 1:
        raise UndecidedError
    # A complex root would occur together with its conjugate.
    double: arb = candidates[0].real
    return double


def _real_roots(polynomial: arb_poly) -> list[arb]:
    """The real roots of a polynomial with simple roots."""
    roots = [acb(root) for root in polynomial.complex_roots()] if polynomial.degree() > 0 else []
    real = []
    for number, root in enumerate(roots):
        if not root.imag.contains(0):
            continue
        # The conjugate is a root as well; if it cannot be a different one, the root is real.
        mirrored = root.conjugate()
        if any(mirrored.overlaps(other) for other in roots[:number] + roots[number + 1 :]):
            raise UndecidedError
        real.append(root.real)
    return real


def _allowed_ovals(
    sign: arb_poly,
    cofactor: arb_poly,
    poles: Sequence[fmpq],
    between: tuple[int, int],
    omitted_pole: int,
) -> tuple[Oval, ...]:
    """The ovals between two poles where `sign`, with the roots of `cofactor`, is positive."""
    first, last = between
    low, high = poles[first], poles[last]
    roots: list[tuple[arb, int]] = [
        (arb(pole), n)
        for n, pole in enumerate(poles, 1)
        if low <= pole <= high and n != omitted_pole
    ]
    for root in _real_roots(cofactor):
        if _positive(root - arb(low)) and not _positive(root - arb(high)):
            roots.append((root, 0))
    roots.sort(key=lambda pair: exact(pair[0]))
    if not all(_positive(b - a) for (a, _), (b, _) in pairwise(roots)):
        raise UndecidedError
    return ovals(roots, lambda z: _positive(sign(arb(z))))
