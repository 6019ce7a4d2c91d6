"""A rubber body of revolution in double precision, for many times at once."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from flint import acb

from ...formulas.balls import array_function
from ..one_degree import MotionSample, QuadratureMotion
from ..one_degree.uniformisation import DOUBLES
from .angles import LinearPhase, glides, turned, walks
from .body import Level, u
from .state import assembled, path_speed

__all__ = ["FastRevolution", "StartFrame", "spins"]

#: Below this angle of precession, in the time of one unit of the phase, the path in a tail is
#: computed as that of a slow turn.
SLOW = 1e-3


@dataclass(frozen=True)
class StartFrame:
    """What joins a course to its start; balls.

    Attributes
    ----------
    phi, psi : arb
        At the turning point σ = 0 next to the start.
    origin : acb
        The place there.
    own, precession : arb
        Gained by φ and ψ in a period.
    turn : arb
        By which the path turns in a period.
    step : acb
        By which it is displaced, for ψ = 0 at the beginning.
    passes : two bools
        Whether the axis passes the vertical in every period, at θ = 0 and at θ = π.
    """

    phi: Any
    psi: Any
    origin: Any
    own: Any
    precession: Any
    turn: Any
    step: Any
    passes: tuple[bool, bool]


def spins(level: Level) -> Any:
    """(cos θ, sin θ) ↦ ω₃/sin θ, in arrays."""
    if level.K == 0:
        return lambda cosine, across: np.zeros_like(cosine)
    names = tuple(level.body.values)
    square = array_function((u, *names), (level.body.square,))
    numbers = [float(x) for x in level.body.values.values()]
    K = float(level.K)
    return lambda cosine, across: K / (np.sqrt(square(cosine, *numbers)[0]) * across)


class FastRevolution:
    """States at many times.

    Parameters
    ----------
    level : Level
    course : Course
    frame : Frame
    digits : int
        Behind the constants.
    """

    def __init__(
        self, level: Level, course: QuadratureMotion, frame: StartFrame, digits: int
    ) -> None:
        self._course, self._frame = course, frame
        self._spin = spins(level)
        self._own, self._precession = LinearPhase.of(frame.own), LinearPhase.of(frame.precession)
        self._turn = LinearPhase.of(frame.turn)
        self._begin = (float(frame.phi), float(frame.psi))
        self._origin, self._facing = _complex(frame.origin), _complex(turned(frame.psi))
        self._tails: tuple[_Tail, ...] = ()
        if not course.periodic:
            self._tails = tuple(_Tail.of(level, course, digits, side) for side in (-1, 1))

    def __call__(self, times: Any) -> Any:
        """States (n, 12)."""
        chart, at = self._course.chart, self._course.fast.place(times)
        phi, psi, x, y = at.values
        count = at.periods
        steps = walks(count, self._frame.turn, self._frame.step)
        path = steps + np.exp(1j * self._turn(count)) * (x + 1j * y)
        phi, psi = phi + self._own(count), psi + self._precession(count)
        for tail in self._tails:
            phi, psi, path = tail.replaced(times, at, (phi, psi, path))
        place = self._origin + self._facing * path
        low, high = chart.roots(DOUBLES, at.phase)
        lean = -chart.lean(DOUBLES, at.phase) * at.rate
        flips = [np.where(passed & (count % 2 != 0), -1.0, 1.0) for passed in self._frame.passes]
        sine, cosine = (
            flip * root / np.sqrt(2) for flip, root in zip(flips, (high, low), strict=True)
        )
        lean = lean * flips[0] * flips[1]
        spin = self._spin(cosine * cosine - sine * sine, 2 * sine * cosine)
        angles = (self._begin[0] + phi, self._begin[1] + psi)
        return np.stack(assembled(DOUBLES, (sine, cosine), (lean, spin), angles, place), axis=1)


def _complex(number: Any) -> complex:
    return complex(float(number.real.mid()), float(number.imag.mid()))


@dataclass(frozen=True)
class _Tail:
    """One end of an asymptotic motion, where θ no longer changes.

    Attributes
    ----------
    side : −1 or 1
        Past or future.
    own, precession : Turning
        φ and ψ as functions of the time.
    rate, speed : acb
        Of the precession, and of the path.
    slow : bool
        Whether the precession is so slow that its rate is no good divisor.
    facing : float
        ψ where the tail begins.
    corner : complex
        The place there.
    """

    side: int
    own: LinearPhase
    precession: LinearPhase
    rate: Any
    speed: Any
    slow: bool
    facing: float
    corner: complex

    @classmethod
    def of(cls, level: Level, course: QuadratureMotion, digits: int, side: int) -> _Tail:
        known = course.integrals(digits)
        edge = known.panels[-1].high if side > 0 else known.panels[0].low
        limit, phi, psi, x, y = (known.value(i, edge) for i in range(5))
        begins = limit - known.value(0, course.chart.phase(course.x, course.rate))
        end = course.tails[1 if side > 0 else 0]
        own, rate = course.limits(digits, end)
        return cls(
            side,
            LinearPhase.of(own, phi - own * begins),
            LinearPhase.of(rate, psi - rate * begins),
            rate,
            acb(path_speed(level, acb(end.place))),
            abs(float(rate)) * course.moment < SLOW,
            float(psi),
            _complex(acb(x, y)),
        )

    def replaced(self, times: Any, at: MotionSample, known: Any) -> tuple[Any, Any, Any]:
        """φ, ψ and the path, replaced where the motion is in this tail."""
        there = at.beyond * self.side > 0
        psi = self.precession(times)
        if self.slow:
            way = np.exp(1j * self.facing) * glides(at.beyond, self.rate, self.speed)
        else:
            speed = _complex(self.speed) / (1j * float(self.rate))
            way = speed * (np.exp(1j * psi) - np.exp(1j * self.facing))
        found = (self.own(times), psi, self.corner + way)
        phi, psi, path = (np.where(there, *pair) for pair in zip(found, known, strict=True))
        return phi, psi, path
