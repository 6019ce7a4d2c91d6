"""Abelian integrals of the first kind on a real curve, as balls.

On the interval between neighbouring roots l and r, the substitution z = ½(l + r) − ½(r − l) cos s
turns dz/√|R| into ds/√rest, which is analytic along the path; ball arithmetic integrates it with a
guaranteed error.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product

from flint import acb, arb, arb_mat

from flowlanes.formulas.balls import number

from .curve import Curve, DegenerateError

Pair = tuple[arb, arb]
#: Two pairs of integers.
Integers = tuple[tuple[int, int], tuple[int, int]]


def abelian(curve: Curve, left: int, end: arb | None = None) -> Pair:
    """∫ dz/√|R| and ∫ z dz/√|R|; see `abelian_integral`."""
    return abelian_integral(curve, left, 0, end), abelian_integral(curve, left, 1, end)


def abelian_integral(curve: Curve, left: int, power: int, end: arb | None = None) -> arb:
    """∫ z^power dz/√|R| from the root number `left` to the place s = `end`.

    Parameters
    ----------
    left : int
        Number of the left end of a bounded interval.
    power : int
    end : arb, optional
        In radians, from −½π to ³⁄₂π; π, the other end of the interval, if left out.
    """
    low, high = curve.ends(left)
    middle, half = (low + high) / 2, (high - low) / 2

    def form(s: acb, analytic: bool) -> acb:
        z = middle - half * s.cos()
        integrand: acb = z**power / curve.cofactor(left, s).sqrt(analytic=analytic)
        return integrand

    # the relative accuracy aimed at is that of the working precision
    return acb.integral(form, acb(0), acb(arb.pi() if end is None else end)).real


@dataclass(frozen=True)
class Lattice:
    """Periods of the curve for a motion on two of its ovals.

    The normalised differentials ω = P⁻¹ (dz/y, z dz/y) have integrals δ_jk over two cycles, whole
    combinations of the two ovals, and the period matrix is iY.  Of all such pairs of cycles the one
    is taken whose form Y is reduced, |2Y₁₂| ≤ Y₁₁ ≤ Y₂₂: there theta series are shortest.

    Attributes
    ----------
    ovals : (int, int)
        The left ends of the ovals of z₁ and z₂.
    inverse : arb_mat (2, 2)
        P⁻¹.
    basis : ((int, int), (int, int))
        The unimodular matrix that turns phases counted around the ovals into phases v.
    Y : arb_mat (2, 2)
        Symmetric, positive definite, reduced.
    halves : tuple of ((x_1, x_2), (y_1, y_2))
        The Abelian image of every branch point from the first root, x + iY y, in units of one
        half (integers), for the roots in increasing order and for infinity when it is one.
    """

    curve: Curve
    ovals: tuple[int, int]
    inverse: arb_mat
    basis: Integers
    Y: arb_mat
    halves: tuple[Integers, ...]

    def normalised_integrals(self, pair: Pair) -> Pair:
        """P⁻¹ applied to a pair of integrals."""
        return _matrix_product(self.inverse, pair)

    def around_ovals(self, v: Pair) -> Pair:
        """Phases, or their rates, counted around the ovals of z₁ and z₂."""
        (p, q), (r, s) = self.basis
        determinant = p * s - q * r
        return (s * v[0] - q * v[1]) * determinant, (p * v[1] - r * v[0]) * determinant

    def characteristic(self, root: int) -> Integers:
        """The odd characteristic (a, b) of a branch point, in units of one half, modulo 2."""
        (k_x, k_y) = self._constant
        x, y = self.halves[root]
        a = ((y[0] + k_y[0]) % 2, (y[1] + k_y[1]) % 2)
        b = ((x[0] + k_x[0]) % 2, (x[1] + k_x[1]) % 2)
        return a, b

    @property
    def _constant(self) -> Integers:
        """Riemann's constant, which makes the images of all six branch points odd half-periods."""
        # In genus two exactly six characteristics are odd, one for each branch point (Mumford, Tata
        # Lectures on Theta II, chapter IIIa), and one translation takes the images there.
        for k in product((0, 1), repeat=4):
            k_x, k_y = (k[0], k[1]), (k[2], k[3])
            if all(
                sum((x[i] + k_x[i]) * (y[i] + k_y[i]) for i in (0, 1)) % 2 for x, y in self.halves
            ):
                return k_x, k_y
        raise ArithmeticError("the images of the branch points are no half-periods")


