"""(9.17) with k = −½ has no second meromorphic integral (§9.4).

V = −h (γ, Jγ)² is a polynomial on the sphere.  A point on the great circle γ₃ = 0 with H̃ = 0 has
φ′² = 2h a², a = J₁cos²φ + J₂sin²φ.  With y = δγ₃ and φ as the time its variation across the circle
is

    (a y_φ)_φ + (3a − 2J₃) y = 0.

In t = tan φ this is a Fuchsian equation over the rational functions. Its singular points are t =
±i, with the exponents −½ and 3/2, and the two roots of J₁ + J₂t² = 0, where a vanishes, with the
exponents 0 and 0 and hence a logarithm: a monodromy that is unipotent and not the identity. t = ∞
is regular, and the Wronskian is rational.

If the differential Galois group, a subgroup of SL(2), were reducible, there would be a solution y
= (t − i)^p (t + i)^q P(t) with a polynomial P, p and q in {−½, 3/2}, and degree p + q + deg P at t
= ∞ in {0, −1}; hence p = q = −½ and deg P ≤ 1, that is, y = b sin φ + c cos φ. But

    (a y_φ)_φ + (3a − 2J₃) y = 2(J₂ − J₃) b sin φ + 2(J₁ − J₃) c cos φ,

which vanishes for no such y if J₃ differs from J₁ and J₂. An irreducible subgroup of SL(2) with
such a unipotent element is SL(2), whose identity component is not commutative. By the theorem of
Morales and Ramis there is no second integral that is meromorphic near this motion; in particular
none that is rational in M and γ. The level H̃ = 0 is the one to which (9.14) corresponds; (9.14)
is homogeneous in M, so that the same holds for (9.2).
"""

from __future__ import annotations

import sympy as sp

from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue.ball_on_sphere import power_potential_on_sphere as point
from nonholonomic.catalogue.ball_on_sphere.rubber_ball_on_e3 import J, M, gamma, k

from ..methods.derived_verdicts import computed_verdict

#: The exponent k.
EXPONENT = sp.Rational(-1, 2)
phi, t, y, slope, b, c = sp.symbols("phi t y y_phi b c", real=True)
J_1, J_2, J_3 = J.symbols
WEIGHT = J_1 * sp.cos(phi) ** 2 + J_2 * sp.sin(phi) ** 2


def _operator(value: sp.Expr, first: sp.Expr, second: sp.Expr) -> sp.Expr:
    """(a y_φ)_φ + (3a − 2J₃) y for given y, y_φ and y_φφ."""
    return WEIGHT * second + sp.diff(WEIGHT, phi) * first + (3 * WEIGHT - 2 * J_3) * value


def normal_equation() -> tuple[sp.Expr, sp.Expr]:
    """Two formulas that vanish by (9.16) and determine y_φ and y_φφ.

    γ = (cos φ, sin φ, 0), M = (0, 0, −φ′), and a variation δγ₃ = y, δM₁, δM₂ with
    δγ₃′ = γ₁δM₂ − γ₂δM₁ that keeps (M, γ) = 0.
    """
    system = point.moving()
    state = sp.Matrix([*M, *gamma])
    rates = sp.Matrix([system.expand(system.rates[system.symbols.index(s)]) for s in state])
    rates = rates.xreplace({k: EXPONENT}).doit()
    speed = sp.sqrt(2 * point.h) * WEIGHT
    cosine, sine = sp.cos(phi), sp.sin(phi)
    place = dict(zip(state, (0, 0, -speed, cosine, sine, 0), strict=True))
    grown = speed * slope
    across = (-sine * grown + cosine * speed * y, cosine * grown + sine * speed * y)
    change = rates.jacobian(state).xreplace(place) * sp.Matrix([*across, 0, 0, 0, y])
    # The variation of γ₃′ is the assumed growth, whose rate along the motion gives y_φφ.
    turned = cosine * change[1] - sine * change[0] - speed * (sine * across[1] + cosine * across[0])
    second = (turned - speed * sp.diff(speed, phi) * slope) / speed**2
    return sp.simplify(change[5] - grown), sp.simplify(_operator(y, slope, second))


def exponents() -> dict[str, list[sp.Expr]]:
    """The exponents at t = i and at a root of J₁ + J₂t², from (1 + t²)² (P y_t)_t + Q y = 0.

    P = J₁ + J₂t² = J₂(t² − z²), Q = 3P − 2J₃(1 + t²). They are the same at −i and at the other
    root.
    """
    zero, e = sp.symbols("z e")
    weight = J_2 * (t**2 - zero**2)
    coefficient = 3 * weight - 2 * J_3 * (1 + t**2)
    pairs = {}
    for name, place in (("i", sp.I), ("root", zero)):
        first = sp.cancel((t - place) * sp.diff(weight, t) / weight)
        last = sp.cancel(
            (t - place) ** 2 * coefficient / (sp.expand((t - sp.I) * (t + sp.I)) ** 2 * weight),
            extension=sp.I,
        )
        indicial = e * (e - 1) + first.subs(t, place) * e + last.subs(t, place)
        roots = sp.roots(sp.Poly(sp.simplify(indicial), e))
        pairs[name] = sorted(x for x, count in roots.items() for _ in range(count))
    return pairs


def remainder() -> sp.Expr:
    """The value of `_operator` for y = b sin φ + c cos φ."""
    value = b * sp.sin(phi) + c * sp.cos(phi)
    return sp.simplify(_operator(value, sp.diff(value, phi), sp.diff(value, phi, 2)))


def no_second_integral() -> Verdict:
    """The verdict on the computations described above."""
    left = 2 * (J_2 - J_3) * b * sp.sin(phi) + 2 * (J_1 - J_3) * c * sp.cos(phi)
    half = sp.Rational(1, 2)
    shown = (
        normal_equation() == (0, 0)
        and exponents() == {"i": [-half, 3 * half], "root": [0, 0]}
        and sp.simplify(remainder() - left) == 0
    )
    return computed_verdict(
        "no second integral",
        shown,
        "for k = −½ the group of the variations across the circle γ₃ = 0 is SL(2)",
        "the variational equation does not have the expected form",
    )
