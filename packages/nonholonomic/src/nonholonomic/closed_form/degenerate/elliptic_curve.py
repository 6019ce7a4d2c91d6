"""The curve that remains when two branch points collide, in theta functions.

Without its double root e the curve y² = R(z) of genus two is w² = R(z)/(z − e)², elliptic.  On the
oval w² ≥ 0 between the roots a < b, let c and d be the next roots above b, counted through infinity
(infinity itself is a root when their number is odd).  Then

    (z − a)/(z − d) ∝ θ₁²/θ₄²,   (z − b)/(z − d) ∝ θ₂²/θ₄²,   (z − c)/(z − d) ∝ θ₃²/θ₄²

of a real argument v that grows by π from a to a around the oval, and dz/w = scale · dv.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from flint import acb, arb

from .jacobi_theta import Thetas


@dataclass(frozen=True)
class Oval:
    """A bounded oval of a real elliptic curve whose branch points are all real.

    Attributes
    ----------
    leading : arb
        The coefficient of w² = leading ∏ (z − root).
    ends : (arb, arb)
        a < b.
    outer : (arb or None, arb or None)
        c and d; None stands for infinity.
    thetas : Thetas
    modulus : arb
        k², the parameter of the elliptic integrals.
    quarter : arb
        K(k²).
    scale : arb
        dz/w = scale · dv, positive: v and z grow together from a to b while w > 0.
    """

    leading: arb
    ends: tuple[arb, arb]
    outer: tuple[arb | None, arb | None]
    thetas: Thetas
    modulus: arb
    quarter: arb
    scale: arb

    def square(self, z: arb) -> arb:
        """w² at z."""
        value = self.leading
        for root in (*self.ends, *self.outer):
            value = value if root is None else value * (z - root)
        return value

    def index(self, root: arb) -> int | None:
        """The index of the theta function that vanishes with z − root, None if root is infinity."""
        for number, own in zip((1, 2, 3, 4), (*self.ends, *self.outer), strict=True):
            if own is not None and own.overlaps(root):
                return number
        return None

    def portion(self, z: arb) -> arb:
        """sn² at z: 0 at a, 1 at b."""
        (a, b), (_, d) = self.ends, self.outer
        return (z - a) / (b - a) * (1 if d is None else (b - d) / (z - d))

    def phase(self, z: arb, rate: arb) -> arb:
        """v at a point of the oval, for a motion that passes it with dz/dv of the sign of `rate`.

        Parameters
        ----------
        z, rate : arb
            A point and dz/dv there; at a turning point both decide by their middles.
        """
        x = self.portion(z)
        # The smaller of sine and cosine follows from the rate, which does not suffer from
        # cancellation.
        slope = self._portion_rate(z) * rate * arb.pi() / (2 * self.quarter)
        delta = (1 - self.modulus * x).sqrt()
        if x.mid() < 0.5:
            cosine = (1 - x).sqrt()
            sine = slope / (2 * cosine * delta)
            angle = sine.asin()
        else:
            sine = x.sqrt()
            angle = (slope / (2 * sine * delta)).acos()
        integral = acb.elliptic_f(acb(angle), acb(self.modulus))
        return integral.real * arb.pi() / (2 * self.quarter)

    def _portion_rate(self, z: arb) -> arb:
        (a, b), (_, d) = self.ends, self.outer
        return 1 / (b - a) if d is None else (b - d) * (a - d) / ((b - a) * (z - d) ** 2)

    def factor(self, root: arb) -> arb:
        """κ in z − root = κ θ²(v)/D(v), for a root; D is common to all roots."""
        index = self.index(root)
        a, b = self.ends
        d = self.outer[1]
        if index == 4:
            return arb(1)
        z, v = (b, arb.pi() / 2) if index == 1 else (a, arb(0))
        fraction = (z - root) if d is None else (z - root) / (z - d)
        value = self.thetas.value
        return fraction * (value(4, v) / value(index or 1, v)) ** 2

    def simple_factor(self, e: arb, s: arb) -> arb:
        """κ in z − e = κ θ₁(v − s) θ₁(v + s)/D(v), for a point e inside the oval, z(s) = e."""
        a, d = self.ends[0], self.outer[1]
        fraction = (a - e) if d is None else (a - e) / (a - d)
        value = self.thetas.value
        return -fraction * (value(4, arb(0)) / value(1, s)) ** 2


def oval_around(leading: arb, roots: Sequence[arb], z: arb) -> Oval | None:
    """The bounded oval that contains z, of w² = leading ∏ (z − root).

    Parameters
    ----------
    leading : arb
    roots : three or four arb
        Real and different, in any order.
    z : arb
        May overlap an end of the oval.

    Returns
    -------
    Oval or None
        None if the middle of z is beyond all roots or w² < 0 there.
    """
    ordered = sorted(roots, key=lambda root: root.mid())
    for number, (low, high) in enumerate(pairwise(ordered)):
        middle = (low + high) / 2
        oval = _oval(leading, ordered, number)
        inside = (z - low).mid() >= -low.rad() - z.rad() and (
            high - z
        ).mid() >= -high.rad() - z.rad()
        if inside and oval.square(middle) > 0:
            return oval
    return None


def _oval(leading: arb, roots: list[arb], number: int) -> Oval:
    a, b = roots[number], roots[number + 1]
    infinity = [None] if len(roots) % 2 else []
    above: list[arb | None] = [*roots[number + 2 :], *infinity, *roots[:number]]
    c, d = above
    if c is not None and d is not None:
        inverse = (c - a) * (b - d) / ((c - d) * (b - a))
    elif c is not None:
        inverse = (c - a) / (b - a)
    else:
        assert d is not None
        inverse = (b - d) / (b - a)
    modulus = 1 / inverse
    quarter = acb(modulus).elliptic_k().real
    conjugate = acb(1 - modulus).elliptic_k().real
    # near a both are roots: x = sn²u, so that u = √(f (z−a)), and ∫ dz/w = 2 √((z−a)/S)
    f = 1 / (b - a) if d is None else (b - d) / ((b - a) * (a - d))
    S = leading
    for root in roots:
        S = S if root is a else S * (a - root)
    scale = 4 * quarter / (arb.pi() * abs(S * f).sqrt())
    return Oval(leading, (a, b), (c, d), Thetas(conjugate / quarter), modulus, quarter, scale)
