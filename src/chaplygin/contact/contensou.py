"""Friction over a round patch with Hertz' pressure, as formulas for integration.

Each element of the patch slides with u + Ωγ×ρ.  With k = |u|/(a|Ω|) the force is μN𝓕(k) and the
couple μNa𝓜(k); both are elementary,

    k ≤ 1:  𝓕 = (3π/8) k (1 − k²/4),     𝓜 = (3π/16)(1 − k² + 3k⁴/8),
    k ≥ 1:  𝓕 = (3/16)[(4k − k³)α + (k + 2/k)s],
            𝓜 = (3/64)[(8 − 8k² + 3k⁴)α + 3(2 − k²)s],     α = arcsin 1/k,  s = √(k² − 1),

and for large k, where these cancel, 𝓕 = ₂F₁(−½, ½; 5/2; 1/k²) and k𝓜 = ₂F₁(½, ½; 7/2; 1/k²)/5.
At k = 1 the two forms differ by O((k − 1)^{5/2}), so that a series in time must not cross it.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import sympy as sp

from ..core.named_formulas import Pairs
from ..core.system import Guard
from ..core.vectors import norm_squared, real_symbol
from .modes import Mode, Range
from .symbols import N, friction, holding_couple, slip, slip_floor, slip_speed, spin, spin_sign

#: Shares of force and couple: the reaction is −μN (force_share u) and −μNa (couple_share γ).
force_share, couple_share = real_symbol("force_share"), real_symbol("couple_share")

#: The couple of pure spinning and that at k = 1, for each unit of μNa.
PURE_SPIN = 3 * sp.pi / 16
AT_ONE = sp.Rational(3, 8) * PURE_SPIN

#: k from which the hypergeometric series are used, and their number of terms: 9^−18 < 1e-17.
FAR, _TERMS = 3, 18

#: The inner form is used up to k = 1 + 2·WIDENING, the middle one from 1 + WIDENING on: its
#: branch point at k = 1 stays out of reach, and the inner form is good to WIDENING^{5/2} there.
WIDENING = sp.Rational(1, 10**6)

_DEGREE = 30


def hypergeometric_series(a: sp.Expr, b: sp.Expr, c: sp.Expr, x: sp.Expr) -> sp.Expr:
    """The first terms of ₂F₁(a, b; c; x) in Horner's form, with rational coefficients."""
    total: sp.Expr = sp.S.Zero
    for n in reversed(range(_TERMS)):
        coefficient = sp.rf(a, n) * sp.rf(b, n) / (sp.rf(c, n) * sp.factorial(n))
        total = coefficient + x * total
    return total


