r"""The limit set of the force and couple that friction can exert on a round patch.

A patch at rest holds a force f along the contact and a couple τ about the normal as long as

    x = |f|/(μ N),        z = |τ|/(μ N a)

lie below the curve (F(k), M(k)), 0 ≤ k ≤ ∞.  The set is convex, since dM = −k dF, and every ray
from 0 meets the curve once: that k is the ratio |u|/(a|Ω|) with which the patch begins to move.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import mpmath as mp
import numpy as np
import numpy.typing as npt
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray
from flowlanes.system.vectors import real_symbol

from .pressure import CoupledFriction

#: Force and couple at k = 1 under Hertz's pressure, where the two parts of the limit curve meet.
FORCE_AT_ONE, COUPLE_AT_ONE = 9 * sp.pi / 32, 9 * sp.pi / 128
#: Degree of the polynomial for the outer part of the curve.
DEGREE = 26
#: Value of |ln k| beyond which F/M is proportional to k.
_STRAIGHT = 200.0

x, z = real_symbol("x"), real_symbol("z")


def slip_ratio(friction: CoupledFriction, x: npt.ArrayLike, z: npt.ArrayLike) -> FloatArray:
    """The k whose (F(k), M(k)) is proportional to given force and couple.

    Parameters
    ----------
    friction : CoupledFriction
    x, z : arrays that broadcast
        |f|/(μN) ≥ 0 and |τ|/(μNa) ≥ 0, not both 0.

    Returns
    -------
    array
        k, 0 where x = 0 and infinite where z = 0.

    Raises
    ------
    InputError
        If a number is negative or not finite, or both are 0.

    Examples
    --------
    >>> from nonholonomic.contact.pressure.pressure import Hertz
    >>> from nonholonomic.contact.pressure.pressure_limits import slip_ratio
    >>> hertz = Hertz()
    >>> float(slip_ratio(hertz, 0.5 * hertz.force(2.0), 0.5 * hertz.couple(2.0)).round(14))
    2.0
    """
    # Imported on demand: every study imports this module, few need a root.
    from scipy.optimize import elementwise

    force, couple = _checked_load(x, z)
    if np.any((force == 0) & (couple == 0)):
        raise InputError("x = z = 0: without force and couple no ratio of sliding to spinning")
    inside = (force > 0) & (couple > 0)
    ratio = np.where(couple == 0, np.inf, 0.0)
    if not inside.any():
        return ratio
    wanted = np.log(force[inside]) - np.log(couple[inside])
    # ln(F/M) increases with ln k; beyond ±_STRAIGHT its slope is 1.
    clipped = np.clip(wanted, -_STRAIGHT, _STRAIGHT)

    def excess(log_k: FloatArray, target: FloatArray) -> FloatArray:
        return _log_ratio(friction, log_k) - target

    bracket = elementwise.bracket_root(excess, clipped - 1, clipped + 1, args=(clipped,))
    root = elementwise.find_root(excess, bracket.bracket, args=(clipped,))
    if not root.success.all():
        raise ArithmeticError(f"no ratio of sliding to spinning was found for {friction}")
    with np.errstate(over="ignore"):
        ratio[inside] = np.exp(root.x + (wanted - clipped))
    return ratio


def _log_ratio(friction: CoupledFriction, log_k: FloatArray) -> FloatArray:
    k = np.exp(log_k)
    ratio: FloatArray = np.log(friction.force(k)) - np.log(friction.couple(k))
    return ratio


def load_factor(friction: CoupledFriction, x: npt.ArrayLike, z: npt.ArrayLike) -> FloatArray:
    """The load relative to its limit: below 1 inside the limit set, 1 on its boundary.

    It is λ with (x, z) = λ (F(k), M(k)), so proportional to the load.

    Parameters
    ----------
    friction, x, z
        As of `slip_ratio`; x = z = 0 is allowed.

    Raises
    ------
    InputError
        If a number is negative or not finite.

    Examples
    --------
    >>> from nonholonomic.contact.pressure.pressure import Uniform
    >>> from nonholonomic.contact.pressure.pressure_limits import load_factor
    >>> load_factor(Uniform(), [0.0, 0.5, 0.9], [0.5, 0.3, 0.3]).round(6)
    array([0.75    , 0.720011, 1.060288])
    """
    force, couple = _checked_load(x, z)
    empty = (force == 0) & (couple == 0)
    k = slip_ratio(friction, np.where(empty, 1.0, force), couple)
    F, M = friction.force(k), friction.couple(k)
    # Divide by the larger of the two, which is accurate where F or M is flat.
    return np.where(F >= M, force / np.where(F >= M, F, 1), couple / np.where(F >= M, 1, M))


def _checked_load(x: npt.ArrayLike, z: npt.ArrayLike) -> tuple[FloatArray, FloatArray]:
    force, couple = np.broadcast_arrays(np.asarray(x, dtype=float), np.asarray(z, dtype=float))
    for name, values in (("x = |f|/(μN)", force), ("z = |τ|/(μNa)", couple)):
        if not (np.all(np.isfinite(values)) and np.all(values >= 0)):
            raise InputError(f"{name}: it must be finite and at least 0")
    return force, couple


@dataclass(frozen=True)
class HertzLimit:
    """The limit curve under Hertz's pressure as formulas in `x` and `z`.

    Attributes
    ----------
    greatest_couple : sympy.Expr
        z on the curve as a function of x, for 0 ≤ x ≤ 9π/32.
    greatest_force_squared : sympy.Expr
        x² on the curve as a function of z, for 9π/128 ≤ z ≤ 3π/16; free of arcsin, and smooth
        where the force passes through zero.
    greatest_force : sympy.Expr
        x on the curve as a function of z, for 0 ≤ z ≤ 9π/128.

    Notes
    -----
    Beyond their range the first two differ from the curve by O(δ^(5/2)) at a distance δ only, so
    that an integrator may change from them to the last one a little late; the last one is not
    real beyond its own.
    """

    greatest_couple: sp.Expr
    greatest_force_squared: sp.Expr
    greatest_force: sp.Expr

    @property
    def couple_margin(self) -> sp.Expr:
        """z on the curve minus z: positive inside; for x ≤ 9π/32."""
        return self.greatest_couple - z

    @property
    def inner_force_margin(self) -> sp.Expr:
        """x² on the curve minus x²: positive inside; for z ≥ 9π/128."""
        return self.greatest_force_squared - x**2

    @property
    def outer_force_margin(self) -> sp.Expr:
        """x on the curve minus x: positive inside; for z ≤ 9π/128."""
        return self.greatest_force - x


@cache
def hertz_limit() -> HertzLimit:
    """The limit curve under Hertz's pressure.

    Inner part, k ≤ 1: F(k) = x is a cubic equation with the root
    k = (4/√3) sin(⅓ arcsin(2√3 x/π)), and M(k) = z a quadratic one in k²: with r = √(8z/π − ½),
    k² = (4/3)(1 − r) and x² = (π²/48)(1 − r)(2 + r)².

    Outer part, k ≥ 1: F and M are analytic in s = √(k² − 1), and in 1/k² and 1/k at infinity.  As
    dM = −k dF ≠ 0, M(1) − M begins with s², so that s, and with it F, is an analytic function of
    q = √(M(1) − z) on the whole range, ends included.  Its Chebyshev series falls like 3.1⁻ⁿ,
    faster than the powers 2.4ⁿ with which passing to powers multiplies errors: a polynomial in
    t = 2q/√M(1) − 1, as nested products, is good to rounding.

    Examples
    --------
    >>> from nonholonomic.contact.pressure.pressure_limits import hertz_limit
    >>> hertz_limit().greatest_force_squared
    pi**2*(1 - sqrt(8*z/pi - 1/2))*(sqrt(8*z/pi - 1/2) + 2)**2/48
    """
    angle = sp.asin(2 * sp.sqrt(3) * x / sp.pi) / 3
    square = sp.Rational(16, 3) * sp.sin(angle) ** 2
    r = sp.sqrt(8 * z / sp.pi - sp.Rational(1, 2))
    t = 2 * sp.sqrt(1 - z / COUPLE_AT_ONE) - 1
    outer: sp.Expr = sp.Integer(0)
    for coefficient in reversed(_outer_coefficients()):
        outer = outer * t + sp.Float(coefficient)
    return HertzLimit(
        3 * sp.pi / 16 * (1 - square * (1 - 3 * square / 8)),
        sp.pi**2 / 48 * (1 - r) * (2 + r) ** 2,
        outer,
    )


def _outer_coefficients() -> list[float]:
    """Coefficients of the interpolant of F at Chebyshev points in t = 2√(1 − M/M(1)) − 1."""
    points = DEGREE + 1
    with mp.workdps(40):
        angles = [mp.pi * (2 * i + 1) / (2 * points) for i in range(points)]
        forces = [_outer_force((1 + mp.cos(angle)) / 2) for angle in angles]
        chebyshev = [
            2
            * mp.fsum(f * mp.cos(n * angle) for f, angle in zip(forces, angles, strict=True))
            / points
            for n in range(points)
        ]
        chebyshev[0] /= 2
        # Convert to powers of t by the recurrence T_{n+1} = 2t T_n − T_{n−1}.
        previous, current = [0] * points, [1] + [0] * DEGREE
        powers = [mp.mpf(0)] * points
        for n, coefficient in enumerate(chebyshev):
            powers = [p + coefficient * c for p, c in zip(powers, current, strict=True)]
            factor = 1 if n == 0 else 2
            shifted = [0, *(factor * c for c in current[:-1])]
            following = [a - b for a, b in zip(shifted, previous, strict=True)]
            previous, current = current, following
        return [float(p) for p in powers]


def _outer_force(q: mp.mpf) -> mp.mpf:
    """F where M = M(1)(1 − q²), 0 < q < 1, by solving for α = arcsin(1/k)."""
    wanted = 9 * mp.pi / 128 * (1 - q**2)

    def couple(alpha: mp.mpf) -> mp.mpf:
        angle = 4 * alpha
        numerator = (2 + mp.cos(angle)) * angle - 3 * mp.sin(angle)
        return 3 * numerator / (256 * mp.sin(alpha) ** 4)

    alpha = mp.findroot(lambda a: couple(a) - wanted, (wanted, mp.pi / 2), solver="anderson")
    sine, cosine = mp.sin(alpha), mp.cos(alpha)
    sliding = (4 * sine**2 - 1) * alpha + (1 + 2 * sine**2) * sine * cosine
    return 3 * sliding / (16 * sine**3)
