"""Motion of the unit vector ν on the torus: theta functions of linearly growing phases.

ν = N/|N| with N_i = c_i θ[δ_i](v), v = v₀ + Vτ, where δ_i belongs to the i-th pole of the curve.
ν has the period 2 in each of the two phases.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from flint import arb, fmpq

from flowlanes.formulas.balls import number
from flowlanes.formulas.relative_zero import vanishes
from flowlanes.system.arrays import FloatArray

from .curve import Curve
from .periods import Lattice, Pair, abelian, lattice
from .theta import Theta

#: Tolerance of a motion at its start, relative to ν and ν′: near separatrices digits are lost.
_SHIFT = fmpq(1, 2**30)

Triple = tuple[arb, arb, arb]


@dataclass(frozen=True)
class Divisor:
    """Two points (z, y) of the curve."""

    z: Pair
    y: Pair


def divisor_of(
    nu: Sequence[arb],
    nuprime: Sequence[arb],
    poles: Sequence[arb],
    weights: Sequence[arb],
    speeds: Sequence[arb],
) -> Divisor:
    """The two points of the curve that correspond to ν and ν′.

    κ(x − z₁)(x − z₂) is the quadratic that has the value ν_i²/weights_i at each pole x = e_i.
    """
    heights = [x * x / w for x, w in zip(nu, weights, strict=True)]
    rates = [2 * x * p / w for x, p, w in zip(nu, nuprime, weights, strict=True)]
    kappa, linear, constant = _through(poles, heights)
    change = _through(poles, rates)
    total, product = -linear / kappa, constant / kappa
    gap = (total * total - 4 * product).sqrt()
    z = ((total - gap) / 2, (total + gap) / 2)
    a, b = speeds

    def height(own: arb, other: arb) -> arb:
        # Differentiated, κ(x − z₁)(x − z₂) = q(x) is −κ z₁′(z₁ − z₂) = q′(z₁) at x = z₁, and Σ dz/y
        # = a dτ, Σ z dz/y = b dτ give z₁′(z₁ − z₂) = y₁ (b − a z₂).
        return -(change[0] * own * own + change[1] * own + change[2]) / (kappa * (b - a * other))

    return Divisor(z, (height(z[0], z[1]), height(z[1], z[0])))


def _through(places: Sequence[arb], heights: Sequence[arb]) -> Triple:
    """Coefficients of x², x, 1 of the quadratic with given values at three points."""
    result = [arb(0), arb(0), arb(0)]
    for i, height in enumerate(heights):
        j, k = (i + 1) % 3, (i + 2) % 3
        share = height / ((places[i] - places[j]) * (places[i] - places[k]))
        result[0] += share
        result[1] -= share * (places[j] + places[k])
        result[2] += share * places[j] * places[k]
    return result[0], result[1], result[2]


@dataclass(frozen=True)
class InvariantTorus:
    """ν as a function of τ.

    Attributes
    ----------
    thetas : tuple of Theta
        One for each component of ν.
    factors : tuple of arb
        c_i, with their signs.
    V : (arb, arb)
        Velocity of the phases in τ.
    v_0 : (arb, arb)
        Phases at τ = 0.
    along : (arb, arb)
        The direction on the torus in which ν′ is the derivative of ν; usually V.
    """

    lattice: Lattice
    thetas: tuple[Theta, Theta, Theta]
    factors: Triple
    V: Pair
    v_0: Pair
    along: Pair

    def numerators(self, v: Sequence[arb]) -> tuple[list[arb], list[arb]]:
        """N and N′ at the phases v, as balls."""
        pairs = [theta.ball(v, self.along) for theta in self.thetas]
        N = [c * value for c, (value, _) in zip(self.factors, pairs, strict=True)]
        return N, [c * rate for c, (_, rate) in zip(self.factors, pairs, strict=True)]

    def ball(self, v: Sequence[arb]) -> tuple[Triple, Triple]:
        """ν and ν′ at the phases v, as balls."""
        N, rate = self.numerators(v)
        square = sum((x * x for x in N), arb(0))
        length = square.sqrt()
        pull = sum((x * r for x, r in zip(N, rate, strict=True)), arb(0)) / square
        nu = [x / length for x in N]
        nuprime = [(r - pull * x) / length for x, r in zip(N, rate, strict=True)]
        return (nu[0], nu[1], nu[2]), (nuprime[0], nuprime[1], nuprime[2])

    @property
    def turns(self) -> Pair:
        """Revolutions of z₁ and z₂ about their ovals per unit of τ."""
        return self.lattice.around_ovals(self.V)

    @cached_property
    def _numbers(self) -> tuple[FloatArray, FloatArray]:
        return (
            np.array([number(c) for c in self.factors]),
            np.array([number(x) for x in self.along]),
        )

    def values(self, v: FloatArray) -> tuple[FloatArray, FloatArray]:
        """ν and ν′ at phases v (n, 2), as arrays (3, n)."""
        factors, along = self._numbers
        pairs = [theta.values(v, along) for theta in self.thetas]
        N = np.array([c * pair[0] for c, pair in zip(factors, pairs, strict=True)])
        rate = np.array([c * pair[1] for c, pair in zip(factors, pairs, strict=True)])
        square = np.sum(N * N, axis=0)
        length = np.sqrt(square)
        pull = np.sum(N * rate, axis=0) / square
        return N / length, (rate - pull * N) / length


def torus(
    curve: Curve,
    poles: Sequence[arb],
    weights: Sequence[arb],
    speeds: Sequence[arb],
    nu: Sequence[arb],
    nuprime: Sequence[arb],
    along: Sequence[arb] | None = None,
) -> InvariantTorus:
    """The motion through ν, ν′ at τ = 0.

    Parameters
    ----------
    poles, weights : three arb each
        See :class:`nonholonomic.closed_form.genus_two.separation.SeparatedSystem`.
    speeds : two arb
        a and b.
    nu, nuprime : three arb each
        Body axes; ν of unit length.
    along : two arb, optional
        The speeds of the flow along which ν′ is the derivative of ν, if not `speeds`.

    Raises
    ------
    DegenerateError
        If the curve may have a double root, as far as its balls say.
    ArithmeticError
        If ν does not fit the curve.
    """
    start = divisor_of(nu, nuprime, poles, weights, speeds if along is None else along)
    ovals = (curve.oval_of(start.z[0]), curve.oval_of(start.z[1]))
    periods = lattice(curve, ovals)
    V = periods.normalised_integrals((speeds[0], speeds[1]))
    turning = V if along is None else periods.normalised_integrals((along[0], along[1]))
    v_0 = _phases(
        periods,
        [
            _oval_angle(curve, left, z, y)
            for left, z, y in zip(ovals, start.z, start.y, strict=True)
        ],
    )
    places = [_root_number(curve, pole) for pole in poles]
    halves = periods.halves
    # On the real motion v has the constant imaginary part iYη, which shifts the characteristics.
    shift = [halves[ovals[0]][1][i] + halves[ovals[1]][1][i] for i in (0, 1)]
    thetas = []
    for place in places:
        a, b = periods.characteristic(place)
        thetas.append(Theta(periods.Y, (((a[0] + shift[0]) % 2, (a[1] + shift[1]) % 2), b)))
    # At the middle of both ovals ν_i² is known up to a common factor.
    quarter = arb.pi() / 2
    middle = _phases(periods, [quarter, quarter])
    z = [_abscissa(curve, left, quarter) for left in ovals]
    factors = []
    for theta, pole, weight, own, rate in zip(thetas, poles, weights, nu, nuprime, strict=True):
        square = weight * (pole - z[0]) * (pole - z[1])
        height, _ = theta.ball(middle, turning)
        factor = abs(square).sqrt() / abs(height)
        value, slope = theta.ball(v_0, turning)
        # The sign of a vanishing component follows from its rate.
        agrees = value * own > 0 if abs(own) > arb(2) ** -40 else slope * rate > 0
        factors.append(factor if agrees else -factor)
    motion = InvariantTorus(
        periods,
        (thetas[0], thetas[1], thetas[2]),
        (factors[0], factors[1], factors[2]),
        V,
        v_0,
        turning,
    )
    for computed, expected in zip(motion.ball(v_0), (nu, nuprime), strict=True):
        size = sum((abs(x) for x in expected), arb(0))
        for x, y in zip(computed, expected, strict=True):
            if not vanishes(x - y, size, _SHIFT):
                raise ArithmeticError("the closed form does not pass through its start")
    return motion


def _root_number(curve: Curve, pole: arb) -> int:
    """The index of the root that is a given pole."""
    (place,) = [i for i, root in enumerate(curve.roots) if root.overlaps(pole)]
    return place


def _abscissa(curve: Curve, left: int, s: arb) -> arb:
    low, high = curve.ends(left)
    abscissa: arb = (low + high) / 2 - (high - low) / 2 * s.cos()
    return abscissa


def _oval_angle(curve: Curve, left: int, z: arb, y: arb) -> arb:
    """The angle s of a point on its oval, from −½π to ³⁄₂π."""
    low, high = curve.ends(left)
    half = (high - low) / 2
    others = abs(curve.leading)
    for place, root in enumerate(curve.roots):
        if place not in (left, left + 1):
            others = others * abs(z - root)
    sine = y / (half * others.sqrt())
    cosine = ((low + high) / 2 - z) / half
    # The branch is cut away from turning points.
    return arb.pi() - arb.atan2(sine, -cosine) if cosine < 0 else arb.atan2(sine, cosine)


def _phases(periods: Lattice, angles: Sequence[arb]) -> Pair:
    """The real part of the Abelian image of two points, from the first root."""
    total: Pair = (arb(0), arb(0))
    for left, s in zip(periods.ovals, angles, strict=True):
        step = abelian(periods.curve, left, s)
        total = (total[0] + step[0], total[1] + step[1])
    v = periods.normalised_integrals(total)
    halves = [periods.halves[left][0] for left in periods.ovals]
    return (
        v[0] + arb(halves[0][0] + halves[1][0]) / 2,
        v[1] + arb(halves[0][1] + halves[1][1]) / 2,
    )
