"""Single motions with all digits of a double, or with 30 digits.

The state is projected onto the level of the integrals of a System, if it has integrals.  Otherwise
the rounding errors of any method in doubles accumulate to about a hundred times more.
"""

from __future__ import annotations

import ctypes
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache

import numpy as np
import numpy.typing as npt

from ..arguments import Numbers, Parameters, arguments_checked
from ..errors import InputError
from ..formulas.array_evaluation import (
    as_float_array,
    numbers,
    parameter_rows,
    read_formulas,
    relation_terms,
)
from ..formulas.graph import Term
from ..system.arrays import FloatArray, IntArray
from ..system.overview import WithShortRepr
from ..system.system import System
from ..system.tolerance import Precision
from .cost import FEW_STEPS, MOST_STEPS, require_steps
from .devices.threads import run_in_threads
from .initial_states import reduced_rows
from .kernel.equations import equations_of, serial, serial_terms
from .kernel.gauss_legendre import gauss_loop
from .kernel.outcomes import outcome_message
from .kernel.projection_terms import projection_terms
from .kernel.tableaux import gauss
from .machine_code import jit as native
from .machine_code.double_double_conversion import as_pairs, parameter_pairs
from .sign_branches import sign_branches
from .validation import check_state_shape, moments as read_moments, require_on_phase_space

#: Number of stages, and largest allowed value of the highest Legendre coefficient of the rates
#: over a step, relative to the state.
_METHODS: dict[Precision, tuple[int, float]] = {"double": (8, 1e-7), "quad": (16, 3e-15)}

_I, _P, _D = ctypes.c_int64, ctypes.c_void_p, ctypes.c_double
_SIGNATURE = (_I, _I, _P, _P, _I, _P, _I, _D, _I, _P, _P, _P, _P, _P)


@dataclass(frozen=True, repr=False)
class GaussTrajectories(WithShortRepr):
    """Motions at given times.

    Attributes
    ----------
    states : array (motions, times, size)
        In flat order; NaN after the end of a motion.
    rest : array (motions, times, size)
        Next 16 digits of the states, to be added to them.  With 30 digits 14 of them are correct;
        with 16 digits they only give the rounding error of the last digit.
    outcome, end_times, steps : arrays (motions,)
        As in :class:`flowlanes.flow.batch.BatchTrajectories`.
    """

    states: FloatArray
    rest: FloatArray
    outcome: IntArray
    end_times: FloatArray
    steps: IntArray


@dataclass(frozen=True)
class GaussIntegrator:
    """Flow of a System by Gauss–Legendre collocation, with one lane for each stage.

    Attributes
    ----------
    system : System
    precision : ``"double"`` or ``"quad"``
    backward : bool
        True if time runs backward; then times are negative.
    held_names : tuple of str
        Integrals and relations whose values are conserved by projection.
    code : Native
    """

    system: System
    precision: Precision
    backward: bool
    held_names: tuple[str, ...]
    code: native.Native = field(repr=False)

    @cached_property
    def _relations(self) -> tuple[Term, ...]:
        return relation_terms(self.system)

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
        threads: int | None = None,
    ) -> GaussTrajectories:
        """Motions from time 0 through given times.

        Parameters
        ----------
        starts : array (motions, size)
            In flat order; numbers of many digits (mpmath) are used with 32 digits.
        times : array (times,)
            Increasing from 0 or later; decreasing backward.
        parameters : mapping of Symbol or name to number or array (motions,), optional
            Values that replace the defaults; numbers of many digits are used with 32 digits.
        threads : int, optional
            Number of threads, each for whole motions; by default all processors available to this
            process.

        Raises
        ------
        InputError
            If starts, times or parameters are not valid.
        """
        moments = read_moments(times, self.backward)
        return self._call(starts, moments, parameters, threads, MOST_STEPS)

    @arguments_checked
    def require_reach(
        self, start: npt.ArrayLike, t_end: float, parameters: Parameters = None
    ) -> None:
        """Raise an error for a time that needs more than the maximum number of steps.

        Raises
        ------
        TooMuchError
            With an estimate from the first steps.
        """
        first = np.asarray(start)[np.newaxis]
        motion = self._call(first, np.array([abs(t_end)]), parameters, 1, FEW_STEPS)
        require_steps(t_end, motion.outcome[0], motion.end_times[0], motion.steps[0])

    def _call(
        self,
        starts: npt.ArrayLike,
        moments: FloatArray,
        parameters: Parameters,
        threads: int | None,
        most: int,
    ) -> GaussTrajectories:
        rows = reduced_rows(self.system, as_pairs("starts", starts))
        size = len(self.system.symbols)
        check_state_shape(self.system, rows[..., 0])
        constants = parameter_pairs(self.system, parameters, len(rows))
        require_on_phase_space(self.system, self._relations, rows[..., 0], constants[..., 0])
        stride = constants[0].size if len(constants) > 1 else 0
        motions, samples = len(rows), len(moments)
        states = np.full((motions, samples, size, 2), np.nan)
        outcome, steps = (np.zeros(motions, dtype=np.int64) for _ in range(2))
        ended = np.zeros(motions)
        _, bound = _METHODS[self.precision]

        def compute(first: int, last: int) -> None:
            work = native.aligned_zeros(self.code.work_size)
            self.code.functions["gauss"](
                *(first, last, rows.ctypes.data, constants.ctypes.data, stride),
                *(moments.ctypes.data, samples, bound, most),
                *(a.ctypes.data for a in (states, outcome, ended, steps, work)),
            )

        run_in_threads(compute, motions, threads)
        ended = -ended if self.backward else ended
        return GaussTrajectories(states[..., 0], states[..., 1], outcome, ended, steps)


