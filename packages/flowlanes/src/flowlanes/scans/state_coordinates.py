"""Coordinates of states and sections, as maps in both directions.

:class:`StateCoordinates` map points with a few coordinates to states, and states to points.  A
coordinate may be fixed, or solved for on a level of an integral: so polar coordinates (r, theta,
p_r, p_theta) become the chart (r, p_r) of a section theta = 0 on a level of the energy::

    plane = polar.with_fixed({"theta": 0.0}).without_coordinate("p_theta", "energy", 1.0)
    states = plane.state([[0.5, 0.1]])

If there is no state, or none determined by formulas, the result is NaN;
:meth:`StateCoordinates.require` turns that into an error message.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Protocol, TypeAlias, runtime_checkable

import numpy as np

from ..arguments import Parameters
from ..errors import InputError
from ..flow.sampling.great_circles import crossings
from ..formulas.array_formulas import Formulas
from ..system.arrays import FloatArray, IntArray
from ..system.system import System

#: Initial number of intervals of the range of a solved coordinate.
_PIECES = 16
#: Step of the difference quotients that locate extrema in a search.
_STEP = 1e-6
#: Number of Newton steps after the search.
_NEWTON = 2


@dataclass(frozen=True)
class StateCoordinates:
    """Coordinates of states.

    Attributes
    ----------
    system : System
    parameters : mapping
        Values that replace the defaults of the system.
    names : tuple of str
        The names of the coordinates, in order.
    periods : tuple of float
        2π for an angle, 0 otherwise.
    domain : str
        The domain of the coordinates, in words.
    all_states : callable
        Points (d, k) ↦ the indices of those that have a state, and the states (size, m).
    coordinates_of : callable
        States (size, k) ↦ points (d, k).
    span : callable
        The name of a coordinate and values of the others ↦ the ends of its range.
    single_valued : bool
        Whether no more than one state belongs to a point.
    """

    system: System
    parameters: Parameters
    names: tuple[str, ...]
    periods: tuple[float, ...]
    domain: str
    all_states: Callable[[FloatArray], tuple[IntArray, FloatArray]]
    coordinates_of: Callable[[FloatArray], FloatArray]
    span: Callable[[str, Mapping[str, float]], tuple[float, float]]
    single_valued: bool = True

    def state(self, points: FloatArray, branch: int = 0) -> FloatArray:
        """The states of given points.

        Parameters
        ----------
        points : array (n, d)
            One point in each row.
        branch : int
            Selects one of several states with the same point (if a coordinate was solved for):
            they are numbered from 0 with increasing solved coordinate; −1 is the last.

        Returns
        -------
        array (n, size)
            NaN where there is no such state.
        """
        rows = self._rows(points, len(self.names))
        which, states = self.all_states(rows.T)
        chosen = np.full((len(rows), len(self.system.symbols)), np.nan)
        first = np.searchsorted(which, np.arange(len(rows)))
        many = np.bincount(which, minlength=len(rows))
        place = branch if branch >= 0 else many + branch
        there = np.flatnonzero((place >= 0) & (place < many))
        chosen[there] = states.T[(first + place)[there]]
        return chosen

    def solutions(self, points: FloatArray) -> IntArray:
        """The number of states (n,) with each of the points (n, d)."""
        rows = self._rows(points, len(self.names))
        return np.bincount(self.all_states(rows.T)[0], minlength=len(rows))

    def point(self, states: FloatArray) -> FloatArray:
        """The points (n, d) of states (n, size); angles lie in [0, 2π).

        NaN where a coordinate is undefined. The level and the fixed coordinates are ignored: a
        state off them gets the values of its other coordinates.
        """
        rows = self._rows(states, len(self.system.symbols))
        points = self.coordinates_of(np.ascontiguousarray(rows.T))
        for row, period in zip(points, self.periods, strict=True):
            if period:
                row[:] = np.mod(row, period)
                # np.mod rounds a tiny negative number up to the whole period.
                row[row == period] = 0.0
        return np.ascontiguousarray(points.T)

    def require(self, points: FloatArray) -> None:
        """Raise InputError for points without a state.

        Raises
        ------
        InputError
            The message names the first such point and the domain.
        """
        rows = self._rows(points, len(self.names))
        empty = np.flatnonzero(self.solutions(rows) == 0)
        if empty.size:
            place = ", ".join(
                f"{name} = {value:.6g}"
                for name, value in zip(self.names, rows[empty[0]], strict=True)
            )
            raise InputError(f"{self.system.name}: no state at {place}; {self.domain}")

    def with_fixed(self, values: Mapping[str, float]) -> StateCoordinates:
        """The chart with some coordinates fixed at given values."""
        for name in values:
            self._row_of(name)
        free = [i for i, name in enumerate(self.names) if name not in values]

        def every(points: FloatArray) -> tuple[IntArray, FloatArray]:
            return self.all_states(self._all_coordinates(free, points, values))

        def span(name: str, others: Mapping[str, float]) -> tuple[float, float]:
            return self.span(name, {**others, **values})

        text = "".join(f", {name} = {value:.6g}" for name, value in values.items())
        return replace(
            self,
            names=tuple(self.names[i] for i in free),
            periods=tuple(self.periods[i] for i in free),
            domain=self.domain + text,
            all_states=every,
            coordinates_of=lambda states: self.coordinates_of(states)[free],
            span=span,
        )

    def without_coordinate(self, name: str, integral: str, value: float) -> StateCoordinates:
        """The chart without a coordinate, which is computed from the value of an integral.

        Parameters
        ----------
        name : str
            The coordinate to solve for.
        integral : str
            Name of an integral of the system.
        value : float

        Raises
        ------
        InputError
            If there is no such coordinate or integral, or a coordinate was solved for already.
        """
        place = self._row_of(name)
        if not self.single_valued:
            raise InputError(f"{self.system.name}: one coordinate can be solved for, not two")
        laws = {law.name: law.value for law in self.system.integrals}
        if integral not in laws:
            raise InputError(
                f"{self.system.name} has no integral {integral!r}; it has {', '.join(laws)}"
            )
        free = [i for i in range(len(self.names)) if i != place]
        search = _Search(self, place, Formulas(self.system, [laws[integral]]), value)
        return replace(
            self,
            names=tuple(self.names[i] for i in free),
            periods=tuple(self.periods[i] for i in free),
            domain=f"{self.domain}, and {integral} = {value:.6g} for some {name}",
            all_states=search.every,
            coordinates_of=lambda states: self.coordinates_of(states)[free],
            single_valued=False,
        )

    # --- inside --------------------------------------------------------------------------------

    def _row_of(self, name: str) -> int:
        if name not in self.names:
            raise InputError(
                f"{self.system.name}: no coordinate {name!r} in this chart; it has "
                f"{', '.join(self.names)}"
            )
        return self.names.index(name)

    def _rows(self, rows: FloatArray, width: int) -> FloatArray:
        array = np.atleast_2d(np.asarray(rows, dtype=float))
        if array.shape[1] != width:
            raise InputError(
                f"{self.system.name}: rows of {width} numbers are needed, not of {array.shape[1]}"
            )
        return array

    def _all_coordinates(
        self, free: Sequence[int], points: FloatArray, values: Mapping[str, float]
    ) -> FloatArray:
        whole = np.empty((len(self.names), points.shape[1]))
        whole[list(free)] = points
        for name, value in values.items():
            whole[self.names.index(name)] = value
        return whole


#: What makes coordinates: the system, levels of its integrals, values of its parameters.
ChartMaker: TypeAlias = Callable[[System, Mapping[str, float], Mapping[Any, Any]], StateCoordinates]


@runtime_checkable
class WithCharts(Protocol):
    """Conventions that know coordinates for the states of their systems."""

    @property
    def charts(self) -> Mapping[str, ChartMaker]:
        """What makes the coordinates, by name."""


def chart(
    system: System,
    name: str,
    level: Mapping[str, float] | None = None,
    parameters: Parameters = None,
) -> StateCoordinates:
    """Coordinates of the states of a system, from those that its conventions know.

    Parameters
    ----------
    system : System
    name : str
    level : mapping of str to float, optional
        Values of integrals, where the coordinates are those of a level.
    parameters : mapping of Symbol or name to float, optional
        Values that replace the defaults.

    Raises
    ------
    InputError
        If there is no such chart, or the state of the system does not fit it.
    """
    charts = system.conventions.charts if isinstance(system.conventions, WithCharts) else {}
    if name not in charts:
        known = f"there are {', '.join(charts)}" if charts else f"{system.name} has none"
        raise InputError(f"no coordinates {name!r}; {known}")
    return charts[name](system, dict(level or {}), dict(parameters or {}))


@dataclass(frozen=True)
class _Search:
    """The solutions of F(c) = value for one coordinate c and an integral F."""

    chart: StateCoordinates
    place: int
    formula: Formulas
    value: float

    def every(self, points: FloatArray) -> tuple[IntArray, FloatArray]:
        """All states over points (d − 1, k) of the other coordinates."""
        chart, count = self.chart, points.shape[1]
        names = [name for i, name in enumerate(chart.names) if i != self.place]
        span = chart.span(chart.names[self.place], dict(zip(names, points, strict=True)))
        low, high = (np.broadcast_to(np.asarray(end, dtype=float), (count,)) for end in span)
        scale = self._scale(points, low)

        # Substitute c(w), 0 < w < 1: c = a + (b − a)(1 − cos πw)/2 on a finite range, and c = a +
        # s w²/(1 − w²) on an infinite one. There F may grow like c² ~ (1 − w²)⁻², so that the
        # defect is multiplied by (1 − w²)² to stay bounded.
        def at(which: IntArray, way: FloatArray) -> tuple[FloatArray, FloatArray]:
            # Sample quadratically near the ends, where coordinates often behave like square roots.
            with np.errstate(invalid="ignore", divide="ignore"):
                finite = low[which] + (high - low)[which] * (1 - np.cos(np.pi * way)) / 2
                beyond = low[which] + scale[which] * way**2 / (1 - way**2)
            unbounded = np.isinf(high[which])
            weight = np.where(unbounded, (1 - way**2) ** 2, 1.0)
            return np.where(unbounded, beyond, finite), weight

        def along(which: IntArray, way: FloatArray) -> tuple[FloatArray, FloatArray]:
            def value(shift: float) -> FloatArray:
                there, weight = at(which, way + shift)
                return self._defect(points[:, which], there) * weight

            return value(0.0), (value(_STEP) - value(-_STEP)) / (2 * _STEP)

        nodes = np.linspace(0.0, 1.0, _PIECES + 1)
        nodes[0], nodes[-1] = 2 * _STEP, 1 - 2 * _STEP
        which, way = crossings(along, count, nodes)
        solved = self._newton_refined(points[:, which], at(which, way)[0])
        owner, states = chart.all_states(self._all_coordinates(points[:, which], solved))
        return which[owner], states

    def _all_coordinates(self, points: FloatArray, unknowns: FloatArray) -> FloatArray:
        return np.insert(points, self.place, unknowns, axis=0)

    def _defect(self, points: FloatArray, unknowns: FloatArray) -> FloatArray:
        owner, states = self.chart.all_states(self._all_coordinates(points, unknowns))
        defect = np.full(unknowns.size, np.nan)
        values = self.formula(np.ascontiguousarray(states.T), self.chart.parameters)[:, 0]
        defect[owner] = values - self.value
        return defect

    def _scale(self, points: FloatArray, low: FloatArray) -> FloatArray:
        """A scale on which the integral changes by about its value, if it grows quadratically."""
        big = 1e4 * (1 + np.abs(np.where(np.isfinite(low), low, 0.0)))
        growth = np.abs(self._defect(points, big)) / big**2
        with np.errstate(invalid="ignore", divide="ignore"):
            reach = np.sqrt((abs(self.value) + 1e-3) / growth)
        return np.where(np.isfinite(reach) & (reach > 0), reach, 1.0)

    def _newton_refined(self, points: FloatArray, unknowns: FloatArray) -> FloatArray:
        for _ in range(_NEWTON):
            step = _STEP * (1e-3 + np.abs(unknowns))
            rise = self._defect(points, unknowns + step) - self._defect(points, unknowns - step)
            with np.errstate(invalid="ignore", divide="ignore"):
                better = unknowns - self._defect(points, unknowns) * 2 * step / rise
            near = np.abs(better - unknowns) < step
            unknowns = np.where(near, better, unknowns)
        return unknowns
