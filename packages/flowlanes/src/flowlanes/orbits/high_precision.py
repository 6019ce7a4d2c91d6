"""Periodic orbits of a System to 30 digits.

Newton's method with derivatives in doubles and residuals to 30 digits: starting from an orbit in
doubles, each step adds about thirteen digits.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import mpmath
import numpy as np
import numpy.typing as npt
import sympy as sp

from ..arguments import arguments_checked
from ..flow.batch import batch_integrator
from ..flow.gauss import gauss_integrator
from ..flow.machine_code.double_double_conversion import from_pairs
from ..formulas.multiprecision import slopes
from ..system.arrays import FloatArray
from .maps import normalised_functions
from .periodic import NoOrbitError, Orbit, held_values, minimal_norm_step, periodic_difference
from .return_map import ReturnMap

#: Digits of mpmath; maximum number of steps; relative step size at convergence.
_DIGITS, _STEPS, _REST = 36, 8, 1e-29


@dataclass(frozen=True)
class RefinedOrbit:
    """A periodic orbit with 30 digits.

    Attributes
    ----------
    point : list of mpf
        Its first point on the section, in flat order.
    duration : mpf
    error : float
        The last step of Newton's method, in units of the state.
    """

    point: list[mpmath.mpf]
    duration: mpmath.mpf
    error: float


@arguments_checked
def refine_orbit(
    section_map: ReturnMap, orbit: Orbit, hold: Mapping[str, float] | Iterable[str] = ()
) -> RefinedOrbit:
    """Refine an orbit to 30 digits.

    Parameters
    ----------
    section_map : ReturnMap
        The map for which it was found; a float is taken as the exact value of the double.
    orbit : Orbit
    hold : mapping of str to float, or names
        As for the search; integrals held by name keep their double value on the orbit.

    Returns
    -------
    RefinedOrbit
        Points and duration (s) with 30 digits.

    Raises
    ------
    NoOrbitError
        If the iteration does not converge.

    Examples
    --------
    >>> import flowlanes
    >>> import mpmath
    >>> import numpy as np
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> oscillator = flowlanes.System("van-der-pol", "Van der Pol", {x: v, v: (1 - x**2) * v - x})
    >>> section = flowlanes.PoincareMap(oscillator, flowlanes.poincare_section(oscillator, "x"))
    >>> returns = flowlanes.orbits.ReturnMap(section)
    >>> orbit = flowlanes.orbits.find_periodic(returns, np.array([0.0, 2.17]))
    >>> refined = flowlanes.orbits.refine_orbit(returns, orbit)
    >>> print(mpmath.nstr(refined.duration, 25))
    6.663286859323130189699682
    """
    values = held_values(section_map, orbit.points[0], hold)
    sizes = np.append(section_map.sizes(orbit.points[:1]), orbit.duration)
    problem = _Problem(section_map, values, sizes)
    with mpmath.workdps(_DIGITS):
        point = [mpmath.mpf(float(x)) for x in orbit.points[0]]
        duration = mpmath.mpf(orbit.duration)
        last = np.inf
        for _ in range(_STEPS):
            step = problem.step(point, duration)
            size = float(np.abs(step / sizes).max())
            # Convergence is linear with a factor of about 1e-13, so a step that does not halve is
            # noise.
            if size > last / 2:
                break
            point = [x + mpmath.mpf(float(s)) for x, s in zip(point, step[:-1], strict=True)]
            duration += mpmath.mpf(float(step[-1]))
            last = size
            if size < _REST:
                break
        if last > 1e-20:
            raise NoOrbitError("the orbit could not be refined beyond doubles", orbit.points)
        return RefinedOrbit(point, duration, last)


@dataclass(frozen=True)
class _Problem:
    """The equations of an orbit: closure, relations, section and held integrals.

    Point and duration are in units of `sizes`.
    """

    section_map: ReturnMap
    held_integrals: Mapping[str, float]
    sizes: FloatArray

    def step(self, point: list[mpmath.mpf], duration: mpmath.mpf) -> FloatArray:
        """The minimum-norm Newton step of point and duration, in doubles."""
        section = self.section_map.section
        system, size = section.system, section.size
        parameters = section.parameters
        rough = np.array([float(x) for x in point])
        whole = float(duration)
        flow = gauss_integrator(system, rough, parameters, precision="quad")
        motion = flow.propagate(np.array([point], dtype=object), [whole], parameters)
        end = from_pairs(motion.states[0, 0], motion.rest[0, 0])
        if motion.outcome[0] != 0:
            raise NoOrbitError(flow.status_message(int(motion.outcome[0])), rough[None])
        moved = batch_integrator(system, deviations=size).propagate(
            rough[None], [whole], parameters, deviations=np.eye(size)[None]
        )
        (rates, _) = self._numbers(system.rates, end)
        remainder = duration - mpmath.mpf(whole)
        # Correct by the flow for the part of the duration beyond double precision.
        misses = [e + remainder * r - x for e, r, x in zip(end, rates, point, strict=True)]
        turns = periodic_difference(np.array([float(m) for m in misses]), self.section_map.periods)[
            1
        ]
        whole_turns = [
            mpmath.mpf(0) if t == 0 else int(t) * self._period(i) for i, t in enumerate(turns)
        ]
        gaps = [float(m - t) for m, t in zip(misses, whole_turns, strict=True)]
        sizes = self.sizes[:-1]
        excess, rows = normalised_functions(*self._levels(point), sizes)
        # The residual e(T) − x has the derivative S − 1 by the point and v by the duration.
        closing = np.column_stack(
            [np.asarray(moved.deviations)[0, 0].T - np.eye(size), [float(r) for r in rates]]
        )
        ends = closing * self.sizes / sizes[:, None]
        matrix = np.vstack([ends, np.column_stack([rows, np.zeros(len(rows))])])
        return minimal_norm_step(matrix, np.concatenate([gaps / sizes, excess])) * self.sizes

    def _period(self, index: int) -> mpmath.mpf:
        """A period to all digits if it is 2π."""
        period = float(self.section_map.periods[index])
        return 2 * mpmath.pi if period == 2 * np.pi else mpmath.mpf(period)

    def _levels(self, point: list[mpmath.mpf]) -> tuple[FloatArray, FloatArray]:
        """Relations, section and held integrals minus their values, with derivatives."""
        section = self.section_map.section
        laws = {law.name: law.value for law in section.system.scalar.integrals}
        wanted = [
            *section.system.scalar.relations,
            section.section.value,
            *(laws[n] for n in self.held_integrals),
        ]
        values, rows = self._numbers(wanted, point)
        targets = [0.0] * (len(wanted) - len(self.held_integrals)) + list(
            self.held_integrals.values()
        )
        excess = [float(v - mpmath.mpf(t)) for v, t in zip(values, targets, strict=True)]
        slopes = [[float(rows[i, j]) for j in range(len(point))] for i in range(len(wanted))]
        return np.array(excess), np.array(slopes)

    def _numbers(
        self, formulas: Sequence[sp.Expr], point: Sequence[mpmath.mpf] | npt.NDArray[np.object_]
    ) -> tuple[mpmath.matrix, mpmath.matrix]:
        """Formulas and their derivatives to all digits."""
        section = self.section_map.section
        parameters = {str(name): value for name, value in section.parameters.items()}
        constants = {
            s: mpmath.mpmathify(parameters.get(str(s), default))
            for s, default in section.system.defaults.items()
        }
        symbols = section.system.symbols
        values = dict(zip(symbols, point, strict=True)) | constants
        return slopes(section.system, formulas, symbols, values)