@arguments_checked
def gauss_integrator(
    system: System,
    start: Numbers,
    parameters: Parameters = None,
    precision: Precision = "double",
    *,
    backward: bool = False,
) -> GaussIntegrator:
    """Compile the flow of a system for Gauss–Legendre collocation, or read it from the cache.

    Parameters
    ----------
    system : System
        The system to integrate; ``system.lifted()`` includes its motion in space.
    start : array (size,)
        State near which the motions begin.  A stated integral that is not constant near it is not
        conserved.
    parameters : mapping of Symbol or name to number, optional
    precision : ``"double"`` or ``"quad"``
        16 or 30 digits.  In quad precision the initial state is not projected onto a level.
    backward : bool
        True if time runs backward.

    Returns
    -------
    GaussIntegrator
        ``propagate(starts, times)`` gives states (motions, times, size) for starts (motions, size)
        in flat order.

    Raises
    ------
    InputError
        If the precision is not one of these, or a rate contains an absolute value or a sign of a
        variable expression, or a function without machine code.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> a, b, c = sp.symbols("a b c", real=True)
    >>> energy = flowlanes.Integral("energy", a**2 + b**2 / 2 + c**2 / 3)
    >>> field = {a: -b * c, b: 4 * a * c, c: -3 * a * b}
    >>> top = flowlanes.System("top", "Euler's top", field, laws=(energy,))
    >>> starts = flowlanes.sample_level(top, 1, {"energy": 2.0}, seed=1)
    >>> there = flowlanes.gauss_integrator(top, starts[0]).propagate(starts, [10.0]).states[:, -1]
    >>> back = (
    ...     flowlanes.gauss_integrator(top, there[0], backward=True)
    ...     .propagate(there, [-10.0])
    ...     .states[:, -1]
    ... )
    >>> bool(abs(back - starts).max() < 1e-13)
    True
    """
    if sign_branches(replace(system, guards=())) is not None:
        raise InputError(
            f"{system.name}: collocation takes smooth equations alone, not absolute values or "
            "signs; integrate with method 'taylor'"
        )
    point = reduced_rows(system, as_float_array("start", start)[np.newaxis])[0]
    if point.shape != (len(system.symbols),):
        order = ", ".join(map(str, system.symbols))
        raise InputError(
            f"{system.name}: the start has the shape {point.shape}; one state is needed, {order}"
        )
    if not np.isfinite(point).all():
        raise InputError(f"{system.name}: all numbers of the start must be finite")
    constants = parameter_rows(system, parameters, 1)[0]
    names = () if precision == "quad" else _conserved_names(system, tuple(point), tuple(constants))
    return _compiled_integrator(system, precision, backward, names)


@lru_cache(maxsize=64)
def _compiled_integrator(
    system: System, precision: Precision, backward: bool, names: tuple[str, ...]
) -> GaussIntegrator:
    equations = equations_of(system, 0, None, backward)
    reader, _ = read_formulas(system)
    terms = dict(_integrals_and_relations(system))
    projection = None
    if names:
        projection = projection_terms(
            reader.graph,
            [terms[name] for name in names if not name.startswith("=")],
            [terms[name[1:]] for name in names if name.startswith("=")],
            equations.groups,
            # the integrals are stored after the state
            [reader.graph.state(len(system.symbols) + k) for k in range(len(names))],
        )
    stages, _ = _METHODS[precision]
    levels = serial_terms([terms[name.lstrip("=")] for name in names])
    key = f"gauss {stages} {precision} {serial(equations)} {names} {levels}"
    code = native.load_code(
        key,
        lambda: gauss_loop(gauss(stages), equations, projection, precision == "quad"),
        {"gauss": _SIGNATURE},
    )
    return GaussIntegrator(
        system, precision, backward, tuple(name.lstrip("=") for name in names), code
    )


def _integrals_and_relations(system: System) -> list[tuple[str, Term]]:
    """Integrals and relations by name."""
    reader, _ = read_formulas(system)
    integrals = [(law.name, reader(law.value)) for law in system.integrals]
    relations = [(f"relation {k + 1}", reader(r)) for k, r in enumerate(system.relations)]
    return integrals + relations


@lru_cache(maxsize=256)
def _conserved_names(
    system: System, point: tuple[float, ...], parameters: tuple[float, ...]
) -> tuple[str, ...]:
    """Names of the integrals and relations that are constant near a state.

    A relation that is constant only on its zero level is marked with "=".
    """
    reader, rates = read_formulas(system)
    graph = reader.graph
    size = len(point)
    constants = np.array(parameters)
    generator = np.random.default_rng(0)
    on_level = np.array([point])
    off_level = on_level * (1 + 0.01 * generator.normal(size=(4, size)))
    relations = {f"relation {k + 1}" for k in range(len(system.relations))}
    names = []
    for name, term in _integrals_and_relations(system):
        summands: list[Term] = []
        for i in range(size):
            unit = {graph.state(k): graph.number(int(k == i)) for k in range(size)}
            (slope,) = graph.directional_derivative([term], unit)
            summands.append(slope * rates[i])

        def constant(points: FloatArray, summands: list[Term] = summands) -> bool:
            shares = numbers(summands, points, constants)
            total, size_of = np.abs(shares.sum(axis=1)), np.abs(shares).sum(axis=1)
            return bool(np.all(total <= 1e-11 * size_of) and np.all(np.isfinite(size_of)))

        if name in relations:
            names.append(name if constant(off_level) else f"={name}")
        elif constant(on_level):
            names.append(name)
    return tuple(names)