def middle_formulas(k: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """𝓕 and 𝓜 for k ≥ 1."""
    alpha, s = sp.asin(1 / k), sp.sqrt(k**2 - 1)
    force = sp.Rational(3, 16) * ((4 * k - k**3) * alpha + (k + 2 / k) * s)
    couple = sp.Rational(3, 64) * ((8 - 8 * k**2 + 3 * k**4) * alpha + 3 * (2 - k**2) * s)
    return force, couple


def shares(patch: sp.Symbol, mode: Mode) -> Pairs:
    """The shares of force and couple while the contact moves, in the range of the mode."""
    half = sp.Rational(1, 2)
    arm = patch * spin_sign * spin
    match mode.range:
        case "inner":
            square = norm_squared(slip) / arm**2
            force = 3 * sp.pi / 8 * (1 - square / 4) / arm
            couple = spin_sign * PURE_SPIN * (1 - square + sp.Rational(3, 8) * square**2)
        case "middle":
            factor, couple = middle_formulas(slip_speed / arm)
            force, couple = factor / slip_speed, spin_sign * couple
        case _:
            inverse = patch * spin / slip_speed
            five, seven = sp.Rational(5, 2), sp.Rational(7, 2)
            force = hypergeometric_series(-half, half, five, inverse**2) / slip_speed
            couple = inverse / 5 * hypergeometric_series(half, half, seven, inverse**2)
    return ((force_share, force), (couple_share, couple))


def range_of(slip_speed: float, spin: float, patch: float) -> Range:
    """The range in which a sliding and spinning contact lies."""
    arm = patch * abs(spin)
    if slip_speed >= FAR * arm:
        return "outer"
    return "inner" if slip_speed <= (1 + 1.5e-6) * arm else "middle"


def held_range_of(couple: float, unit: float) -> Range:
    """The part of the limit set for a couple and its unit μNa."""
    return "above" if abs(couple) > float(AT_ONE) * unit * (1 - 1.5e-6) else "below"


def guards(patch: sp.Symbol, mode: Mode, mu: sp.Symbol) -> tuple[Guard, ...]:
    """What stays positive as long as the mode and its range last."""
    square, arm = norm_squared(slip), (patch * spin) ** 2
    if mode.sliding:
        stop = Guard("stop", square + arm - slip_floor**2, "sliding and spinning end")
        inner = Guard("range", (1 + 2 * WIDENING) ** 2 * arm - square, "")
        middle = Guard("range", square - (1 + WIDENING) ** 2 * arm, "")
        far = Guard("range", FAR**2 * (1 + WIDENING) * arm - square, "")
        outer = Guard("range", square - FAR**2 * arm, "")
        return stop, *{"inner": (inner,), "middle": (middle, far), "outer": (outer,)}[mode.range]
    message = "sliding and spinning begin"
    unit = mu * N
    couple = holding_couple / patch
    above = couple**2 - (AT_ONE * (1 - 2 * WIDENING) * unit) ** 2
    if mode.range == "above":
        # 𝓜(k) = z is a quadratic equation for k²
        ratio = spin_sign * couple / (PURE_SPIN * unit)
        square = sp.Rational(4, 3) * (1 - sp.sqrt((3 * ratio - 1) / 2))
        largest = (3 * sp.pi / 8) ** 2 * square * (1 - square / 4) ** 2
        margin = largest * unit**2 - norm_squared(friction)
        return Guard("slip", margin, message), Guard("range", above, "")
    edge = sp.Float(float(AT_ONE))
    q = sp.sqrt(AT_ONE**2 * unit**2 - couple**2) / (edge * unit)
    t: sp.Expr = 2 * q - 1
    largest = sp.S.Zero
    for coefficient in reversed(limit_polynomial()):
        largest = sp.Float(coefficient, 17) + t * largest
    margin = largest**2 * unit**2 - norm_squared(friction)
    below = (AT_ONE * (1 - WIDENING) * unit) ** 2 - couple**2
    return Guard("slip", margin, message), Guard("range", below, "")


@lru_cache(maxsize=1)
def limit_polynomial() -> tuple[float, ...]:
    """The force of the limit set below 𝓜(1) as a polynomial in t, by rising powers.

    t = 2q − 1 with q = √(1 − z²/𝓜(1)²) for the couple z.  In 1/k = sin α both 𝓕 and 𝓜 are
    analytic in π/2 − α, and so is q, which makes 𝓕 analytic in q on [0, 1].
    """
    nodes = np.cos(np.pi * (np.arange(2 * _DEGREE) + 0.5) / (2 * _DEGREE))
    values = [_force_at((1 + t) / 2) for t in nodes]
    series = np.polynomial.chebyshev.Chebyshev.fit(nodes, values, _DEGREE, domain=[-1, 1])
    return tuple(map(float, np.polynomial.chebyshev.cheb2poly(series.coef)))


def _force_at(q: float) -> float:
    """𝓕 at the k ≥ 1 with 𝓜(k) = 𝓜(1) √(1 − q²)."""
    import mpmath

    with mpmath.workdps(40):
        target = mpmath.mpf(3) / 8 * mpmath.sqrt(1 - mpmath.mpf(q) ** 2)

        def angle_defect(alpha: mpmath.mpf) -> mpmath.mpf:
            return _couple(alpha) / (3 * mpmath.pi / 16) - target

        alpha = mpmath.findroot(
            angle_defect, (mpmath.mpf(10) ** -12, mpmath.pi / 2), solver="anderson", tol=1e-60
        )
        k = 1 / mpmath.sin(alpha)
        s = mpmath.cot(alpha)
        return float(mpmath.mpf(3) / 16 * ((4 * k - k**3) * alpha + (k + 2 / k) * s))


def _couple(alpha: object) -> object:
    import mpmath

    k, s = 1 / mpmath.sin(alpha), mpmath.cot(alpha)
    return mpmath.mpf(3) / 64 * ((8 - 8 * k**2 + 3 * k**4) * alpha + 3 * (2 - k**2) * s)
