"""Many motions of a System at once, as machine code with a lane for each.

The result of a motion depends on its own start and parameters alone, to the bit: not on the
number of threads, the width of the processor's vectors, or the motions computed beside it.
"""

from __future__ import annotations

import ctypes
import os
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextvars import ContextVar
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
import sympy as sp

from ..errors import InputError
from ..system import System
from . import native
from .graph import Graph, Term, ordered
from .march import ENDS, Equations, march
from .simd import Double
from .tables import explicit
from .values import formula, parameter_rows, read_system, values

__all__ = ["THREADS", "Crossed", "Lanes", "Marched", "Section", "lanes", "section", "threads_here"]

#: A start may miss a relation by this much; more is refused.
SLACK = 1e-9

#: Attempted steps after which a motion is given up.
MOST_STEPS = 100_000_000


@dataclass(frozen=True)
class Section:
    """Where a motion is looked at: a function vanishes.

    Attributes
    ----------
    value : sympy.Expr
        The function, in the state, definitions and parameters.
    direction : int
        +1 where it rises through zero, −1 where it falls, 0 for both.
    where : sympy.Expr or None
        Only crossings where this is positive count.
    """

    value: Any
    direction: int = 1
    where: Any = None


def section(
    system: System, quantity: Any, value: float = 0, direction: int = 1, angle: bool = False
) -> Section:
    """The section on which a quantity has a value.

    Parameters
    ----------
    system : System
    quantity : SymPy expression or str
        See :func:`chaplygin.flow.values.formula`.
    value : float
    direction : int
        +1 where the quantity rises through the value, −1 where it falls, 0 for both.
    angle : bool
        The quantity is an angle, and has the value up to whole turns.

    Raises
    ------
    InputError
        If the quantity cannot be read or does not change, or the direction is none of the three.
    """
    if direction not in (-1, 0, 1):
        raise InputError(f"direction = {direction}: it must be 1 (rising), -1 (falling) or 0")
    difference = formula(system, quantity) - sp.sympify(value)
    reader, _ = read_system(system)
    if not any(term.kind == "state" for term in ordered([reader(difference)])):
        raise InputError(f"{system.name}: the section {quantity} = {value} contains no state")
    if angle:
        return Section(sp.sin(difference), direction, sp.cos(difference))
    return Section(difference, direction)


@dataclass(frozen=True)
class Marched:
    """Motions at given times.

    Attributes
    ----------
    states : array (motions, times, size)
        In flat order; not-a-number after the end of a motion.
    deviations : array (motions, times, deviations, size) or None
    outcome : array (motions,) of int
        0 where the last time was reached; else see :meth:`Lanes.reason`.
    ended : array (motions,)
        The time that was reached.
    steps : array (motions,) of int
        Steps that were tried.
    """

    states: Any
    deviations: Any
    outcome: Any
    ended: Any
    steps: Any


