"""Steps of a motion by Taylor series, with terminal events."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ...system.arrays import FloatArray
from ..machine_code.jit import Native, aligned_zeros
from .first_root import first_falling_root

#: Number of roundings within which another zero of an event is taken as the same zero.
_ROUNDINGS = 100.0
_EPS = float(np.finfo(float).eps)


@dataclass(frozen=True)
class SeriesLayout:
    """Sizes of compiled series.

    Attributes
    ----------
    size, events, parameters, order : int
        Numbers of state variables, of terminal events and of parameters, and order of the series.
    doubles, stride : int
        See :class:`flowlanes.flow.taylor.recurrences.SeriesText`.
    """

    size: int
    events: int
    parameters: int
    order: int
    doubles: int
    stride: int


@dataclass(frozen=True)
class Step:
    """Result of a step.

    Attributes
    ----------
    length : float
    event : int or None
        Terminal event at the end of the step.
    is_failure : bool
        True if the state or its series is not finite; then the state is that before the step.
    """

    length: float
    event: int | None = None
    is_failure: bool = False


def series_order(tolerance: float) -> int:
    """Order that reaches a tolerance with the fewest operations (Jorba, Zou 2005)."""
    return max(2, math.ceil(1 - math.log(tolerance) / 2))


class TaylorSeries:
    """State that advances by steps of its Taylor series.

    An event occurs where its formula decreases to zero along the motion; it ends the step.

    Parameters
    ----------
    code : Native
        Functions of :mod:`flowlanes.flow.taylor.recurrences`.
    layout : SeriesLayout

    Attributes
    ----------
    time : float
    state : array (size,)
    parameters : array (parameters,)
        Values of the parameters.
    order : int
    series : array (size, order + 1)
        Coefficients of the powers of time since the start of the last step.
    """

    def __init__(self, code: Native, layout: SeriesLayout) -> None:
        self._code, self._layout = code, layout
        self.order = layout.order
        self.state = np.zeros(layout.size)
        self.parameters = np.zeros(layout.parameters)
        self._memory = aligned_zeros(layout.doubles)
        rows = self._memory[: (layout.size + layout.events) * layout.stride]
        rows = rows.reshape(-1, layout.stride)[:, : layout.order + 1]
        self.series, self._event_series = rows[: layout.size], rows[layout.size :]
        self._powers = np.arange(layout.order + 1)
        # Limit and length of a step, and the number of possible events within it.
        self._control = np.zeros(3)
        # Rounding errors of the state before and after the last step.
        self._rest_before, self._rest = np.zeros(layout.size), np.zeros(layout.size)
        self._result = np.zeros(layout.size)
        # For each event: value at the end of the last step, time of its last occurrence, and the
        # interval in which it is then ignored.
        self._ends, self._moments, self._quiet = (np.zeros(layout.events) for _ in range(3))
        self._time, self._time_rest, self._begin = 0.0, 0.0, 0.0
        self._parameter_bytes = b""
        arrays = self._memory, self.state, self._rest_before, self._rest, self._ends, self._result
        self._step_arguments = tuple(a.ctypes.data for a in (*arrays, self._control))
        # A time since the start of the last step, and the rounding error of the state there.
        self._moment, self._rounding = np.zeros(1), np.zeros(layout.size)
        sum_arrays = self._memory, self._rest_before, self._moment, self._result, self._rounding
        self._sum_arguments = tuple(a.ctypes.data for a in sum_arrays)

    @property
    def time(self) -> float:
        """Time; it can be set."""
        return self._time

    @time.setter
    def time(self, value: float) -> None:
        self._time, self._time_rest = value, 0.0

    def copy(self) -> TaylorSeries:
        """Copy that advances independently with the same code."""
        other = TaylorSeries(self._code, self._layout)
        other.parameters[:], other.state[:] = self.parameters, self.state
        other.time = self.time
        return other

    def reset(self) -> None:
        """Reset the recent events and the rounding errors."""
        for array in (self._rest, self._quiet, self._ends):
            array[:] = 0.0

    def step(self, limit: float) -> Step:
        """Make one step, not longer than `limit`.

        Parameters
        ----------
        limit : float
            Time from now; negative backward.
        """
        self._prepare()
        self._control[0] = limit
        self._code.functions["step"](*self._step_arguments)
        _, length, suspects = self._control.tolist()
        event = None
        if suspects and math.isfinite(length):
            length, event = self._step_to_event(length)
        if not math.isfinite(length) or (length == 0 and event is None):
            # Numbers that are not finite would remain in the memory.
            self._parameter_bytes = b""
            self._rest[:] = self._rest_before
            return Step(0.0, is_failure=True)
        self._begin = self._time
        change = length + self._time_rest
        self._time = self._begin + change
        self._time_rest = change - (self._time - self._begin)
        if event is not None:
            self._moments[event] = self._time
        return Step(length, event)

    def state_at(self, time: float) -> FloatArray:
        """State at a time within the last step."""
        self._sum(time - self._begin)
        return self._result.copy()

    def _prepare(self) -> None:
        """Compute everything that depends only on the parameters, if they have changed."""
        # The first preparation is necessary even without parameters.
        values = b"." + self.parameters.tobytes()
        if values != self._parameter_bytes:
            self._parameter_bytes = values
            self._memory[:] = 0.0
            self._code.functions["prepare_series"](
                self._memory.ctypes.data, self.parameters.ctypes.data
            )

    def _sum(self, length: float) -> None:
        """Compute the state at a time since the start of the last step, and its rounding error."""
        self._moment[0] = length
        self._code.functions["sums"](*self._sum_arguments)

    def _step_to_event(self, length: float) -> tuple[float, int | None]:
        """Make a step that ends at the first event within a length; return the event, if any.

        The length is NaN if the state is NaN.
        """
        terms = self._event_series * length**self._powers
        event, fraction = self._first_event(terms, abs(length))
        powers = fraction**self._powers
        self._sum(fraction * length)
        if not np.isfinite(self._result).all():
            return math.nan, None
        self.state[:], self._rest[:] = self._result, self._rounding
        self._ends[:] = terms @ powers
        if event is not None:
            self._ends[event] = 0.0
            slope = abs(float(terms[event, 1:] @ (self._powers[1:] * powers[:-1])))
            size = float(np.abs(terms[event]).sum())
            if slope > 0:
                self._quiet[event] = _ROUNDINGS * _EPS * size / slope * abs(length)
        return fraction * length, event

    def _first_event(self, terms: FloatArray, length: float) -> tuple[int | None, float]:
        """First event within a step, if any, and the fraction of the step until then.

        Parameters
        ----------
        terms : array (events, order + 1)
            Terms of the series of the events at the end of the step.
        length : float
            Length of the step.
        """
        # Between two steps a zero may be hidden by rounding.
        hidden = (self._ends > 0) & (terms[:, 0] <= 0)
        if hidden.any():
            return int(np.argmax(hidden)), 0.0
        event, fraction = None, 1.0
        quiet = self._quiet - np.abs(self._time - self._moments)
        after = np.clip(quiet / length, 0.0, 1.0).tolist()
        sizes = np.abs(terms)
        for i in np.flatnonzero(sizes[:, 0] <= sizes[:, 1:].sum(axis=1)).tolist():
            if not np.isfinite(terms[i]).all():
                continue
            root = first_falling_root(terms[i], after[i])
            if root is not None and (event is None or root < fraction):
                event, fraction = i, root
        return event, fraction
