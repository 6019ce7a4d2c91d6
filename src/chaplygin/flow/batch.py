"""Many motions of a System at once, as machine code with a lane for each.

The result of a motion depends on its own start and parameters alone, to the bit: not on the
number of threads, the width of the processor's vectors, or the motions computed beside it.
"""

from __future__ import annotations

import ctypes
import itertools
import math
import os
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from contextvars import ContextVar
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from numbers import Integral, Real
from typing import Any, Literal

import numpy as np

from ..arguments import arguments_checked
from ..core.system import System
from ..errors import InputError
from ..formulas.evaluate import as_float_array, relation_terms
from ..formulas.graph import Term
from .cost import TooMuchError
from .initial_states import reduced_rows
from .kernel import jit as native
from .kernel.arithmetic import Double, Pair
from .kernel.double_double import paired, parameter_pairs
from .kernel.equations import Equations, Section, equations_of, poincare_section, serial
from .kernel.runge_kutta import STATUS_MESSAGES, STEPS, runge_kutta_loop
from .kernel.tableaux import explicit, explicit_fine
from .validation import check_state_shape, moments as read_moments, require_on_phase_space

__all__ = [
    "THREADS",
    "BatchCrossings",
    "BatchIntegrator",
    "BatchTrajectories",
    "Section",
    "available_threads",
    "batch_integrator",
    "poincare_section",
    "reason",
]

#: Numbers that one call may give back.
MOST_NUMBERS = 1 << 32

#: Attempted steps after which a motion is given up.
MOST_STEPS = 100_000_000

#: Steps by which the length of others is estimated.
FEW_STEPS = 2_000


@dataclass(frozen=True)
class BatchTrajectories:
    """Motions at given times.

    Attributes
    ----------
    states : array (motions, times, size)
        In flat order; not-a-number after the end of a motion.
    deviations : array (motions, times, deviations, size) or None
    outcome : array (motions,) of int
        0 where the last time was reached; else see :meth:`BatchIntegrator.reason`.
    ended : array (motions,)
        The time that was reached.
    steps : array (motions,) of int
        Steps that were tried.
    rest : array (motions, times, size) or None
        With 30 digits, what is to be added to the states: their next 16 digits.
    """

    states: Any
    deviations: Any
    outcome: Any
    ended: Any
    steps: Any
    rest: Any = None


@dataclass(frozen=True)
class BatchCrossings:
    """Motions where they cross a section.

    Attributes
    ----------
    states : array (motions, count, size)
        Not-a-number beyond `counts`.
    times : array (motions, count)
    deviations : array (motions, count, deviations, size) or None
        At the time of crossing; not yet projected along the flow.
    counts : array (motions,) of int
        Crossings found.
    outcome, ended, steps, rest
        As in `BatchTrajectories`; the outcome is 0 where all crossings were found.
    """

    states: Any
    times: Any
    deviations: Any
    counts: Any
    outcome: Any
    ended: Any
    steps: Any
    rest: Any = None


_I, _P, _D = ctypes.c_int64, ctypes.c_void_p, ctypes.c_double
_SIGNATURE = (_I, _I, _P, _P, _I, _P, _I, _D, _I, _P, _P, _P, _P, _P, _P, _P)