@dataclass(frozen=True)
class Crossed:
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
    outcome, ended, steps
        As in `Marched`; the outcome is 0 where all crossings were found.
    """

    states: Any
    times: Any
    deviations: Any
    counts: Any
    outcome: Any
    ended: Any
    steps: Any


_I, _P, _D = ctypes.c_int64, ctypes.c_void_p, ctypes.c_double
_SIGNATURE = (_I, _I, _P, _P, _I, _P, _I, _D, _I, _P, _P, _P, _P, _P, _P, _P)


@dataclass(frozen=True)
class Lanes:
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
    code : Native
    """

    system: System
    tolerance: float
    deviations: int
    section: Section | None
    backward: bool
    code: native.Native

    @property
    def size(self) -> int:
        """State variables of the system."""
        return len(self.system.symbols)

    def reason(self, code: int) -> str:
        """What an outcome means, in words; nothing for 0."""
        if code < len(ENDS):
            return ENDS[code]
        return self.system.guards[code - len(ENDS)].happening

    def until(
        self,
        starts: Any,
        times: Any,
        parameters: Mapping[Any, Any] | None = None,
        *,
        deviations: Any = None,
        threads: int | None = None,
    ) -> Marched:
        """Motions from time 0 through given times.

        Parameters
        ----------
        starts : array (motions, size)
            In flat order of ``system.symbols``.
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
        moments = self._moments(times)
        rows, values_rows = self._rows(starts, parameters, deviations)
        found, _, _, ends = self._call(rows, values_rows, moments, len(moments), threads)
        states, tangents = self._parted(found)
        return Marched(states, tangents, *ends)

    def returns(
        self,
        starts: Any,
        count: int,
        parameters: Mapping[Any, Any] | None = None,
        *,
        until: float = np.inf,
        deviations: Any = None,
        threads: int | None = None,
    ) -> Crossed:
        """Crossings of the section; a start that lies on it is not one.

        Two crossings within one step cancel each other unseen.

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
        if count < 1:
            raise InputError(f"count = {count}: at least one crossing must be asked for")
        end = np.array([-until if self.backward and until < 0 else until], dtype=float)
        if not end[0] > 0:
            raise InputError(f"until = {until}: it must lie ahead of the start, at time 0")
        rows, values_rows = self._rows(starts, parameters, deviations)
        found, moments, counts, ends = self._call(rows, values_rows, end, count, threads)
        states, tangents = self._parted(found)
        return Crossed(states, self._signed(moments), tangents, counts, *ends)

    # --- what goes in and comes out ------------------------------------------------------------

    def _signed(self, moments: Any) -> Any:
        return -moments if self.backward else moments

    def _moments(self, times: Any) -> Any:
        moments = self._signed(np.atleast_1d(np.asarray(times, dtype=float)))
        if moments.ndim != 1 or not moments.size or not np.all(np.isfinite(moments)):
            raise InputError("times: there must be at least one, and all finite numbers")
        if moments[0] < 0 or np.any(np.diff(moments) <= 0):
            way = "decrease from 0" if self.backward else "increase from 0"
            raise InputError(f"times: they must {way}, where the motion begins")
        return np.ascontiguousarray(moments)

    def _rows(
        self, starts: Any, parameters: Mapping[Any, Any] | None, deviations: Any
    ) -> tuple[Any, Any]:
        points = np.asarray(starts, dtype=float)
        if points.ndim != 2 or points.shape[1] != self.size:
            names = ", ".join(map(str, self.system.symbols))
            raise InputError(
                f"{self.system.name}: starts have the shape {points.shape}; (motions, {self.size}) "
                f"is needed, in the order {names}"
            )
        parameter_values = parameter_rows(self.system, parameters, len(points))
        self._require_on_phase_space(points, parameters)
        if self.deviations == 0:
            if deviations is not None:
                raise InputError("these lanes carry no deviations: make them with some")
            return np.ascontiguousarray(points), parameter_values
        wanted = (len(points), self.deviations, self.size)
        tangents = np.asarray(deviations, dtype=float)
        if tangents.shape != wanted:
            raise InputError(f"deviations have the shape {tangents.shape}; {wanted} is needed")
        rows = np.concatenate([points, tangents.reshape(len(points), -1)], axis=1)
        return np.ascontiguousarray(rows), parameter_values

    def _require_on_phase_space(self, points: Any, parameters: Mapping[Any, Any] | None) -> None:
        relations = self.system.relations
        if not relations or not len(points):
            return
        missed = np.abs(values(self.system, relations, points, parameters))
        worst = np.unravel_index(np.argmax(np.nan_to_num(missed, nan=np.inf)), missed.shape)
        if not missed[worst] <= SLACK * (1 + np.max(np.abs(points[worst[0]])) ** 2):
            raise InputError(
                f"{self.system.name}: start {worst[0]} misses the phase space; "
                f"{relations[worst[1]]} is {missed[worst]:.3g} there and must vanish"
            )

    def _parted(self, found: Any) -> tuple[Any, Any]:
        states = found[:, :, : self.size]
        if self.deviations == 0:
            return states, None
        shape = (*found.shape[:2], self.deviations, self.size)
        return states, found[:, :, self.size :].reshape(shape)

    def _call(
        self, rows: Any, parameter_values: Any, moments: Any, wanted: int, threads: int | None
    ) -> tuple[Any, Any, Any, tuple[Any, Any, Any]]:
        number, width = rows.shape
        states = np.full((number, wanted, width), np.nan)
        times = np.full((number, wanted), np.nan)
        counts, outcome, steps = (np.zeros(number, dtype=np.int64) for _ in range(3))
        ended = np.zeros(number)
        stride = parameter_values.shape[1] if len(parameter_values) > 1 else 0
        parameter_values = np.ascontiguousarray(parameter_values)
        arrays = (rows, parameter_values, moments)
        results = (states, times, counts, outcome, ended, steps)

        def part(first: int, last: int) -> None:
            work = native.aligned(self.code.room)
            self.code.functions["march"](
                *(first, last, arrays[0].ctypes.data, arrays[1].ctypes.data, stride),
                *(arrays[2].ctypes.data, wanted, self.tolerance, MOST_STEPS),
                *(result.ctypes.data for result in results),
                work.ctypes.data,
            )

        workers = threads_here() if threads is None else threads
        spread(part, number, workers)
        return states, times, counts, (outcome, self._signed(ended), steps)


