"""Find the zeros of a quantity along the smooth pieces of a motion in contact."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from flowlanes.system.arrays import FloatArray

from .compiled import CompiledContact
from .course import Course
from .end_reasons import EndError
from .event_rules import EventRules
from .mode_integrator import ModeIntegrator, StepSeries
from .onset import Onset

#: Degree of the Chebyshev interpolant of the quantity within a step.
_DEGREE = 24

#: Number of Newton steps on the Taylor series.
_POLISH = 6

_NODES = np.cos(np.pi * (np.arange(_DEGREE + 1) + 0.5) / (_DEGREE + 1))
_INTERPOLATION = np.linalg.inv(np.polynomial.chebyshev.chebvander(_NODES, _DEGREE))

#: Maps states (n, size) of a mode to values (n,).
Quantity = Callable[[ModeIntegrator, FloatArray], FloatArray]


@dataclass(frozen=True, eq=False)
class Crossing:
    """A zero crossing of a quantity.

    Attributes
    ----------
    time : float
    state : array (size,)
    integrator : ModeIntegrator
        Integrator of the mode at that time.
    mode : str
    rising : bool
    """

    time: float
    state: FloatArray
    integrator: ModeIntegrator
    mode: str
    rising: bool


class CrossingCourse(Course):
    """A simulation that records the zero crossings of a quantity until there are enough of them.

    Parameters
    ----------
    contact, state, moments, rules
        As of `CourseState`.
    quantity : callable
        A function that is smooth between events. Jumps at events, as of a velocity in an impact,
        are not crossings.
    accepts : callable
        Whether a crossing counts.
    count : int
        Number of accepted crossings after which the motion ends.
    """

    def __init__(
        self,
        contact: CompiledContact,
        state: FloatArray,
        moments: FloatArray,
        rules: EventRules,
        quantity: Quantity,
        accepts: Callable[[Crossing], bool],
        count: int,
    ) -> None:
        super().__init__(contact, state, moments, rules)
        self.crossings: list[Crossing] = []
        self._first_time = float(moments[0])
        self._quantity, self._accepts, self._count = quantity, accepts, count

    def _integrate(self) -> str:
        integrator, begin, state, mode = (
            self._integrator(self.mode),
            self.time,
            self._with_height(self.state.copy()),
            self.mode.name,
        )
        guard = super()._integrate()
        self._search(integrator, begin, state, self.time, mode)
        return guard

    def _take_onset(self, slide: Onset) -> None:
        begin, state = self.time, np.append(self.state, 0.0)
        super()._take_onset(slide)
        self._search(slide.integrator, begin, state, self.time, self.mode.name)

    def _search(
        self, integrator: ModeIntegrator, begin: float, state: FloatArray, end: float, mode: str
    ) -> None:
        """Record the crossings within a piece."""
        for series in integrator.series(begin, state, end):
            for crossing in self._within(series, integrator, mode):
                if self._accepts(crossing):
                    self.crossings.append(crossing)
                if len(self.crossings) >= self._count:
                    raise EndError("", "")

    def _within(self, series: StepSeries, integrator: ModeIntegrator, mode: str) -> list[Crossing]:
        """The crossings within a step, in order of time.

        The quantity is interpolated at Chebyshev points of the step; the real zeros of the
        interpolant in [−1, 1] are eigenvalues of its colleague matrix (Boyd, SIAM J. Numer. Anal.
        40 (2002) 1666).  A step is skipped if |c₀| > Σ|c_k|: the interpolant then has no zero.
        Each zero is refined by Newton's method on the Taylor series of the step.
        """
        middle, half = (series.begin + series.end) / 2, (series.end - series.begin) / 2
        coefficients = _INTERPOLATION @ self._values(series, integrator, middle + half * _NODES)
        size = np.abs(coefficients)
        if not np.isfinite(size).all() or size[0] > size[1:].sum():
            return []
        result: list[Crossing] = []
        roots = np.polynomial.chebyshev.chebroots(np.trim_zeros(coefficients, "b"))
        slope: FloatArray = np.polynomial.chebyshev.chebder(coefficients).astype(np.float64)
        real = np.sort(roots.real[(np.abs(roots.imag) < 1e-6) & (np.abs(roots.real) <= 1)])
        for x in real.tolist():
            time = middle + half * self._polish(series, integrator, middle, half, x, slope)
            if result and time - result[-1].time <= 2e-12 * half:
                continue
            # a start on the section does not count as a return to it
            if time <= max([self._first_time, *(c.time for c in self.crossings[-1:])]):
                continue
            rising = bool(np.polynomial.chebyshev.chebval(x, slope) > 0)
            result.append(Crossing(time, series(np.array([time]))[0], integrator, mode, rising))
        return result

    def _values(self, series: StepSeries, integrator: ModeIntegrator, t: FloatArray) -> FloatArray:
        return self._quantity(integrator, series(t))

    def _polish(
        self,
        series: StepSeries,
        integrator: ModeIntegrator,
        middle: float,
        half: float,
        x: float,
        slope: FloatArray,
    ) -> float:
        """Refine a zero with Newton's method on the Taylor series."""
        for _ in range(_POLISH):
            value = float(self._values(series, integrator, np.array([middle + half * x]))[0])
            rate = float(np.polynomial.chebyshev.chebval(x, slope))
            change = value / rate if rate else 0.0
            x = min(max(x - change, -1.0), 1.0)
            if abs(change) < 1e-15:
                break
        return x
