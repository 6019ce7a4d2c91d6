"""Angles and paths after many periods: Theorem 4's change of variables in the group of motions.

In one period of θ the body turns by Δφ about its axis and by Δψ about the vertical,
and its position is displaced by D.  After n periods the displacement is

    D (e^{inΔψ} − 1)/(e^{iΔψ} − 1),

a bounded quasi-periodic walk unless Δψ is a multiple of 2π; then it drifts by D per period.
Formulas come in pairs: balls for the rigorous evaluator, arrays for the fast one.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
import numpy.typing as npt
from flint import acb, arb

from flowlanes.system.arrays import FloatArray

from .phase_reduction import Pair, fraction, pair

ComplexArray: TypeAlias = npt.NDArray[np.complex128]


def unit_complex(angle: arb) -> acb:
    """e^{i angle} of a real ball."""
    sin, cos = angle.sin_cos()
    return acb(cos, sin)


def principal(angle: arb) -> arb:
    """An angle modulo 2π, near zero."""
    whole = (angle / (2 * arb.pi()) + arb("0.5")).mid().floor()
    return angle - 2 * arb.pi() * whole


def over_two_turns(angle: arb) -> Pair:
    """An angle as a fraction of 4π, so that the sign of functions of half the angle is kept."""
    return pair(angle / (4 * arb.pi()))


@dataclass(frozen=True)
class LinearPhase:
    """An angle that grows in proportion to a time or a count, for arrays.

    Attributes
    ----------
    share : pair of doubles
        Its rate by 4π.
    begin : float
        Its value at zero, less a multiple of 4π.
    """

    share: Pair
    begin: float = 0.0

    @classmethod
    def from_balls(cls, rate: arb, begin: arb = arb(0)) -> LinearPhase:  # noqa: B008  (immutable)
        """The angle `begin` + `rate`·t."""
        full = 4 * arb.pi()
        return cls(over_two_turns(rate), float((begin - full * (begin / full).mid().floor()).mid()))

    def __call__(self, times: FloatArray) -> FloatArray:
        """The angle, modulo 4π."""
        return 4 * np.pi * fraction(times, self.share) + self.begin


def displacement_sum(count: int, turn: arb, step: acb) -> acb:
    """Σ step · e^{ij turn} for j from 0 to count − 1, in balls."""
    half = principal(turn) / 2
    sine = half.sin()
    if count == 0:
        return acb(0)
    if sine.contains(0):
        # The ratio is Σ exp(i(2j − n + 1)h), h half the turn, and each term is within n|h| of 1.
        ratio = count * (1 + arb(0, abs(count * half).upper()))
    else:
        ratio = (count * half).sin() / sine
    return step * unit_complex((count - 1) * half) * ratio


def displacement_sums(counts: FloatArray, turn: arb, step: acb) -> ComplexArray:
    """Σ step · e^{ij turn} for j from 0 to count − 1, for counts (n,) in double precision."""
    half = principal(turn) / 2
    angle = 4 * np.pi * fraction(counts, over_two_turns(half))
    sine = float(half.sin().mid())
    resonant = half.sin().contains(0) or sine == 0.0
    ratio = counts if resonant else np.sin(angle) / sine
    sums: ComplexArray = complex(step.mid()) * np.exp(1j * (angle - float(half.mid()))) * ratio
    return sums


def circular_path(time: arb, rate: arb, speed: acb) -> acb:
    """∫ speed · e^{i rate t} dt from 0 to `time`, in balls."""
    half = rate * time / 2
    return speed * unit_complex(half) * time * half.sinc()


def circular_paths(times: FloatArray, rate: arb, speed: acb) -> ComplexArray:
    """∫ speed · e^{i rate t} dt from 0 to times (n,), in double precision."""
    half = rate / 2
    angle = 4 * np.pi * fraction(times, over_two_turns(half))
    # sin(ht)/h loses digits, or divides by zero, where ht is small; t sinc(ht) does not.
    slow = abs(float(half.mid())) * np.abs(times) < 0.5
    small = times * np.sinc(float(half.mid()) * times / np.pi)
    ratio = np.where(slow, small, np.sin(angle) / (float(half.mid()) or 1.0))
    path: ComplexArray = complex(speed.mid()) * np.exp(1j * angle) * ratio
    return path
