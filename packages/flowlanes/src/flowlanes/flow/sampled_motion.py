"""Continuous motions at given times: of closed forms, and between the samples of a motion."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt
import sympy as sp

from ..formulas.array_evaluation import as_float_array
from ..system.overview import Overview, WithOverview
from ..system.system import System
from .motion import SystemMotion, read_only
from .recorded_quantities import recorded_quantities, recorded_values
from .taylor.working_numbers import WorkingArray, WorkingNumber


@dataclass(frozen=True, repr=False, eq=False)
class SampledMotion(SystemMotion, WithOverview):
    """Continuous motion at given times.

    Attributes
    ----------
    system, parameters, times, states
        See :class:`flowlanes.flow.motion.SystemMotion`.
    continuous : callable
        Function for the motion: states (n, size) at times (n,).

    Examples
    --------
    >>> import flowlanes
    >>> import numpy as np
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> oscillator = flowlanes.System("oscillator", "Oscillator", {x: v, v: -x})
    >>> def turning(times):
    ...     return np.column_stack([np.sin(times), np.cos(times)])
    >>> times = np.array([0.0, 1.0, 2.0])
    >>> motion = flowlanes.flow.sampled_motion.SampledMotion(
    ...     oscillator, {}, times, turning(times), turning
    ... )
    >>> motion["x"].shape, motion([0.5]).times.tolist()
    ((3,), [0.5])
    """

    system: System
    parameters: Mapping[sp.Symbol, WorkingNumber]
    times: WorkingArray
    states: WorkingArray
    continuous: Callable[[WorkingArray], WorkingArray]

    def __post_init__(self) -> None:
        object.__setattr__(self, "times", read_only(self.times))
        object.__setattr__(self, "states", read_only(self.states))

    @cached_property
    def records(self) -> Mapping[str, WorkingArray]:  # type: ignore[override]
        """Observables and laws by name, computed in doubles on first use."""
        numbers = {symbol: float(value) for symbol, value in self.parameters.items()}
        recorded = recorded_values(self.system, self.states.astype(float), numbers)
        return {name: read_only(record) for name, record in recorded.items()}

    def __getitem__(self, name: str) -> WorkingArray:
        if name in {quantity.name for quantity in recorded_quantities(self.system)}:
            return self.records[name]
        return self.variable(name)

    def __call__(self, times: npt.ArrayLike) -> SampledMotion:
        """Motion at other times."""
        return sampled(self.system, self.parameters, times, self.continuous)

    def overview(self) -> Overview:
        """System, times and variables."""
        return Overview(
            f"{self.system.title}: {len(self.times):,} times",
            (("quantities", ", ".join(self)),),
        )


def sampled(
    system: System,
    parameters: Mapping[sp.Symbol, WorkingNumber],
    times: npt.ArrayLike,
    continuous: Callable[[WorkingArray], WorkingArray],
) -> SampledMotion:
    """Continuous motion at times (n,) or at one time."""
    moments = np.atleast_1d(as_float_array("times", times))
    return SampledMotion(system, parameters, moments, continuous(moments), continuous)
