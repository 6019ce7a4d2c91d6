"""Integration of a smooth piece of a motion to its end or to an event."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from scipy.integrate import DOP853
from scipy.optimize import brentq, minimize_scalar

from contact.reference_bodies import Array

Watch = Callable[[float, Array], list[float]]

_PARTS = np.arange(1, 8) / 8
"""Parts of a step at which the watched values are computed."""

_FIRST_PARTS = np.concatenate([10.0 ** np.arange(-5, -1), _PARTS])
"""Likewise of the first step, at whose start a value may be zero, and again soon after."""


class Extrapolation:
    """Integration in the arithmetic of the state, to any precision, with the face of `DOP853`.

    The modified midpoint rule with 2, 4, ..., 20 substeps, extrapolated to none (Gragg, Bulirsch
    and Stoer). Every coefficient is a ratio of whole numbers, so that long double states keep their
    nineteen digits.
    """

    columns = 10

    def __init__(
        self,
        rate: Callable[[float, Array], Array],
        start: float,
        state: Array,
        end: float,
        rtol: float,
        scales: Array,
        first_step: float | None = None,
    ) -> None:
        self.rate, self.t, self.y, self.end = rate, start, state, end
        self.rtol, self.scales = rtol, scales
        speed = float(np.max(np.abs(rate(start, state)) / scales))
        self.h = first_step if first_step is not None else min(end - start, 0.3 / max(speed, 1e-9))
        self.status = "running"
        self.last = (self.t, self.y)

    def advanced(self, t: float, y: Array, h: float) -> tuple[Array, Array]:
        """State after one step and the difference of the two best extrapolations."""
        slope = self.rate(t, y)
        row: list[Array] = []
        for k in range(1, self.columns + 1):
            n = 2 * k
            small = h / n
            older, newer = y, y + small * slope
            for i in range(1, n):
                older, newer = newer, older + 2.0 * small * self.rate(t + i * small, newer)
            new = [0.5 * (older + newer + small * self.rate(t + h, newer))]
            for j, previous in enumerate(row, start=1):
                ratio = (
                    (k * k) / (k - j) ** 2
                    if y.dtype != np.longdouble
                    else (np.longdouble(k * k) / (k - j) ** 2)
                )
                new.append(new[-1] + (new[-1] - previous) / (ratio - 1))
            row = new
        return row[-1], row[-1] - row[-2]

    def step(self) -> str | None:
        """Advance by one accepted step."""
        while True:
            h = min(self.h, self.end - self.t)
            y, difference = self.advanced(self.t, self.y, h)
            sizes = self.scales + np.abs(y)
            error = float(np.sqrt(np.mean((difference / sizes).astype(float) ** 2))) / self.rtol
            factor = 0.9 * max(error, 1e-8) ** (-1.0 / (2 * self.columns - 1))
            self.h = h * min(3.0, max(0.2, factor))
            if math.isfinite(error) and error <= 1.0:
                break
            if not math.isfinite(error):
                self.h = 0.2 * h
            if self.h < 1e-12 * abs(self.end - self.t) and self.h < 1e-12 * abs(self.t):
                self.status = "failed"
                return "step too small"
        self.last = (self.t, self.y)
        done = h == self.end - self.t
        self.t, self.y = self.end if done else self.t + h, y
        if done:
            self.status = "finished"
        return None

    def dense_output(self) -> Callable[[float], Array]:
        """State within the last step, by a shorter step from its beginning."""
        t0, y0 = self.last

        def at(t: float) -> Array:
            return y0 if t == t0 else self.advanced(t0, y0, t - t0)[0]

        return at


def integration(
    rate: Callable[[float, Array], Array],
    start: float,
    state: Array,
    end: float,
    rtol: float,
    scales: Array,
    first_step: float | None = None,
) -> DOP853 | Extrapolation:
    """DOP853 for floats, extrapolation for long double."""
    if state.dtype == np.longdouble:
        return Extrapolation(rate, start, state, end, rtol, scales, first_step)
    return DOP853(rate, start, state, end, rtol=rtol, atol=rtol * scales, first_step=first_step)


def run(
    rate: Callable[[float, Array], Array],
    start: float,
    state: Array,
    end: float,
    watch: Watch,
    rtol: float,
    scales: Array,
    first_step: float | None = None,
) -> tuple[float, Array, int | None]:
    """Integrate until one of the watched values falls from above to zero, or until `end`.

    Returns
    -------
    tuple
        Time, state and index of the value that fell to zero (None at the end).
    """
    solver = integration(rate, start, state, end, rtol, scales, first_step)
    before = np.array(watch(start, state))
    parts = _FIRST_PARTS
    while solver.status == "running":
        t0, z0 = solver.t, solver.y.copy()
        message = solver.step()
        if solver.status == "failed":
            raise ArithmeticError(f"integration failed at {t0}: {message}")
        dense = solver.dense_output()
        samples = [t0, *(t0 + (solver.t - t0) * parts), solver.t]
        parts = _PARTS
        values = [before, *(np.array(watch(s, dense(s))) for s in samples[1:-1])]
        values.append(np.array(watch(solver.t, solver.y)))
        table = np.array(values)
        first: tuple[float, int] | None = None
        for i in range(table.shape[1]):
            moment = _fall(lambda s, i=i, dense=dense: watch(s, dense(s))[i], samples, table[:, i])
            if moment is not None and (first is None or moment < first[0]):
                first = (moment, i)
        if first is not None:
            t, z = _polished(rate, t0, z0, first, watch, rtol, scales)
            return t, z, first[1]
        before = values[-1]
    return solver.t, solver.y, None


def _fall(value: Callable[[float], float], times_: list[float], values: Array) -> float | None:
    """First moment at which a value falls from above to zero, by samples and root finding."""
    for j in range(len(times_) - 1):
        if values[j] > 0.0 >= values[j + 1]:
            if values[j + 1] == 0.0:
                return times_[j + 1]
            return float(brentq(value, times_[j], times_[j + 1], xtol=1e-300, rtol=1e-15))
        if 0 < j < len(times_) - 1 and values[j - 1] > values[j] < values[j + 1]:
            second = values[j - 1] - 2.0 * values[j] + values[j + 1]
            dip = values[j] - (values[j + 1] - values[j - 1]) ** 2 / (8.0 * second)
            if values[j] > 0.0 and dip < 0.5 * values[j]:
                bounds = (times_[j - 1], times_[j + 1])
                lowest = minimize_scalar(value, bounds=bounds, method="bounded")
                if lowest.fun < 0.0:
                    return float(brentq(value, times_[j - 1], lowest.x, xtol=1e-300, rtol=1e-15))
    return None


def _polished(
    rate: Callable[[float, Array], Array],
    t0: float,
    z0: Array,
    found: tuple[float, int],
    watch: Watch,
    rtol: float,
    scales: Array,
) -> tuple[float, Array]:
    """Integrate anew to a supposed event, correct its time by the value found there, twice."""
    moment, i = found
    for _ in range(3):
        if moment <= t0:
            return t0, z0
        z, dense = _carried(rate, t0, z0, moment, rtol, scales)
        value = watch(moment, z)[i]
        h = 1e-4 * (moment - t0)
        slope = (value - watch(moment - h, dense(moment - h))[i]) / h
        if not math.isfinite(slope) or slope >= 0.0:
            break
        step = -value / slope
        if abs(step) <= 2.0 * np.finfo(z0.dtype).eps * abs(moment):
            break
        moment += step
    return moment, _carried(rate, t0, z0, moment, rtol, scales)[0]


def _carried(
    rate: Callable[[float, Array], Array],
    t0: float,
    z0: Array,
    end: float,
    rtol: float,
    scales: Array,
) -> tuple[Array, Callable[[float], Array]]:
    """State at `end`, and the dense output of the last step."""
    solver = integration(rate, t0, z0, end, rtol, scales, end - t0)
    while solver.status == "running":
        solver.step()
    if solver.status == "failed":
        raise ArithmeticError(f"integration failed at {solver.t}")
    return solver.y, solver.dense_output()