@dataclass(frozen=True)
class BatchIntegrator:
    """The flow of a System as vector code.

    Attributes
    ----------
    system : System
    tolerance : float
        Error allowed in a step, relative to the size of each vector of the state.
    deviations : int
        Tangent vectors carried by the variational equations.
    section : Section or None
    backward : bool
        Whether time runs backward; times are negative then.
    digits : 16 or 30
    code : Native
    """

    system: System
    tolerance: float
    deviations: int
    section: Section | None
    backward: bool
    digits: int
    code: native.Native = field(repr=False)

    @property
    def size(self) -> int:
        """State variables of the system."""
        return len(self.system.symbols)

    def reason(self, code: int) -> str:
        """What an outcome means, in words; nothing for 0."""
        return reason(self.system, code)

    def until(
        self,
        starts: Any,
        times: Any,
        parameters: Mapping[Any, Any] | None = None,
        *,
        deviations: Any = None,
        threads: int | None = None,
    ) -> BatchTrajectories:
        """Motions from time 0 through given times.

        Parameters
        ----------
        starts : array (motions, size)
            In flat order of ``system.symbols``; with 30 digits numbers of many digits (mpmath)
            count with 32 of them, here and in `parameters`.
        times : array (times,)
            Increasing from 0 or later; decreasing for backward lanes.
        parameters : mapping of Symbol or name to number or array (motions,), optional
            Values that replace the defaults, one for all or one for each.
        deviations : array (motions, deviations, size), optional
            Needed if the lanes carry deviations.
        threads : int, optional
            All processors that this process may use, unless given.

        Raises
        ------
        InputError
            If starts, times or parameters cannot be used.
        """
        if self.section is not None:
            raise InputError("these lanes stop at a section: ask for returns instead of times")
        moments = read_moments(times, self.backward)
        rows, constants = self._rows(starts, parameters, deviations)
        found, _, _, ends = self._call(rows, constants, moments, len(moments), threads)
        states, tangents, rest = self._parted(found)
        return BatchTrajectories(states, tangents, *ends, rest)

    def returns(
        self,
        starts: Any,
        count: int,
        parameters: Mapping[Any, Any] | None = None,
        *,
        until: float = np.inf,
        deviations: Any = None,
        threads: int | None = None,
    ) -> BatchCrossings:
        """Crossings of the section; a start that lies on it is not one.

        Two crossings within one step are told apart where a cubic through its ends shows both.

        Parameters
        ----------
        starts, parameters, deviations, threads
            As in :meth:`until`.
        count : int
            Crossings wanted of each motion.
        until : float
            Time after which to give up; negative for backward lanes.

        Raises
        ------
        InputError
            If starts, count or parameters cannot be used.
        """
        if self.section is None:
            raise InputError("these lanes have no section: make them with one")
        _require_count(count)
        end = np.array([-until if self.backward and until < 0 else until], dtype=float)
        if not end[0] > 0:
            raise InputError(f"until = {until}: it must lie ahead of the start, at time 0")
        rows, constants = self._rows(starts, parameters, deviations)
        found, moments, counts, ends = self._call(rows, constants, end, count, threads)
        states, tangents, rest = self._parted(found)
        return BatchCrossings(states, self._signed(moments), tangents, counts, *ends, rest)

    def require_reach(
        self, start: Any, until: float, parameters: Mapping[Any, Any] | None = None
    ) -> None:
        """Refuse a time that a motion does not reach before it is given up.

        Parameters
        ----------
        start : array (size,)
        until : float
        parameters : mapping of Symbol or name to number, optional

        Raises
        ------
        TooMuchError
            With an estimate of the steps, from the first of them.
        """
        rows, constants = self._rows([start], parameters, None)
        end = np.array([abs(until)])
        _, _, _, (outcome, ended, steps) = self._call(rows, constants, end, 1, 1, FEW_STEPS)
        require_steps(until, outcome[0], ended[0], steps[0])

    # --- what goes in and comes out ------------------------------------------------------------

    def _signed(self, moments: Any) -> Any:
        return -moments if self.backward else moments

    def _rows(
        self, starts: Any, parameters: Mapping[Any, Any] | None, deviations: Any
    ) -> tuple[Any, Any]:
        given = reduced_rows(self.system, self._words("starts", starts))
        points = given[..., 0]
        check_state_shape(self.system, points)
        constants = parameter_pairs(self.system, parameters, len(points))[..., : self.words]
        require_on_phase_space(self.system, self._relations, points, constants[..., 0])
        if self.deviations == 0:
            if deviations is not None:
                raise InputError("these lanes carry no deviations: make them with some")
            return np.ascontiguousarray(given), np.ascontiguousarray(constants)
        wanted = (len(points), self.deviations, self.size)
        tangents = self._words("deviations", deviations)
        if tangents.shape[:-1] != wanted:
            shape = tangents.shape[:-1]
            raise InputError(f"deviations have the shape {shape}; {wanted} is needed")
        beside = tangents.reshape(len(points), -1, self.words)
        rows = np.concatenate([given, beside], axis=1)
        return np.ascontiguousarray(rows), np.ascontiguousarray(constants)

    @cached_property
    def _relations(self) -> tuple[Term, ...]:
        return relation_terms(self.system)

    @property
    def words(self) -> int:
        """Doubles that a number takes."""
        return 1 if self.digits == 16 else 2

    def _words(self, name: str, numbers: Any) -> Any:
        """Numbers with a last axis for the doubles of each."""
        if self.digits == 16:
            return as_float_array(name, numbers)[..., None]
        return paired(name, numbers)

    def _parted(self, found: Any) -> tuple[Any, Any, Any]:
        """States, deviations and the rest of the states, of (motions, times, numbers, words)."""
        states = found[:, :, : self.size, 0]
        rest = found[:, :, : self.size, 1] if self.words == 2 else None
        if self.deviations == 0:
            return states, None, rest
        shape = (*found.shape[:2], self.deviations, self.size)
        return states, found[:, :, self.size :, 0].reshape(shape), rest

    def _call(
        self,
        rows: Any,
        constants: Any,
        moments: Any,
        wanted: int,
        threads: int | None,
        most: int | None = None,
    ) -> tuple[Any, Any, Any, tuple[Any, Any, Any]]:
        number, width, words = rows.shape
        if number * wanted * width * words > MOST_NUMBERS:
            size = number * wanted * width * words * 8 / 2**30
            raise InputError(
                f"{number} motions with {wanted} states each make {size:.3g} GiB at once: ask for "
                "fewer, or stream them (docs/ensembles.md)"
            )
        states = np.full((number, wanted, width, words), np.nan)
        times = np.full((number, wanted), np.nan)
        counts, outcome, steps = (np.zeros(number, dtype=np.int64) for _ in range(3))
        ended = np.zeros(number)
        stride = constants[0].size if len(constants) > 1 else 0
        arrays = (rows, constants, moments)
        results = (states, times, counts, outcome, ended, steps)

        def part(first: int, last: int) -> None:
            work = native.aligned(self.code.room)
            self.code.functions["march"](
                *(first, last, arrays[0].ctypes.data, arrays[1].ctypes.data, stride),
                *(
                    arrays[2].ctypes.data,
                    wanted,
                    self.tolerance,
                    MOST_STEPS if most is None else most,
                ),
                *(result.ctypes.data for result in results),
                work.ctypes.data,
            )

        workers = available_threads() if threads is None else threads
        run_in_threads(part, number, workers)
        return states, times, counts, (outcome, self._signed(ended), steps)