#: Threads that a part of a program may use at most; set by what runs several such parts at once.
THREADS: ContextVar[int] = ContextVar("THREADS", default=2**31)


def threads_here() -> int:
    """Processors that this part of the program may use."""
    if hasattr(os, "sched_getaffinity"):
        there = len(os.sched_getaffinity(0))
    else:
        there = os.cpu_count() or 1
    return min(there, THREADS.get())


def spread(part: Any, number: int, threads: int) -> None:
    """Do parts [first, last) of a number of motions in some threads."""
    pieces = 1 if threads == 1 else min(4 * threads, max(threads, number // 64))
    edges = np.linspace(0, number, min(pieces, max(number, 1)) + 1).astype(int)
    if len(edges) == 2:
        part(0, number)
        return
    with ThreadPoolExecutor(threads) as pool:
        jobs = [pool.submit(part, int(a), int(b)) for a, b in zip(edges, edges[1:], strict=False)]
        for job in jobs:
            job.result()


@lru_cache(maxsize=64)
def lanes(
    system: System,
    *,
    tolerance: float = 1e-13,
    deviations: int = 0,
    section: Section | None = None,
    backward: bool = False,
) -> Lanes:
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

    Raises
    ------
    InputError
        If the tolerance is not between 1e-16 and 0.1, a formula has a function that machine code
        does not know, or the number of deviations is negative.
    """
    if not 1e-16 <= tolerance <= 0.1:
        raise InputError(f"tolerance {tolerance}: it must lie between 1e-16 and 0.1")
    if deviations < 0:
        raise InputError(f"deviations = {deviations}: there cannot be fewer than none")
    equations = equations_of(system, deviations, section, backward)
    width = native.width()
    code = native.load(
        f"march {width} {serial(equations)}",
        lambda: march(Double, explicit(), equations, width),
        {"march": _SIGNATURE},
    )
    return Lanes(system, tolerance, deviations, section, backward, code)


def equations_of(
    system: System, deviations: int, section: Section | None, backward: bool
) -> Equations:
    """The formulas of a system, of its deviations and of a section, as terms."""
    reader, forward = read_system(system)
    if not forward:
        raise InputError(f"{system.name}: a system without state has no motion")
    graph = reader.graph
    rates = tuple(-rate for rate in forward) if backward else forward
    size = len(rates)
    every = [*rates, *_variations(graph, rates, deviations)]
    value = slope = where = None
    if section is not None:
        value = reader(section.value)
        (slope,) = graph.along([value], {graph.state(i): rate for i, rate in enumerate(rates)})
        where = None if section.where is None else reader(section.where)
    direction = 0 if section is None else -section.direction if backward else section.direction
    return Equations(
        graph,
        tuple(every),
        _groups(system),
        len(system.parameters),
        value,
        slope,
        where,
        direction,
        tuple(reader(guard.value) for guard in system.guards),
    )


def _variations(graph: Graph, rates: Sequence[Term], deviations: int) -> list[Term]:
    """The variational equations, of one deviation after the other."""
    size = len(rates)
    found: list[Term] = []
    for k in range(1, deviations + 1):
        direction = {graph.state(i): graph.state(k * size + i) for i in range(size)}
        found.extend(graph.along(rates, direction))
    return found


def _groups(system: System) -> tuple[tuple[int, ...], ...]:
    found, first = [], 0
    for variable in system.state:
        width = 1 if isinstance(variable, sp.Symbol) else len(variable.symbols)
        found.append(tuple(range(first, first + width)))
        first += width
    return tuple(found)


def serial(equations: Equations) -> str:
    """All that the code depends on, as a text."""
    pieces = equations.pieces
    heads = [f"{name} {len(piece)}" for name, piece in pieces.items()]
    terms = serial_terms([term for piece in pieces.values() for term in piece])
    rest = (equations.groups, equations.direction, equations.parameters)
    return "\n".join([*heads, terms, *map(str, rest)])


def serial_terms(terms: Sequence[Term]) -> str:
    """Terms as a text, in which each is written once."""
    nodes = ordered(terms)
    place = {id(node): i for i, node in enumerate(nodes)}
    lines = [
        f"{node.kind} {' '.join(str(place.get(id(a), a)) for a in node.args)}" for node in nodes
    ]
    return "\n".join([*lines, str([place[id(t)] for t in terms])])
