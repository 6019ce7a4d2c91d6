"""Rational and other short approximations of Hertz's factors from the literature, with errors.

They serve for comparison only: Hertz's factors themselves cost a single arctangent.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any, final

import numpy as np
import numpy.typing as npt
import sympy as sp
from scipy.optimize import minimize_scalar

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray

from .pressure import CoupledFriction, Hertz, checked_ratio
from .pressure_ranges import k

#: F′(0), M(0) and lim kM for k → ∞ of Hertz's factors.
SLOPE, COUPLE, COUPLE_FAR = 3 * sp.pi / 8, 3 * sp.pi / 16, sp.Rational(1, 5)
#: Above this k every formula has reached its limit, while the squares are still finite.
_FAR = 1e150


@final
@dataclass(frozen=True)
class ApproximateFriction(CoupledFriction):
    """Force and couple of friction by a short formula each.

    Attributes
    ----------
    name : str
    force_formula, couple_formula : sympy.Expr
        F and M as formulas in `pressure_ranges.k`.

    Examples
    --------
    >>> from nonholonomic.contact.pressure import zhuravlev_first_order
    >>> zhuravlev_first_order().force_formula
    k/(k + 8/(3*pi))
    >>> zhuravlev_first_order().force([0.0, 1.0, float("inf")])
    array([0.        , 0.54088368, 1.        ])
    """

    name: str
    force_formula: sp.Expr
    couple_formula: sp.Expr

    @cached_property
    def _numbers(self) -> Callable[..., Any]:
        function: Callable[..., Any] = sp.lambdify(
            k, [self.force_formula, self.couple_formula], "numpy"
        )
        return function

    def force(self, k: npt.ArrayLike) -> FloatArray:
        """F(k) of the formula."""
        k = checked_ratio(k)
        return np.asarray(self._numbers(np.minimum(k, _FAR))[0])

    def couple(self, k: npt.ArrayLike) -> FloatArray:
        """M(k) of the formula, in units of μ N a as the exact one."""
        k = checked_ratio(k)
        return np.where(np.isinf(k), 0.0, self._numbers(np.minimum(k, _FAR))[1])


def zhuravlev_first_order() -> ApproximateFriction:
    """Padé forms of first order: F(0), F′(0), F(∞), M(0) and lim kM are Hertz's.

    Returns
    -------
    ApproximateFriction

    Examples
    --------
    >>> import nonholonomic.contact.pressure as pressure
    >>> pressure.zhuravlev_first_order().force([0.0, float("inf")]).tolist()
    [0.0, 1.0]
    """
    return ApproximateFriction(
        "first order", k / (k + 1 / SLOPE), COUPLE / (1 + COUPLE / COUPLE_FAR * k)
    )


@arguments_checked
def zhuravlev_second_order(
    force_constant: float | sp.Expr = 1, couple_constant: float | sp.Expr = 1
) -> ApproximateFriction:
    """Padé forms of second order, with one free constant each.

    Values and slopes at both ends leave free β and b in

        F = (k² + ckβ)/(k² + ckβ + β),            c = F′(0),
        M = M(0) (1 + b₁k)/(1 + b₁k + b k²),      b₁ = b lim kM/M(0);

    both are 1 in the literature.

    Parameters
    ----------
    force_constant, couple_constant : float or sympy.Expr
        β > 0 and b > 0.

    Returns
    -------
    ApproximateFriction

    Raises
    ------
    InputError
        If a constant is not positive.

    Examples
    --------
    >>> import nonholonomic.contact.pressure as pressure
    >>> pressure.zhuravlev_second_order().force([0.0, float("inf")]).tolist()
    [0.0, 1.0]
    """
    beta, b = sp.sympify(force_constant), sp.sympify(couple_constant)
    for name, value in (("force", beta), ("couple", b)):
        if not value.is_positive or value.is_finite is False:
            raise InputError(f"{name} constant {value}: it must be a positive finite number")
    linear, b_1 = SLOPE * beta * k, b * COUPLE_FAR / COUPLE
    numerator = 1 + b_1 * k
    return ApproximateFriction(
        "second order",
        (k**2 + linear) / (k**2 + linear + beta),
        COUPLE * numerator / (numerator + b * k**2),
    )


def ellipsoid_law() -> ApproximateFriction:
    """The pair (F, M/M(0)) on a circle: F = k/√(k² + M(0)²) and M = M(0)²/√(k² + M(0)²).

    Force and couple then come from one ellipsoid, the ball of set-valued force laws.

    Returns
    -------
    ApproximateFriction

    Examples
    --------
    >>> import nonholonomic.contact.pressure as pressure
    >>> pressure.ellipsoid_law().force([0.0, float("inf")]).tolist()
    [0.0, 1.0]
    """
    root = sp.sqrt(k**2 + COUPLE**2)
    return ApproximateFriction("ellipsoid", k / root, COUPLE**2 / root)


@arguments_checked
def greatest_errors(approximation: CoupledFriction) -> tuple[float, float]:
    """Greatest error of F, and of M in units of M(0), against Hertz's over all k ≥ 0.

    Parameters
    ----------
    approximation : CoupledFriction

    Returns
    -------
    (float, float)

    Raises
    ------
    InputError
        If the argument is of another type.

    Examples
    --------
    >>> from nonholonomic.contact.pressure import greatest_errors, zhuravlev_first_order
    >>> [f"{error:.4f}" for error in greatest_errors(zhuravlev_first_order())]
    ['0.3437', '0.3916']
    """
    exact = Hertz()
    pairs = ((approximation.force, exact.force), (approximation.couple, exact.couple))
    force, couple = (_greatest_difference(f, g) for f, g in pairs)
    return force, couple / float(COUPLE)


def _greatest_difference(
    f: Callable[[FloatArray], FloatArray], g: Callable[[FloatArray], FloatArray]
) -> float:
    """The largest |f − g| on 0 ≤ k ≤ ∞, where both are smooth in ln k."""

    def difference(logarithm: npt.ArrayLike) -> FloatArray:
        at = np.exp(np.asarray(logarithm))
        return np.abs(f(at) - g(at))

    grid = np.linspace(-12, 12, 961)
    values = difference(grid)
    greatest = max(float(values.max()), float(difference([-np.inf, np.inf]).max()))
    # Several peaks may be equally high.
    higher = (values[1:-1] >= values[:-2]) & (values[1:-1] >= values[2:])
    for i in np.flatnonzero(higher & (values[1:-1] > 0.99 * greatest)):
        peak = minimize_scalar(
            lambda x: -float(difference(x)),
            bounds=(grid[i], grid[i + 2]),
            method="bounded",
            options={"xatol": 1e-9},
        )
        greatest = max(greatest, -float(peak.fun))
    return greatest


@cache
def best_constants() -> tuple[float, float]:
    """β and b of `zhuravlev_second_order` that minimise the greatest errors.

    Returns
    -------
    (float, float)

    Examples
    --------
    >>> from nonholonomic.contact.pressure import best_constants
    >>> [round(constant, 4) for constant in best_constants()]
    [0.2812, 2.2939]
    """

    def error(part: int, constant: float) -> float:
        return greatest_errors(zhuravlev_second_order(constant, constant))[part]

    force, couple = (
        minimize_scalar(
            lambda x, part=part: error(part, float(x)),
            bounds=(0.1, 5.0),
            method="bounded",
            options={"xatol": 1e-8},
        ).x
        for part in (0, 1)
    )
    return float(force), float(couple)