def require_steps(until: float, outcome: int, ended: float, steps: int) -> None:
    """Refuse a time that needs more steps than are allowed, to go by the first few of them.

    Parameters
    ----------
    until : float
        The time.
    outcome, ended, steps
        Of a motion that was given few steps.

    Raises
    ------
    TooMuchError
        With the estimate.
    """
    if outcome != STEPS:
        return
    needed = steps * abs(until) / abs(float(ended)) if ended else math.inf
    if needed > MOST_STEPS:
        raise TooMuchError(
            f"to follow a motion for {until:g} s would take about {needed:.1g} steps, and it is "
            f"given up after {MOST_STEPS:.0e}: follow it for a shorter time"
        )


#: Threads that a part of a program may use at most; set by what runs several such parts at once.
THREADS: ContextVar[int] = ContextVar("THREADS", default=2**31)


def reason(system: System, code: int) -> str:
    """What the outcome of a motion means, in words; nothing for 0."""
    return (
        STATUS_MESSAGES[code]
        if code < len(STATUS_MESSAGES)
        else system.guards[code - len(STATUS_MESSAGES)].message
    )


def available_threads() -> int:
    """Processors that this part of the program may use."""
    if hasattr(os, "sched_getaffinity"):
        there = len(os.sched_getaffinity(0))
    else:
        there = os.cpu_count() or 1
    return min(there, THREADS.get())