def lattice(curve: Curve, ovals: tuple[int, int]) -> Lattice:
    """Periods for a motion with z₁ and z₂ on the given ovals.

    Parameters
    ----------
    ovals : (int, int)
        Their left ends; see :attr:`Curve.ovals`.

    Along the upper side of the real line dz/y is multiplied by i at every root, and the integral
    over the whole line vanishes.  So of the six intervals between branch points four are
    integrated, and the other two follow.
    """
    steps = [_multiple(abelian(curve, left), _sign(left)) for left in range(4)]
    steps.append(_multiple(_sum(steps[0], steps[2]), -1))
    steps.append(_multiple(_sum(steps[1], steps[3]), -1))
    first, second = (_multiple(steps[oval], 2 * _sign(oval)) for oval in ovals)
    P = arb_mat([[first[m], second[m]] for m in (0, 1)])
    normal = P.inv()
    (third,) = {curve.first_oval, curve.first_oval + 2, curve.first_oval + 4} - set(ovals)
    rows = []
    for index, oval in enumerate(ovals):
        between = (oval + 1) % 6 if (oval + 2) % 6 == third else (oval - 1) % 6
        row = _matrix_product(normal, _multiple(steps[between], 2))
        # The conjugate cycle is oriented such that Y is positive.
        rows.append(row if row[index] > 0 else _multiple(row, -1))
    # Y is symmetric by Riemann's bilinear relations: both balls contain the same number.
    shared = rows[0][1].intersection(rows[1][0])
    basis, Y = _reduced_form(arb_mat([[rows[0][0], shared], [shared, rows[1][1]]]))
    normal = arb_mat([list(row) for row in basis]) * normal
    return Lattice(curve, ovals, normal, basis, Y, _halves(curve, steps, normal, Y))


def _reduced_form(Y: arb_mat) -> tuple[Integers, arb_mat]:
    """Lagrange's reduction of a positive definite form: the basis, and the form in it."""
    first, second = (1, 0), (0, 1)

    def form(one: tuple[int, int], other: tuple[int, int]) -> arb:
        return sum((one[i] * other[j] * Y[i, j] for i in (0, 1) for j in (0, 1)), arb(0))

    while True:
        if form(second, second).mid() < form(first, first).mid():
            first, second = second, first
        nearest = round(number(form(first, second)) / number(form(first, first)))
        if nearest == 0:
            break
        second = (second[0] - nearest * first[0], second[1] - nearest * first[1])
    off = form(first, second)
    return (first, second), arb_mat([[form(first, first), off], [off, form(second, second)]])


def _sign(left: int) -> int:
    """i^left without the factor i of odd indices."""
    return 1 - 2 * ((left // 2) % 2)


def _halves(curve: Curve, steps: list[Pair], normal: arb_mat, Y: arb_mat) -> tuple[Integers, ...]:
    """Images of the branch points: ovals give the real part, gaps the imaginary part."""
    images = [((0, 0), (0, 0))]
    real: Pair = (arb(0), arb(0))
    imaginary: Pair = (arb(0), arb(0))
    inverse_Y = Y.inv()
    for left, step in enumerate(steps[:5]):
        if left % 2 == curve.first_oval:
            real = _sum(real, _matrix_product(normal, step))
        else:
            imaginary = _sum(imaginary, _matrix_product(normal, step))
        images.append((_integers(real), _integers(_matrix_product(inverse_Y, imaginary))))
    return tuple(images)


def _integers(pair: Pair) -> tuple[int, int]:
    """Twice a pair of half-integers."""
    one, two = ((2 * x).unique_fmpz() for x in pair)
    if one is None or two is None:
        raise DegenerateError
    return int(one), int(two)


def _matrix_product(matrix: arb_mat, pair: Pair) -> Pair:
    result = matrix * arb_mat([[pair[0]], [pair[1]]])
    return result[0, 0], result[1, 0]


def _sum(one: Pair, other: Pair) -> Pair:
    return one[0] + other[0], one[1] + other[1]


def _multiple(pair: Pair, factor: int) -> Pair:
    return factor * pair[0], factor * pair[1]
