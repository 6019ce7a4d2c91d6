"""Motions in one degree of freedom: state, angles and path from a quadrature.

Angles and the path are quadratures along x(t), assembled by the same formula in balls and arrays; a
:class:`.frames.MotionFrame` computes the state from them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt
import sympy as sp
from flint import acb, arb, ctx

from flowlanes.arguments import NumberOrText, arguments_checked
from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import System

from ..base.solution import ClosedForm, Solution, finite_times
from . import FAST, MotionSample, QuadratureMotion
from .angles import (
    ComplexArray,
    LinearPhase,
    circular_path,
    circular_paths,
    displacement_sum,
    displacement_sums,
    unit_complex,
)
from .chebyshev_integrals import working_bits
from .frames import MotionFrame
from .functions import BALLS, DOUBLES
from .working_precision import exact_time, working_digits

#: Precession angle, per unit of the phase, below which the path in a tail is evaluated in the
#: slow-rotation limit: dividing by the rate would lose accuracy.
SLOW = 1e-3

Parameters = Mapping[sp.Symbol, NumberOrText]


@dataclass(frozen=True)
class Constants:
    """The constants that connect the quadratures of a motion to its start.

    Attributes
    ----------
    angles : tuple of arb
        At the turning point σ = 0 next to the start.
    gains : tuple of arb
        Of the angles in a period.
    origin : acb
        The position at that turning point.
    heading : acb
        e^{iψ} by which the path is turned.
    turn : arb
        The angle by which the path turns in a period.
    step : acb
        Its displacement in a period, before it is turned by `heading`.
    """

    angles: tuple[arb, ...]
    gains: tuple[arb, ...]
    origin: acb
    heading: acb
    turn: arb
    step: acb


class QuadratureSolution(Solution):
    """A motion in one degree of freedom.

    Attributes
    ----------
    motion : QuadratureMotion
        x(t) with its angles, and with the path of a motion in space.
    frame : MotionFrame
    """

    def __init__(
        self,
        system: System,
        parameters: Parameters,
        motion: QuadratureMotion,
        frame: MotionFrame,
        form: Callable[[], ClosedForm],
    ) -> None:
        self.system, self.parameters = system, parameters
        self.motion, self.frame, self._write_form = motion, frame, form

    @cached_property
    def form(self) -> ClosedForm:
        """The quadrature, its roots and mean rates."""
        with ctx.workprec(working_bits(FAST)):
            return self._write_form()

    @property
    def phase_rate(self) -> float:
        """The rate of the phase of x at the turning point."""
        return 1 / self.motion.time_scale

    def _constants(self, digits: int) -> Constants:
        motion, frame = self.motion, self.frame
        known, sigma = motion.integrals(digits), motion.start_phase
        quadratures = [known.value(i, sigma) for i in range(1, known.count)]
        angles = tuple(
            angle - quadrature
            for angle, quadrature in zip(frame.start_angles(motion), quadratures, strict=False)
        )
        gains = motion.advances(digits)[1:] if motion.periodic else ()
        angle_gains = gains[: len(angles)]
        if not frame.position:
            return Constants(angles, angle_gains, acb(0), acb(1), arb(0), acb(0))
        heading = unit_complex(angles[1]) if frame.turning_path else acb(1)
        origin = acb(*frame.position) - heading * acb(*quadratures[-2:])
        if not motion.periodic:
            return Constants(angles, angle_gains, origin, heading, arb(0), acb(0))
        if not frame.turning_path:
            return Constants(angles, angle_gains, origin, heading, arb(0), acb(*gains[-2:]))
        turn = angle_gains[1] + (arb.pi() if sum(motion.passed_edges) == 1 else 0)
        last = (known.count - 2, known.count - 1)
        left, right = (acb(*(end(i) for i in last)) for end in (known.left_end, known.right_end))
        step = right - unit_complex(turn) * left
        return Constants(angles, angle_gains, origin, heading, turn, step)

    # --- in balls --------------------------------------------------------------------------

    @arguments_checked
    def rigorous(self, time: NumberOrText, digits: int = 30) -> tuple[arb, ...]:
        """The state at one time as balls that contain the exact state.

        Raises
        ------
        InputError
            If more digits are needed than the start is carried with.
        """
        motion, frame = self.motion, self.frame
        powers = 2 if frame.position and not motion.periodic else 1
        work = working_digits(time, digits, powers, self.phase_rate)
        with ctx.workprec(working_bits(work)):
            constants = self._constants(work)
            sample = motion.sample(exact_time(time), work)
            angles, count = list(sample.values[: frame.angles]), sample.periods
            path = acb(0)
            if frame.position:
                path = displacement_sum(count, constants.turn, constants.step)
                path += unit_complex(count * constants.turn) * acb(*sample.values[-2:])
            if motion.periodic:
                angles = [x + count * gain for x, gain in zip(angles, constants.gains, strict=True)]
            elif sample.tail != 0:
                end = motion.end_of_tail(future=sample.tail > 0)
                rates = motion.limits(work, end)
                if frame.position:
                    # All values of x between the edge of the integrals and the double root.
                    x = acb(end.x.union(motion.chart.coordinate(BALLS, sample.phase)))
                    speed = unit_complex(angles[1]) * frame.path_speed(x)
                    path += circular_path(sample.tail, rates[1], speed)
                angles = [x + rate * sample.tail for x, rate in zip(angles, rates, strict=True)]
            angles = [x + begin for x, begin in zip(angles, constants.angles, strict=True)]
            place = constants.origin + constants.heading * path
            position = [place.real, place.imag] if frame.position else []
            return (*frame.state(BALLS, motion, sample, angles), *position)

    # --- in double precision ---------------------------------------------------------------

    @cached_property
    def _fast(self) -> _FastAngles:
        return _FastAngles(self.motion, self.frame, self._constants(FAST))

    @arguments_checked
    def states(self, times: npt.ArrayLike) -> FloatArray:
        """States at `times` (n,), as an array (n, size)."""
        moments = finite_times(times)
        sample = self.motion.fast.sample(moments)
        # Constants are rounded to doubles once.
        with ctx.workprec(working_bits(FAST)):
            angles, position = self._fast(moments, sample)
            state = [*self.frame.state(DOUBLES, self.motion, sample, angles), *position]
        return np.stack([np.broadcast_to(x, moments.shape) for x in state], axis=1)


class _FastAngles:
    """Angles and positions in double precision, at many times at once."""

    def __init__(self, motion: QuadratureMotion, frame: MotionFrame, constants: Constants) -> None:
        self._frame, self._constants = frame, constants
        self._begin = [float(angle) for angle in constants.angles]
        self._gains = [LinearPhase.from_balls(gain) for gain in constants.gains]
        self._turn = LinearPhase.from_balls(constants.turn)
        self._origin, self._heading = (_double(x) for x in (constants.origin, constants.heading))
        self._tails = (
            () if motion.periodic else tuple(_Tail(motion, frame, side) for side in (-1, 1))
        )

    def __call__(
        self, times: FloatArray, sample: MotionSample[FloatArray, FloatArray]
    ) -> tuple[list[FloatArray], list[FloatArray]]:
        count, constants = sample.periods, self._constants
        angles = list(sample.values[: self._frame.angles])
        for i, gain in enumerate(self._gains):
            angles[i] = angles[i] + gain(count)
        path: ComplexArray = np.zeros(len(times), dtype=complex)
        if self._frame.position:
            x, y = sample.values[-2:]
            path = displacement_sums(count, constants.turn, constants.step)
            path = path + np.exp(1j * self._turn(count)) * (x + 1j * y)
        for tail in self._tails:
            angles, path = tail.continuation(times, sample, angles, path)
        angles = [begin + angle for begin, angle in zip(self._begin, angles, strict=True)]
        place = self._origin + self._heading * path
        return angles, [place.real, place.imag] if self._frame.position else []


def _double(number: acb) -> complex:
    return complex(float(number.real.mid()), float(number.imag.mid()))


class _Tail:
    """One end of an asymptotic motion, where x is constant in double precision.

    Parameters
    ----------
    motion : QuadratureMotion
    frame : MotionFrame
    side : −1 or 1
        Past or future.
    """

    def __init__(self, motion: QuadratureMotion, frame: MotionFrame, side: int) -> None:
        known = motion.integrals(FAST)
        edge = known.panels[-1].high if side > 0 else known.panels[0].low
        time, *values = (known.value(i, edge) for i in range(known.count))
        begin = time - known.value(0, motion.start_phase)
        end = motion.end_of_tail(future=side > 0)
        rates = motion.limits(FAST, end)
        self._side, self._frame = side, frame
        self._angles = [
            LinearPhase.from_balls(rate, value - rate * begin)
            for rate, value in zip(rates, values, strict=False)
        ]
        if frame.position:
            # The precession is too slow to divide by its rate.
            self._slow = abs(float(rates[1])) * motion.time_scale < SLOW
            self._rate, self._heading = rates[1], float(values[1])
            self._speed = acb(frame.path_speed(acb(end.x)))
            self._tail_start = _double(acb(*values[-2:]))

    def continuation(
        self,
        times: FloatArray,
        sample: MotionSample[FloatArray, FloatArray],
        angles: Sequence[FloatArray],
        path: ComplexArray,
    ) -> tuple[list[FloatArray], ComplexArray]:
        """Angles and path, replaced at the times at which the motion is in this tail."""
        inside = sample.tail * self._side > 0
        limits = [phase(times) for phase in self._angles]
        if self._frame.position:
            start = np.exp(1j * self._heading)
            if self._slow:
                arc = start * circular_paths(sample.tail, self._rate, self._speed)
            else:
                speed = _double(self._speed) / (1j * float(self._rate))
                arc = speed * (np.exp(1j * limits[1]) - start)
            path = np.where(inside, self._tail_start + arc, path)
        pairs = zip(limits, angles, strict=True)
        return [np.where(inside, limit, angle) for limit, angle in pairs], path