def run_in_threads(part: Any, number: int, threads: int) -> None:
    """Do parts [first, last) of a number of motions in some threads."""
    # few motions are done sooner than a thread begins
    pieces = 1 if threads == 1 else min(4 * threads, number // 32)
    edges = np.linspace(0, number, max(pieces, 1) + 1).astype(int)
    if len(edges) == 2:
        part(0, number)
        return
    with ThreadPoolExecutor(threads) as pool:
        jobs = [pool.submit(part, int(a), int(b)) for a, b in itertools.pairwise(edges)]
        for job in jobs:
            job.result()


@lru_cache(maxsize=64)
@arguments_checked
def batch_integrator(
    system: System,
    *,
    tolerance: float = 1e-13,
    deviations: int = 0,
    section: Section | None = None,
    backward: bool = False,
    digits: Literal[16, 30] = 16,
) -> BatchIntegrator:
    """The flow of a system as vector code for this processor, from the cache where it is there.

    Parameters
    ----------
    system : System
        As it is to be integrated; ``system.lifted()`` carries its motion in space along.
    tolerance : float
        Error allowed in a step, relative to the size of each vector of the state.
    deviations : int
        Tangent vectors to carry by the variational equations.
    section : Section, optional
        Where the motions are looked at, instead of at given times.
    backward : bool
        Whether time runs backward.
    digits : 16 or 30
        Of the numbers that the lanes compute with.  With 30 a step costs some twenty times as much,
        and a method of order 8 needs very many steps to make use of them all: for single motions
        see :mod:`chaplygin.flow.gauss`.

    Returns
    -------
    BatchIntegrator
        ``until(starts, times)`` gives states (motions, times, size) at given times, and
        ``returns(starts, count)`` states (motions, count, size) on the section, both for starts
        (motions, size) in flat order.

    Raises
    ------
    InputError
        If a section is asked for with 30 digits, the tolerance is not between 1e-16 (1e-30 with 30
        digits) and 0.1, a formula has a function that machine code does not know, or the number of
        deviations is negative.

    Examples
    --------
    >>> import chaplygin as ch
    >>> ball = ch.from_catalogue("unbalanced-ball")
    >>> starts = ch.sample_level(ball, 100, {"energy": 2.0}, seed=1)
    >>> motions = ch.batch_integrator(ball).until(starts, [5.0, 10.0])
    >>> motions.states.shape, int((motions.outcome == 0).sum())
    ((100, 2, 6), 100)
    """
    _require_numbers(tolerance, deviations)
    if digits not in (16, 30):
        raise InputError(f"digits = {digits}: lanes compute with 16 or with 30 digits")
    if digits == 30 and section is not None:
        raise InputError(f"{system.name}: a section is found to 16 digits; leave 'digits' at that")
    finest = 1e-16 if digits == 16 else 1e-30
    if not finest <= tolerance <= 0.1:
        raise InputError(f"tolerance {tolerance}: it must lie between {finest:g} and 0.1")
    if deviations < 0:
        raise InputError(f"deviations = {deviations}: there cannot be fewer than none")
    equations = equations_of(system, deviations, section, backward)
    width = native.width()
    code = native.load_code(
        f"march {width} {digits} {serial(equations)}",
        lambda: _text(digits, equations, width),
        {"march": _SIGNATURE},
    )
    return BatchIntegrator(system, tolerance, deviations, section, backward, digits, code)


def _require_count(count: Any) -> None:
    if not isinstance(count, Integral) or count < 1:
        raise InputError(f"count = {count}: it must be a whole number, at least 1")


def _require_numbers(tolerance: Any, deviations: Any) -> None:
    if not isinstance(tolerance, Real):
        raise InputError(f"tolerance {tolerance}: it must be a number")
    if not isinstance(deviations, Integral):
        raise InputError(f"deviations = {deviations}: it must be a whole number")


def _text(digits: int, equations: Equations, width: int) -> tuple[str, int]:
    if digits == 16:
        return runge_kutta_loop(Double, explicit(), equations, width)
    return runge_kutta_loop(Pair, explicit_fine(), equations, width)
