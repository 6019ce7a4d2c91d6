"""Angles and paths after many periods: Theorem 4's change of variables in the group of motions.

In one period of θ the body turns by Δφ about its axis and Δψ about the vertical, and its place is
displaced by D.  After n periods it is

    D (e^{inΔψ} − 1)/(e^{iΔψ} − 1),

a bounded quasi-periodic walk unless Δψ is a multiple of 2π, when it drifts by D each period.
Formulas come in pairs: balls for the rigorous evaluator, arrays for the fast one.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from flint import acb, arb

from ..one_degree.phase_reduction import Pair, fraction, pair

__all__ = ["LinearPhase", "glide", "glides", "turned", "turns", "walk", "walks"]


def turned(angle: Any) -> Any:
    """e^{i angle} of a real ball, as an acb."""
    sin, cos = angle.sin_cos()
    return acb(cos, sin)


def principal(angle: Any) -> Any:
    """An angle (arb) brought near zero by a multiple of 2π."""
    whole = (angle / (2 * arb.pi()) + arb("0.5")).mid().floor()
    return angle - 2 * arb.pi() * whole


def turns(angle: Any) -> Pair:
    """An angle (arb) as a fraction of 4π: half of it still has its sign."""
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
    def of(cls, rate: Any, begin: Any = arb(0)) -> LinearPhase:  # noqa: B008  (immutable)
        """From balls."""
        full = 4 * arb.pi()
        return cls(turns(rate), float((begin - full * (begin / full).mid().floor()).mid()))

    def __call__(self, times: Any) -> Any:
        """The angle, less a multiple of 4π."""
        return 4 * np.pi * fraction(times, self.share) + self.begin


def walk(count: int, turn: Any, step: Any) -> Any:
    """Σ step · e^{ij turn} for j from 0 to count − 1, in balls (acb)."""
    half = principal(turn) / 2
    sine = half.sin()
    if count == 0:
        return acb(0)
    if sine.contains(0):
        ratio = count * (1 + arb(0, abs(count * half).upper()))
    else:
        ratio = (count * half).sin() / sine
    return step * turned((count - 1) * half) * ratio


def walks(counts: Any, turn: Any, step: Any) -> Any:
    """The same for an array of counts, in double precision; `turn` and `step` are balls."""
    half = principal(turn) / 2
    angle = 4 * np.pi * fraction(counts, turns(half))
    sine = float(half.sin().mid())
    resonant = half.sin().contains(0) or sine == 0.0
    ratio = counts if resonant else np.sin(angle) / sine
    return complex(step.mid()) * np.exp(1j * (angle - float(half.mid()))) * ratio


def glide(time: Any, rate: Any, speed: Any) -> Any:
    """∫ speed · e^{i rate t} dt from 0 to `time`, in balls (acb)."""
    half = rate * time / 2
    return speed * turned(half) * time * half.sinc()


def glides(times: Any, rate: Any, speed: Any) -> Any:
    """The same for an array of times, in double precision."""
    half = rate / 2
    angle = 4 * np.pi * fraction(times, turns(half))
    slow = abs(float(half.mid())) * np.abs(times) < 0.5
    small = times * np.sinc(float(half.mid()) * times / np.pi)
    ratio = np.where(slow, small, np.sin(angle) / (float(half.mid()) or 1.0))
    return complex(speed.mid()) * np.exp(1j * angle) * ratio
