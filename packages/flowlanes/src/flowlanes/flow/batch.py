"""Many motions of a System at once: machine code with one motion per vector lane.

The result for a motion depends, bit for bit, only on its own start and parameters: not on the
number of threads, the vector width of the processor, or other motions computed with it.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from numbers import Integral, Real

import numpy as np
import numpy.typing as npt

from ..arguments import Parameters, arguments_checked
from ..errors import InputError
from ..formulas.array_evaluation import as_float_array, relation_terms
from ..formulas.graph import Term
from ..system.arrays import FloatArray, IntArray
from ..system.system import System
from ..system.tolerance import ENSEMBLE_TOLERANCE, FINEST_TOLERANCE, Precision
from .batch_results import BatchCrossings, BatchTrajectories
from .cost import FEW_STEPS, MOST_STEPS, require_steps
from .devices.batch_arrays import BatchInput, BatchLoop
from .devices.graphics import Device, graphics_loop
from .devices.processor import processor_loop
from .initial_states import reduced_rows
from .kernel.equations import Section, equations_of
from .kernel.outcomes import outcome_message
from .machine_code.double_double_conversion import as_pairs, parameter_pairs
from .validation import check_state_shape, moments as read_moments, require_on_phase_space

#: Largest number of values that one call may return; it bounds memory use.
MOST_NUMBERS = 1 << 32


@dataclass(frozen=True)
class BatchIntegrator:
    """Flow of a System as vectorized machine code.

    Attributes
    ----------
    system : System
    tolerance : float
        See :mod:`flowlanes.system.tolerance`.
    deviations : int
        Number of tangent vectors in the variational equations.
    section : Section or None
    backward : bool
        True if time runs backward; then times are negative.
    precision : ``"double"`` or ``"quad"``
    loop : BatchLoop
        Code for the chosen device.
    """

    system: System
    tolerance: float
    deviations: int
    section: Section | None
    backward: bool
    precision: Precision
    loop: BatchLoop = field(repr=False)

    @property
    def size(self) -> int:
        """Number of state variables of the system."""
        return len(self.system.symbols)

    @arguments_checked
    def status_message(self, code: int) -> str:
        """Reason for which a motion ended; empty for code 0."""
        return outcome_message(self.system, code)

    @arguments_checked
    def propagate(
        self,
        starts: npt.ArrayLike,
        times: npt.ArrayLike,
        parameters: Parameters = None,
        *,
        deviations: npt.ArrayLike | None = None,
        threads: int | None = None,
    ) -> BatchTrajectories:
        """Motions from time 0 through given times.

        Parameters
        ----------
        starts : array (motions, size)
            In flat order of ``system.symbols``; in quad precision numbers of many digits (mpmath)
            are used with 32 digits, here and in `parameters`.
        times : array (times,)
            Increasing from 0 or later; decreasing for backward lanes.
        parameters : mapping of Symbol or name to number or array (motions,), optional
            Values that replace the defaults, one for all motions or one for each motion.
        deviations : array (motions, deviations, size), optional
            Required if the integrator has deviations.
        threads : int, optional
            Number of threads; by default all processors available to this process.

        Raises
        ------
        InputError
            If starts, times or parameters are not valid.
        """
        if self.section is not None:
            raise InputError(
                "this integrator was built for a section: call crossings instead of propagate"
            )
        moments = read_moments(times, self.backward)
        rows, constants = self._rows(starts, parameters, deviations)
        numbers, _, _, ends = self._call(rows, constants, moments, len(moments), threads)
        states, tangents, low = self._split(numbers)
        return BatchTrajectories(states, tangents, *ends, low)

    @arguments_checked
    def crossings(
        self,
        starts: npt.ArrayLike,
        count: int,
        parameters: Parameters = None,
        *,
        t_end: float = np.inf,
        deviations: npt.ArrayLike | None = None,
        threads: int | None = None,
    ) -> BatchCrossings:
        """Motions up to their crossings of the section; a start on the section is not counted.

        Two crossings within one step are detected if the cubic interpolant of the step indicates
        them within its error, that is down to a separation of about 1e-5 turns.

        Parameters
        ----------
        starts, parameters, deviations, threads
            As in :meth:`propagate`.
        count : int
            Number of crossings for each motion.
        t_end : float
            Time after which a motion ends in any case; negative for backward integration.

        Raises
        ------
        InputError
            If starts, count or parameters are not valid.
        """
        if self.section is None:
            raise InputError(
                "this integrator was built without a section; pass section=… to batch_integrator"
            )
        _require_count(count)
        end = np.array([-t_end if self.backward and t_end < 0 else t_end], dtype=float)
        if not end[0] > 0:
            raise InputError(f"t_end = {t_end}: it must lie ahead of the start, at time 0")
        rows, constants = self._rows(starts, parameters, deviations)
        numbers, moments, counts, ends = self._call(rows, constants, end, count, threads)
        states, tangents, low = self._split(numbers)
        return BatchCrossings(states, self._with_sign(moments), tangents, counts, *ends, low)

    @arguments_checked
    def require_reach(
        self, start: npt.ArrayLike, t_end: float, parameters: Parameters = None
    ) -> None:
        """Raise an error if a time needs more than the maximum number of steps.

        Parameters
        ----------
        start : array (size,)
        t_end : float
        parameters : mapping of Symbol or name to number, optional

        Raises
        ------
        TooMuchError
            With an estimate from the first steps.
        """
        rows, constants = self._rows(np.asarray(start)[np.newaxis], parameters, None)
        end = np.array([abs(t_end)])
        _, _, _, (outcome, ended, steps) = self._call(rows, constants, end, 1, 1, FEW_STEPS)
        require_steps(t_end, outcome[0], ended[0], steps[0])

    # --- arguments and results of the machine code ----------------------------------------------

    def _with_sign(self, moments: FloatArray) -> FloatArray:
        return -moments if self.backward else moments

    def _rows(
        self,
        starts: npt.ArrayLike,
        parameters: Parameters,
        deviations: npt.ArrayLike | None,
    ) -> tuple[FloatArray, FloatArray]:
        """Initial values with deviations (motions, numbers, words), and parameters in words."""
        words = reduced_rows(self.system, self._as_doubles("starts", starts))
        points = words[..., 0]
        check_state_shape(self.system, points)
        constants = parameter_pairs(self.system, parameters, len(points))[..., : self.words]
        require_on_phase_space(self.system, self._relations, points, constants[..., 0])
        if self.deviations == 0:
            if deviations is not None:
                raise InputError(
                    "this integrator carries no deviations; pass deviations=… to batch_integrator"
                )
            return np.ascontiguousarray(words), np.ascontiguousarray(constants)
        needed = (len(points), self.deviations, self.size)
        tangents = self._as_doubles("deviations", np.asarray(deviations))
        if tangents.shape[:-1] != needed:
            shape = tangents.shape[:-1]
            raise InputError(f"deviations have the shape {shape}; {needed} is needed")
        columns = tangents.reshape(len(points), -1, self.words)
        rows = np.concatenate([words, columns], axis=1)
        return np.ascontiguousarray(rows), np.ascontiguousarray(constants)

    @cached_property
    def _relations(self) -> tuple[Term, ...]:
        return relation_terms(self.system)

    @property
    def words(self) -> int:
        """Number of doubles that represent one number."""
        return 1 if self.precision == "double" else 2

    def _as_doubles(self, name: str, numbers: npt.ArrayLike) -> FloatArray:
        """Numbers with a last axis for the doubles of each number."""
        if self.precision == "double":
            words: FloatArray = as_float_array(name, numbers)[..., None]
            return words
        return as_pairs(name, numbers)

    def _split(
        self, numbers: FloatArray
    ) -> tuple[FloatArray, FloatArray | None, FloatArray | None]:
        """States, deviations and low words of the states, from the result of the loop."""
        states = numbers[:, :, : self.size, 0]
        low = numbers[:, :, : self.size, 1] if self.words == 2 else None
        if self.deviations == 0:
            return states, None, low
        shape = (*numbers.shape[:2], self.deviations, self.size)
        return states, numbers[:, :, self.size :, 0].reshape(shape), low

    def _call(
        self,
        rows: FloatArray,
        constants: FloatArray,
        moments: FloatArray,
        samples: int,
        threads: int | None,
        most: int | None = None,
    ) -> tuple[FloatArray, FloatArray, IntArray, tuple[IntArray, FloatArray, IntArray]]:
        """Samples, sample counts, outcomes, end times and step counts from one call of the loop."""
        motions, width, words = rows.shape
        if motions * samples * width * words > MOST_NUMBERS:
            size = motions * samples * width * words * 8 / 2**30
            raise InputError(
                f"{motions} motions with {samples} states each make {size:.3g} GiB at once: ask "
                "for fewer, or stream them (docs/ensembles.md)"
            )
        allowed = MOST_STEPS if most is None else most
        given = BatchInput(rows, constants, moments, samples, self.tolerance, allowed, width)
        found = self.loop.run(given, threads)
        ends = (found.outcome, self._with_sign(found.end_times), found.steps)
        return found.states, found.times, found.counts, ends


@arguments_checked
@lru_cache(maxsize=64)
def batch_integrator(
    system: System,
    *,
    tolerance: float = ENSEMBLE_TOLERANCE,
    deviations: int = 0,
    section: Section | None = None,
    backward: bool = False,
    precision: Precision = "double",
    device: Device = "cpu",
) -> BatchIntegrator:
    """Compile the flow of a system to machine code for many motions at once.

    Parameters
    ----------
    system : System
        The system to integrate; ``system.lifted()`` includes its motion in space.
    tolerance : float
        See :mod:`flowlanes.system.tolerance`; the error is relative to the size of each vector of
        the state.  Below 1e-15 another method of the same order is used, which is less sensitive
        to rounding.
    deviations : int
        Number of tangent vectors in the variational equations.
    section : Section, optional
        Section whose crossings are recorded, instead of states at given times.
    backward : bool
        Whether time runs backward.
    precision : ``"double"`` or ``"quad"``
        Precision of the computation: 16 digits, or 30 digits with pairs of doubles.  With 30
        digits a step takes about twenty times as long, and a method of order 8 needs very many
        steps to use all of them; for single motions see :mod:`flowlanes.flow.gauss`.
    device : "cpu" or "gpu"
        Device for the computation.

    Returns
    -------
    BatchIntegrator
        ``propagate(starts, times)`` gives states (motions, times, size) at given times, and
        ``crossings(starts, count)`` states (motions, count, size) on the section, both for starts
        (motions, size) in flat order.

    Raises
    ------
    InputError
        If there is a section in quad precision, the tolerance is not between 1e-16 (1e-30 in quad
        precision) and 0.1, a formula contains a function without machine code, the number of
        deviations is negative, or the device does not exist.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> a, b, c = sp.symbols("a b c", real=True)
    >>> energy = flowlanes.Integral("energy", a**2 + b**2 / 2 + c**2 / 3)
    >>> field = {a: -b * c, b: 4 * a * c, c: -3 * a * b}
    >>> top = flowlanes.System("top", "Euler's top", field, laws=(energy,))
    >>> starts = flowlanes.sample_level(top, 100, {"energy": 2.0}, seed=1)
    >>> motions = flowlanes.batch_integrator(top).propagate(starts, [5.0, 10.0])
    >>> motions.states.shape, int((motions.outcome == 0).sum())
    ((100, 2, 3), 100)
    """
    _require_numbers(tolerance, deviations)
    if precision == "quad" and section is not None:
        raise InputError(
            f"{system.name}: a section is found in double precision; leave 'precision' at that"
        )
    finest = FINEST_TOLERANCE[precision]
    if not finest <= tolerance <= 0.1:
        raise InputError(f"tolerance {tolerance}: it must lie between {finest:g} and 0.1")
    if deviations < 0:
        raise InputError(f"deviations = {deviations}: there cannot be fewer than none")
    equations = equations_of(system, deviations, section, backward)
    loop: BatchLoop
    if device == "gpu":
        loop = graphics_loop(equations, precision, tolerance)
    else:
        loop = processor_loop(equations, precision, tolerance)
    return BatchIntegrator(system, tolerance, deviations, section, backward, precision, loop)


def _require_count(count: object) -> None:
    if not isinstance(count, Integral) or count < 1:
        raise InputError(f"count = {count}: it must be a whole number, at least 1")


def _require_numbers(tolerance: object, deviations: object) -> None:
    if not isinstance(tolerance, Real):
        raise InputError(f"tolerance {tolerance}: it must be a number")
    if not isinstance(deviations, Integral):
        raise InputError(f"deviations = {deviations}: it must be a whole number")
