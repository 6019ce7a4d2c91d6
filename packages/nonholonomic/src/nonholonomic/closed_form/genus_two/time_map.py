"""The physical time on a torus: linear in τ plus a quasi-periodic part, and its inverse."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from flint import arb, ctx

from flowlanes.formulas.balls import components, number
from flowlanes.system.arrays import FloatArray

from ..one_degree.phase_reduction import pair
from .phases import phase_at
from .quadrature import Quadrature, quadrature, series
from .separated_motion import SeparatedMotion, on_arrays, on_balls
from .torus_average import mean

#: Number of Newton steps for the clock; four or five suffice.
_STEPS = 40


@dataclass(frozen=True)
class TorusPoint:
    """Points on the torus.

    Attributes
    ----------
    v : array (n, 2)
        Phases, modulo 4.
    tau : array (n,)
    """

    v: FloatArray
    tau: FloatArray


@dataclass(frozen=True)
class TimeMap:
    """t as a function of τ, and its inverse.

    Attributes
    ----------
    flow : Quadrature
        ∫ (dt/dτ) dτ.
    mean : arb
        The mean of dt/dτ.
    Omega : pair of (float, float)
        Mean velocity of the phases in t, each as a sum of two doubles.
    V, v_0 : array (2,)
        Velocity in τ and start of the phases.
    """

    flow: Quadrature
    mean: arb
    Omega: tuple[tuple[float, float], tuple[float, float]]
    V: FloatArray
    v_0: FloatArray

    def torus_point(self, times: FloatArray) -> TorusPoint:
        """Phases and τ at the times (n,)."""
        mean_clock = self.flow.mean
        ideal = np.stack([phase_at(rate, times, 4.0) for rate in self.Omega], axis=1) + self.v_0
        tau = times / mean_clock
        # the time in which the faster phase grows by one
        period = 1 / np.max(np.abs(self.V))
        delta = np.zeros_like(tau)
        # The clock equation is mean δ + p(v) = 0; its left side increases with δ.
        low, high = np.full_like(tau, -np.inf), np.full_like(tau, np.inf)
        for _ in range(_STEPS):
            v = ideal + delta[:, None] * self.V
            value, rate = self.flow.quasi(v, tau + delta)
            miss = mean_clock * delta + value
            low, high = np.where(miss < 0, delta, low), np.where(miss > 0, delta, high)
            step = -miss / (mean_clock + rate)
            following = delta + step
            outside = (following <= low) | (following >= high)
            outside &= np.isfinite(low) & np.isfinite(high)
            following[outside] = (low[outside] + high[outside]) / 2
            settled = np.abs(following - delta) <= 4e-16 * np.maximum(period, np.abs(delta))
            delta = following
            if settled.all():
                break
        return TorusPoint(ideal + delta[:, None] * self.V, tau + delta)


def clock_of(motion: SeparatedMotion, bits: int) -> TimeMap:
    """The clock of a motion.

    Parameters
    ----------
    bits : int
        Working precision of the frequencies.
    """
    torus = motion.torus
    rate = components(motion.separable.time_rescaling)
    rates, exact = on_arrays(motion, rate), on_balls(motion, rate)
    v_0 = np.array([number(x) for x in torus.v_0])
    (rough,) = series(lambda v: rates(*torus.values(v)))
    average = mean(torus, lambda *six: exact(*six)[0], rough)
    flow = quadrature(rough, torus.V, v_0, None if average is None else number(average))
    if average is None:
        average = arb(flow.mean)
    with ctx.workprec(bits):
        Omega = (pair(torus.V[0] / average), pair(torus.V[1] / average))
    return TimeMap(flow, average, Omega, np.array([number(x) for x in torus.V]), v_0)
