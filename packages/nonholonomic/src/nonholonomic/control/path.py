"""Closed paths in the plane, as functions of time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import numpy as np
import numpy.typing as npt
import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.parsing import parse
from flowlanes.parsing.exact_decimals import exact_number
from flowlanes.system.arrays import FloatArray

from ..mechanics.lagrangian.mechanism import TIME

SAMPLES = 721
"""Number of times at which a path is sampled."""
CLOSURE = 1e-9
"""Largest gap of a closed path, relative to its diameter."""


@arguments_checked
@dataclass(frozen=True)
class PlanePath:
    """A closed path of the contact point as a function of time.

    Parameters
    ----------
    x, y : str or formula
        Coordinates (m) as functions of the time ``t`` (s) on [0, period].
    period : float
        T > 0, in s; the path returns to its starting point at T.

    Raises
    ------
    InputError
        If the period is not positive, a formula cannot be read, the path is not closed or is a
        single point, or its speed is not finite.

    Examples
    --------
    >>> from nonholonomic.control import PlanePath
    >>> circle = PlanePath("cos(pi*t)", "sin(pi*t)", 2.0)
    >>> round(circle.diameter, 6), circle.places([0.5]).round(12).tolist()
    (2.0, [[0.0, 1.0]])
    """

    x: str | sp.Expr
    y: str | sp.Expr
    period: float

    def __post_init__(self) -> None:
        if not (math.isfinite(self.period) and self.period > 0):
            raise InputError(f"path: the period {self.period} must be a positive finite number")
        for name in ("x", "y"):
            value = getattr(self, name)
            formula = (
                parse(value, {"t": TIME}, f"path, {name}") if isinstance(value, str) else value
            )
            formula = sp.sympify(formula)
            if unknown := sorted(map(str, formula.free_symbols - {TIME})):
                raise InputError(f"path, {name}: {', '.join(unknown)} is not known; it may use t")
            object.__setattr__(self, name, formula)
        times = np.linspace(0.0, self.period, SAMPLES)
        for order, what in enumerate(("place", "speed")):
            values = self._values(order, times)
            if not np.isfinite(values).all():
                bad = times[~np.isfinite(values).all(axis=1)][0]
                raise InputError(
                    f"path: its {what} is not finite at t = {bad:g}; it must be smooth"
                )
        if not self.diameter > 0:
            raise InputError("path: it is a single point; a path must lead somewhere")
        gap = float(np.linalg.norm(np.diff(self.places([0.0, self.period]), axis=0)))
        if gap > CLOSURE * self.diameter:
            raise InputError(
                f"path: it is not closed; its ends, at t = 0 and t = {self.period:g}, are {gap:g} "
                "apart"
            )

    @arguments_checked
    def places(self, times: npt.ArrayLike) -> FloatArray:
        """Points (n, 2) of the path at times (n,)."""
        return self._values(0, np.asarray(times, dtype=float))

    @arguments_checked
    def velocities(self, times: npt.ArrayLike) -> FloatArray:
        """Velocities (n, 2) at times (n,)."""
        return self._values(1, np.asarray(times, dtype=float))

    @cached_property
    def diameter(self) -> float:
        """The greatest distance between two points of the path (m)."""
        points = self.places(np.linspace(0.0, self.period, SAMPLES))
        return float(np.max(np.linalg.norm(points[:, None] - points[None], axis=2)))

    def _values(self, order: int, times: FloatArray) -> FloatArray:
        with np.errstate(all="ignore"):
            columns = [
                np.broadcast_to(np.asarray(f(times), dtype=float), times.shape)
                for f in (_function(self.x, order), _function(self.y, order))
            ]
        return np.stack(columns, axis=-1)


@lru_cache(maxsize=256)
def _function(formula: sp.Expr, order: int) -> Any:
    return sp.lambdify(TIME, sp.diff(formula, TIME, order), "numpy")


@arguments_checked
def figure_of_eight(length: float, width: float, period: float) -> PlanePath:
    """A figure of eight through the origin, traversed from rest to rest.

    Parameters
    ----------
    length, width : float
        Extents along x and y (m).
    period : float
        In s.

    Returns
    -------
    PlanePath
        x = ½ length sin τ, y = ½ width sin 2τ with τ = 2πs − sin 2πs, s = t/T.

    Raises
    ------
    InputError
        If a number is not finite, the period is not positive, or both extents are zero.

    Examples
    --------
    >>> from nonholonomic.control import figure_of_eight
    >>> round(figure_of_eight(4.0, 2.0, 10.0).diameter, 3)
    4.0
    """
    for name, number in (("length", length), ("width", width)):
        if not math.isfinite(number):
            raise InputError(f"figure of eight: the {name} {number} must be a finite number")
    if not (math.isfinite(period) and period > 0):
        raise InputError(f"figure of eight: the period {period} must be a positive finite number")
    # τ′ is proportional to 1 − cos 2πs and vanishes at both ends, so the motion starts and ends at
    # rest.
    s = 2 * sp.pi * TIME / exact_number(period)
    tau = s - sp.sin(s)
    half = [exact_number(x) / 2 for x in (length, width)]
    return PlanePath(half[0] * sp.sin(tau), half[1] * sp.sin(2 * tau), period)


@arguments_checked
def path_through(points: Sequence[Sequence[float]], period: float) -> PlanePath:
    """The smooth closed path through points that are passed at equal time intervals.

    Parameters
    ----------
    points : (n, 2) array
        Points of the path; the last one equals the first.
    period : float
        In s.

    Returns
    -------
    PlanePath
        The trigonometric polynomial of least degree through the points.

    Raises
    ------
    InputError
        If there are fewer than four points, one is not finite, or the last is not the first.

    Examples
    --------
    >>> from nonholonomic.control import path_through
    >>> path = path_through([(1, 0), (0, 1), (-1, 0), (0, -1), (1, 0)], 2.0)
    >>> path.places([0.25]).round(6).tolist()
    [[0.707107, 0.707107]]
    """
    try:
        table = np.asarray(points, dtype=float)
    except (TypeError, ValueError):
        table = np.empty(0)
    if table.ndim != 2 or table.shape[1:] != (2,) or len(table) < 4:
        raise InputError("path: the points must be an array of at least four rows x, y")
    if not np.isfinite(table).all():
        raise InputError("path: all points must be finite numbers")
    gap = float(np.linalg.norm(table[-1] - table[0]))
    if gap > CLOSURE * float(np.ptp(table, axis=0).max()):
        raise InputError(
            f"path: it is not closed; the last point is {gap:g} away from the first, and must be "
            "the first again"
        )
    x, y = (_trigonometric(column, period) for column in table[:-1].T)
    return PlanePath(x, y, period)


def _trigonometric(values: FloatArray, period: float) -> sp.Expr:
    n = len(values)
    spectrum = np.fft.rfft(values) / n
    angle = 2 * sp.pi * TIME / sp.Float(period)
    total: sp.Expr = sp.Float(spectrum[0].real)
    for k in range(1, len(spectrum)):
        # Waves k and −k are conjugate and count together; the highest one of an even number of
        # points is its own partner, and its sine vanishes at all points.
        weight = 1 if 2 * k == n else 2
        c, s = weight * spectrum[k].real, -weight * spectrum[k].imag
        total += sp.Float(c) * sp.cos(k * angle)
        if 2 * k != n:
            total += sp.Float(s) * sp.sin(k * angle)
    return total
