"""Numerical quadratures of a reduction: ln N along a line, and the integral of S̄."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.parameters import require_parameters

from .rational_evaluation import circle

if TYPE_CHECKING:
    from .reduced_form import ChaplyginForm

Coordinates = Sequence[float]
NODES = (16, 24, 36, 54, 81, 122)
"""Numbers of Gauss–Legendre nodes in cos θ; φ has twice as many equidistant nodes."""
SMALL = 1e-13


@arguments_checked
def log_multiplier(
    form: ChaplyginForm,
    start: Coordinates,
    end: Coordinates,
    values: Mapping[sp.Symbol, float] | None = None,
) -> tuple[float, float]:
    """The integral ∫ (A₂ dq₁ − A₁ dq₂) along the straight line between two points.

    If the 1-form is closed this is ln N(end) − ln N(start), with or without a closed form.

    Parameters
    ----------
    form : ChaplyginForm
    start, end : pair of float
        q₁, q₂.
    values : mapping of Symbol to float, optional
        Parameters and constants, instead of their defaults.

    Returns
    -------
    value, error : float
        The error is an estimate from two orders of quadrature.

    Raises
    ------
    InputError
        If a value is not that of a parameter or is not finite.

    Examples
    --------
    >>> import nonholonomic
    >>> import sympy as sp
    >>> x, y, z, xdot, ydot, zdot = sp.symbols("x y z xdot ydot zdot", real=True)
    >>> lagrangian, constraint = (xdot**2 + ydot**2 + zdot**2) / 2, zdot - y * xdot
    >>> particle = nonholonomic.Mechanism(
    ...     "particle", nonholonomic.coordinates(x, y, z), lagrangian, (constraint,)
    ... )
    >>> form = nonholonomic.chaplygin_form(particle)
    >>> value, error = nonholonomic.mechanics.reduction.log_multiplier(form, (0.0, 0.0), (0.0, 1.0))
    >>> round(value, 6)
    -0.346574
    """
    from scipy.integrate import quad

    known = _parameter_values(form, values)
    q = form.base.coordinates
    step = [b - a for a, b in zip(start, end, strict=True)]

    def slope(s: float) -> float:
        here = [a + s * d for a, d in zip(start, step, strict=True)]
        place = dict(known)
        for x, value in zip(q, here, strict=True):
            sine, cosine = circle(x)
            place |= {x: value, sine: float(np.sin(value)), cosine: float(np.cos(value))}
        first, second = form.local.at(place, 1.0).form(1.0)
        return float(first * step[0] + second * step[1])

    value, error = quad(slope, 0.0, 1.0, epsabs=SMALL, epsrel=SMALL)
    return float(value), float(error)


@arguments_checked
def gyroscopic_integral(
    form: ChaplyginForm, values: Mapping[sp.Symbol, float] | None = None
) -> tuple[float, float]:
    """The integral ∫ S̄ dθ dφ over the sphere, with the last change as error estimate.

    Parameters
    ----------
    form : ChaplyginForm
    values : mapping of Symbol to float, optional
        Parameters and constants, instead of their defaults.

    Returns
    -------
    value, error : float

    Raises
    ------
    InputError
        If the base is no sphere, or there is no multiplier.

    Examples
    --------
    >>> import nonholonomic
    >>> body = nonholonomic.Body(1.0, (0.4, 0.5, 0.6), nonholonomic.Ball(1.0))
    >>> form = nonholonomic.chaplygin_form(
    ...     nonholonomic.rolling_mechanism(nonholonomic.RollingBody(body, contact="rubber"))
    ... )
    >>> value, error = nonholonomic.mechanics.reduction.gyroscopic_integral(form)
    >>> abs(value) < 1e-6
    True
    """
    if form.base.normal is None or form.gyroscopic is None:
        raise InputError(
            f"{form.system.name}: the integral of S̄ needs a multiplier and a sphere to integrate "
            "over"
        )
    theta, phi = form.base.coordinates
    formula = form.gyroscopic.xreplace(dict(form.base.place)) / sp.sin(theta)
    known = _parameter_values(form, values)
    density = sp.lambdify([theta, phi], formula.subs(known), "numpy")

    def total(nodes: int) -> float:
        heights, weights = np.polynomial.legendre.leggauss(nodes)
        turns = (np.arange(2 * nodes) + 0.5) * np.pi / nodes
        # S̄ dθ dφ = −(S̄/sin θ) d(cos θ) dφ; equidistant nodes converge exponentially for a smooth
        # periodic function
        grid = density(np.arccos(heights)[:, None], turns[None, :])
        rows = np.broadcast_to(grid, (nodes, 2 * nodes)).sum(axis=1)
        return float(weights @ rows * np.pi / nodes)

    for coarse, fine in pairwise(NODES):
        value = total(fine)
        error = abs(value - total(coarse))
        if error <= SMALL * max(1.0, abs(value)):
            break
    return value, error


def _parameter_values(
    form: ChaplyginForm, values: Mapping[sp.Symbol, float] | None
) -> dict[sp.Symbol, float]:
    require_parameters(form.system.name, form.system.defaults, values or {})
    numbers = {str(s): float(v) for s, v in (values or {}).items()}
    return {s: numbers.get(str(s), float(v)) for s, v in form.system.defaults.items()}
