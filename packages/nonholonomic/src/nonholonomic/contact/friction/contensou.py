"""Friction over a round patch with Hertz' pressure, as formulas for integration.

Each element of the patch slides with u + Ωγ×ρ.  With k = |u|/(a|Ω|) the force is μN F(k) and the
couple μNa M(k), formulas in three ranges of k.  At k = 1 those of two ranges differ by
O((k − 1)^{5/2}), so that a series in time must not cross it.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import sympy as sp

from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Guard
from flowlanes.system.vectors import norm_squared, real_symbol

from ..pressure.pressure_limits import COUPLE_AT_ONE, hertz_limit, z
from ..pressure.pressure_ranges import OUTER_BOUND, hertz_ranges
from .modes import Mode, Range
from .symbols import N, friction, holding_couple, slip, slip_floor, slip_speed, spin, spin_sign

#: Shares of force and couple: the reaction is −μN (force_share u) and −μNa (couple_share γ).
force_share, couple_share = real_symbol("force_share"), real_symbol("couple_share")

#: The inner formula is used up to k = 1 + 2·WIDENING, the middle one from 1 + WIDENING on.  So the
#: branch point k = 1 is never reached, where the inner formula is accurate to WIDENING^{5/2}.
WIDENING = sp.Rational(1, 10**6)
_BETWEEN = 1.5 * float(WIDENING)

#: Degree of the polynomial for the limit set.
_DEGREE = 30


def definitions(patch: sp.Symbol, mode: Mode) -> Pairs:
    """The shares of force and couple of a moving contact, in the k range of the mode."""
    force, couple = shares(mode.range, slip_speed, norm_squared(slip), patch * spin)
    return ((force_share, force), (couple_share, couple))


def shares(
    span: Range, speed: sp.Expr, square: sp.Expr, turning: sp.Expr
) -> tuple[sp.Expr, sp.Expr]:
    """F/|u| and M sgn Ω in a range of k.

    Parameters
    ----------
    span : str
        ``"inner"``, ``"middle"`` or ``"outer"``.
    speed, square : sympy.Expr
        |u| and |u|², which is smooth where u passes through zero.
    turning : sympy.Expr
        aΩ, of the sign `spin_sign`.

    Examples
    --------
    >>> import sympy as sp
    >>> from nonholonomic.contact.friction.contensou import shares
    >>> u, w = sp.symbols("u w", positive=True)
    >>> shares("inner", u, u**2, w)[0]
    pi*(-3*u**2/(32*w**2) + 3/8)/(spin_sign*w)
    """
    inner, middle, outer = hertz_ranges()
    arm = spin_sign * turning
    if span == "inner":
        given = {inner.argument: square / turning**2}
        return inner.force.xreplace(given) / arm, spin_sign * inner.couple.xreplace(given)
    if span == "middle":
        given = {middle.argument: speed / arm}
        return middle.force.xreplace(given) / speed, spin_sign * middle.couple.xreplace(given)
    given = {outer.argument: turning**2 / square}
    return outer.force.xreplace(given) / speed, outer.couple.xreplace(given) * turning / speed


def range_of(slip_speed: float, spin: float, patch: float) -> Range:
    """The k range of a contact that slides and spins."""
    arm = patch * abs(spin)
    if slip_speed >= float(OUTER_BOUND) * arm:
        return "outer"
    return "inner" if slip_speed <= (1 + _BETWEEN) * arm else "middle"


def held_range_of(couple: float, unit: float) -> Range:
    """The part of the limit set for a given couple over a, and the unit μN."""
    return "above" if abs(couple) > float(COUPLE_AT_ONE) * unit * (1 - _BETWEEN) else "below"


def guards(patch: sp.Symbol, mode: Mode, mu: sp.Symbol) -> tuple[Guard, ...]:
    """Quantities that are positive while the mode and its range last."""
    if mode.sliding:
        return _sliding_guards(patch, mode.range)
    unit, couple = mu * N, holding_couple / patch
    above = couple**2 - (COUPLE_AT_ONE * (1 - 2 * WIDENING) * unit) ** 2
    below = (COUPLE_AT_ONE * (1 - WIDENING) * unit) ** 2 - couple**2
    is_above = mode.range == "above"
    squared = _squared_limit_above(couple, unit) if is_above else _squared_limit_below(couple, unit)
    return (
        Guard("slip", squared * unit**2 - norm_squared(friction), "sliding and spinning begin"),
        Guard("range", above if is_above else below, ""),
    )


def _sliding_guards(patch: sp.Symbol, span: Range) -> tuple[Guard, ...]:
    square, arm = norm_squared(slip), (patch * spin) ** 2
    stop = Guard("stop", sp.sqrt(square + arm) - slip_floor, "sliding and spinning end")
    if span == "inner":
        return stop, Guard("range", (1 + 2 * WIDENING) ** 2 * arm - square, "")
    if span == "middle":
        return (
            stop,
            Guard("range", square - (1 + WIDENING) ** 2 * arm, ""),
            Guard("range", OUTER_BOUND**2 * (1 + WIDENING) * arm - square, ""),
        )
    return stop, Guard("range", square - OUTER_BOUND**2 * arm, "")


def _squared_limit_above(couple: sp.Expr, unit: sp.Expr) -> sp.Expr:
    """Squared limit of the force over μN for a couple above its value at k = 1."""
    return hertz_limit().greatest_force_squared.xreplace({z: spin_sign * couple / unit})


def _squared_limit_below(couple: sp.Expr, unit: sp.Expr) -> sp.Expr:
    """Squared limit of the force over μN for a couple below its value at k = 1."""
    edge = sp.Float(float(COUPLE_AT_ONE))
    t: sp.Expr = 2 * sp.sqrt((edge * unit) ** 2 - couple**2) / (edge * unit) - 1
    value: sp.Expr = sp.S.Zero
    for coefficient in reversed(limit_polynomial()):
        value = sp.Float(coefficient, 17) + t * value
    return value**2


@cache
def limit_polynomial() -> tuple[float, ...]:
    """The force of the limit set below M(1) as a polynomial in t, by rising powers.

    t = 2q − 1 with q = √(1 − z²/M(1)²) for the couple z, which may change its sign.  In α, with
    1/k = sin α, F and M are analytic, F even and M odd, and 1 − M/M(1) begins with (π/2 − α)²: so
    F is analytic in q on [0, 1].
    """
    from scipy.optimize import elementwise

    from ..pressure.pressure import Hertz

    hertz = Hertz()
    nodes = np.cos(np.pi * (np.arange(2 * _DEGREE) + 0.5) / (2 * _DEGREE))
    couples = float(COUPLE_AT_ONE) * np.sqrt(1 - ((1 + nodes) / 2) ** 2)
    tiny = np.full(nodes.shape, 1e-6)
    root = elementwise.find_root(
        lambda sine, couple: hertz.couple(1 / sine) - couple,
        (tiny, np.ones_like(tiny)),
        args=(couples,),
    )
    forces = hertz.force(1 / root.x)
    series = np.polynomial.chebyshev.Chebyshev.fit(nodes, forces, _DEGREE, domain=[-1, 1])
    return tuple(map(float, np.polynomial.chebyshev.cheb2poly(series.coef)))
