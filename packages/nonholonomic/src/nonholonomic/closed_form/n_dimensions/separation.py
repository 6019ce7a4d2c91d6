"""Unit vectors in n dimensions whose motion separates in sphero-conical coordinates.

With numbers c_1 < … < c_n the coordinates z_1 < … < z_{n−1} of a unit vector y are the roots of
Σ y_i²/(z − c_i) = 0, so that c_k ≤ z_k ≤ c_{k+1} and

    y_i² = ∏_k (c_i − z_k) / ∏_{j≠i} (c_i − c_j).

For the special operators of inertia (:mod:`nonholonomic.catalogue.so_n_systems.special_inertia`)
they move in a new time τ by

    Σ_k z_k^i dz_k / √Y(z_k) = v_i dτ,      i = 0, …, n − 2,

on a curve of genus n − 1.  With k = p∧γ and W the density of the measure:

* Veselova system and rubber ball, y = γ, c_i = 1/a_i, W = (Aγ, γ) = ∏z/∏c:

      Y = −4 z P(z) ∏(z − c_i),    P = Σ_{i<j} ω_ij k_ij ∏_{l≠i,j} (z − c_l),
      v = (0, …, 0, 1),    dt = W^(1/2) dτ.

* marble ball on k = p∧γ, y = γ, c_i = a_i, W = (A⁻¹γ, γ) = ∏z/∏c:

      Y = −4 z T(z) ∏(z − c_i),    W T = z Σ_{i<j} k_ij² ∏_{l≠i,j} (z − c_l) − p² ∏(z − z_k),
      v = ((−1)^n, 0, …, 0, −∏a/D),    dt = D (∏a ∏z)^(1/2) dτ.

* rubber ball around a sphere of half its radius, y = A^(1/2)γ/W^(1/2), c_i = 1/a_i, W = (Aγ, γ):

      Y = −4 Q(z) ∏(z − c_i),
      Q = Σ_{i<j} (y_i y_j′ − y_j y_i′)² ∏_{l≠i,j} (z − c_l) − 2H ∏(z − z_k),
      v = (0, …, 0, 1),    dt = W^(1/2) dτ,    W = 1/(Σc − Σz).

The polynomials P, T and Q are integrals of the motion.  That y obeys these equations is proven in
``tests/closed_form/n_dimensions`` at exact points; docs/n-dimensions.md has the argument.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

from flint import acb_poly, arb, arb_poly, ctx

from flowlanes.system.tuple_vectors import dot

from ..genus_two.curve import Curve, DegenerateError

Balls = Sequence[arb]

#: Allowed loss of precision in the roots, in bits, and the factor by which the working precision
#: may be exceeded before giving up.
_MARGIN, _MOST = 40, 4


@dataclass(frozen=True)
class SeparatedVector:
    """A unit vector with separated variables, at its start.

    Attributes
    ----------
    poles : tuple of n arb
        c_i, in the order of the axes.
    curve : Curve
        y² = Y(z).
    integral : arb_poly
        The polynomial P, T or Q.
    ovals : tuple of n − 1 int
        The left ends of the intervals of z_1, …, z_{n−1}.
    speed, product_speed : arb
        v_{n−2} and (−1)^n v_0; for n = 2 their contributions to v_0 are added.
    vector, rate : tuple of n arb
        y and dy/dτ at the start.
    """

    poles: tuple[arb, ...]
    curve: Curve
    integral: arb_poly
    ovals: tuple[int, ...]
    speed: arb
    product_speed: arb
    vector: tuple[arb, ...]
    rate: tuple[arb, ...]

    @property
    def speeds(self) -> tuple[arb, ...]:
        """v_0, …, v_{n−2}."""
        genus = len(self.ovals)
        v = [arb(0)] * genus
        v[0] += (-1) ** (genus - 1) * self.product_speed
        v[-1] += self.speed
        return tuple(v)


def polynomial(roots: Balls) -> arb_poly:
    """∏ (z − root)."""
    product = arb_poly([1])
    for root in roots:
        product *= arb_poly([-root, 1])
    return product


def coordinate_polynomial(poles: Balls, vector: Balls) -> arb_poly:
    """∏ (z − z_k) = Σ y_i² ∏_{j≠i} (z − c_j)."""
    total = arb_poly([0])
    for i, y in enumerate(vector):
        total += y * y * polynomial([c for j, c in enumerate(poles) if j != i])
    return total


def pencil(poles: Balls, planes: dict[tuple[int, int], arb]) -> arb_poly:
    """Σ_{i<j} x_ij ∏_{l≠i,j} (z − c_l) of numbers x_ij."""
    total = arb_poly([0])
    for pair, x in planes.items():
        total += x * polynomial([c for j, c in enumerate(poles) if j not in pair])
    return total


def wedge(first: Balls, second: Balls) -> dict[tuple[int, int], arb]:
    """The entries i < j of first ∧ second."""
    return {
        (i, j): first[i] * second[j] - first[j] * second[i]
        for i, j in combinations(range(len(first)), 2)
    }


def unit(vector: Balls) -> list[arb]:
    """The vector divided by its length."""
    length = dot(vector, vector).sqrt()
    return [x / length for x in vector]


def of_veselova(a: Balls, p: Balls, gamma: Balls) -> SeparatedVector:
    """The Veselova system, or the rubber ball, with I_ij = a_i a_j (with m R² added)."""
    W = dot([x * y for x, y in zip(a, gamma, strict=True)], gamma)
    lifted = [x / y for x, y in zip(p, a, strict=True)]
    along = dot(lifted, gamma)
    u = [(x - along * y) / W for x, y in zip(lifted, gamma, strict=True)]
    poles = [1 / x for x in a]
    spin, k = wedge(u, gamma), wedge(p, gamma)
    P = pencil(poles, {pair: spin[pair] * k[pair] for pair in k})
    return _separation(
        poles, P, [arb(0)], gamma, [-x * W.sqrt() for x in u], speed=arb(1), product=arb(0)
    )


def of_ball(a: Balls, D: arb, p: Balls, gamma: Balls) -> SeparatedVector:
    """The marble ball on the level k = p∧γ, I_ij = D a_i a_j/(D − a_i a_j)."""
    W = dot([x / y for x, y in zip(gamma, a, strict=True)], gamma)
    square = dot(p, p)
    k = wedge(p, gamma)
    G = coordinate_polynomial(a, gamma)
    K = pencil(a, {pair: x * x for pair, x in k.items()})
    whole = (arb_poly([0, 1]) * K - square * G).coeffs()
    # The highest powers cancel, since p² = Σ k_ij².
    T = arb_poly([x / W for x in whole[: len(a) - 1]])
    weighted = [x * y for x, y in zip(a, p, strict=True)]
    along = dot(weighted, gamma)
    scale = arb(1)
    for x in a:
        scale *= x
    volume = _value(G, arb(0))
    clock = D * (scale * abs(volume)).sqrt()
    rate = [
        clock * (-W * x + (y - along * z) / D) / (D * W)
        for x, y, z in zip(p, weighted, gamma, strict=True)
    ]
    return _separation(a, T, [arb(0)], gamma, rate, speed=-scale / D, product=arb(1))


def of_surrounding_ball(a: Balls, p: Balls, gamma: Balls) -> SeparatedVector:
    """The rubber ball around a sphere of half its radius, I_ij = a_i a_j − m R²."""
    W = dot([x * y for x, y in zip(a, gamma, strict=True)], gamma)
    lifted = [x / y for x, y in zip(p, a, strict=True)]
    along = dot(lifted, gamma)
    u = [(x - along * y) / W for x, y in zip(lifted, gamma, strict=True)]
    energy = dot(p, u)
    roots = [x.sqrt() for x in a]
    y = [r * x / W.sqrt() for r, x in zip(roots, gamma, strict=True)]
    pull = dot([x * z for x, z in zip(a, gamma, strict=True)], u) / W
    # γ̇ = u, and dy/dτ = W^(1/2) ẏ
    rate = [r * (x - pull * z) for r, x, z in zip(roots, u, gamma, strict=True)]
    poles = [1 / x for x in a]
    turns = wedge(y, rate)
    Q = pencil(poles, {pair: x * x for pair, x in turns.items()}) - energy * coordinate_polynomial(
        poles, y
    )
    return _separation(poles, Q, [], y, rate, speed=arb(1), product=arb(0))


def _separation(
    poles: Balls,
    integral: arb_poly,
    more: Balls,
    vector: Balls,
    rate: Balls,
    *,
    speed: arb,
    product: arb,
) -> SeparatedVector:
    """The separation with the curve Y = −4 · integral · ∏(z − more) ∏(z − c_i)."""
    roots = [*poles, *more, *real_roots(integral)]
    leading = -4 * integral.coeffs()[integral.degree()]
    curve = Curve.of(leading, roots)
    first = 1 if more else 0
    ovals = tuple(range(first, first + 2 * (len(poles) - 1), 2))
    ordered = sorted(poles, key=lambda c: c.mid())
    for k, left in enumerate(ovals):
        low, high = curve.ends(left)
        if not (ordered[k] <= low or ordered[k].overlaps(low)) or not (
            high <= ordered[k + 1] or ordered[k + 1].overlaps(high)
        ):
            raise DegenerateError
    return SeparatedVector(
        tuple(poles), curve, integral, ovals, speed, product, tuple(vector), tuple(rate)
    )


def real_roots(poly: arb_poly) -> list[arb]:
    """The roots of a polynomial with real simple roots.

    Raises
    ------
    DegenerateError
        If they cannot be separated.
    """
    if poly.degree() == 0:
        return []
    try:
        # The start is one exact state close to the given one: use midpoints.
        middles = acb_poly([x.mid() for x in poly.coeffs()])
        found = middles.roots(tol=arb(2) ** (_MARGIN - ctx.prec), maxprec=_MOST * ctx.prec)
        return [root.real.mid() for root in found]
    except ValueError:
        raise DegenerateError from None


def _value(poly: arb_poly, z: arb) -> arb:
    value: arb = poly(z)
    return value
