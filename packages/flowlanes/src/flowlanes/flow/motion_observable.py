"""Observables of motions: one number for each motion, computed for many motions at once.

An observable is a pair of functions: `run` integrates the motions and keeps the data that are
needed, and `reduce` computes the number from these data.  An `Observation` is the observable for
one system and duration.  A motion that ends early has no value, and does not affect the others.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Generic, Protocol, TypeVar

import sympy as sp

from ..arguments import Positive, arguments_checked
from ..errors import InputError
from ..system.arrays import FloatArray, IntArray
from ..system.parameters import Parameters
from ..system.system import System
from ..system.tolerance import ENSEMBLE_TOLERANCE
from .devices.graphics import Device


class Run(Protocol):
    """Result of motions: how they ended, and the data kept for an observable."""

    @property
    def outcome(self) -> IntArray:
        """0, or the code of the reason for the end of a motion, (n,)."""
        ...

    @property
    def end_times(self) -> FloatArray:
        """Last times reached, (n,)."""
        ...


AnyRun = TypeVar("AnyRun", bound=Run)


@dataclass(frozen=True)
class MotionObservable(Generic[AnyRun]):
    """Number that characterizes a motion, for scans and ensembles.

    A call with a system and a time gives an `Observation`.

    Attributes
    ----------
    name : str
        Name for the user.
    title, unit : str
        Description and unit; ``{}`` stands for the formula or for its unit.
    run : callable
        (observation, starts (n, size), parameters) ↦ data kept from the motions.
    reduce : callable
        (observation, run) ↦ arrays (n,) by name: the number ``"value"``, and further ones.
    of_formula : bool
        True if it depends on a formula in state, definitions and parameters.
    samples : int
        Default number of equidistant samples, or intervals, of each motion; 0 if there are none.
    least_samples : int
        Smallest number of samples.
    extra_columns : mapping of str to str
        Descriptions of further numbers by name, such as an error.
    require : callable, optional
        (system, text, formula, unit) ↦ None; raises an error for a formula without such a number.

    Examples
    --------
    >>> import flowlanes
    >>> import numpy as np
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> pendulum = flowlanes.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)})
    >>> highest = flowlanes.scans.maximum(pendulum, 10.0, v**2, samples=64)
    >>> highest(np.array([[1.0, 0.0]]), {})["value"].round(3).tolist()
    [0.919]
    """

    name: str
    title: str
    run: Callable[[Observation, FloatArray, Parameters], AnyRun] = field(repr=False)
    reduce: Callable[[Observation, AnyRun], Mapping[str, FloatArray]] = field(repr=False)
    unit: str = ""
    of_formula: bool = False
    samples: int = 0
    least_samples: int = 1
    extra_columns: Mapping[str, str] = field(default_factory=dict)
    require: Callable[[System, str, sp.Expr, str], None] | None = field(default=None, repr=False)

    def __call__(
        self,
        system: System,
        t_end: float,
        formula: sp.Expr | None = None,
        samples: int | None = None,
        tolerance: float = ENSEMBLE_TOLERANCE,
        device: Device = "cpu",
    ) -> Observation:
        """Observable of motions of a system; see `Observation`."""
        count = self.samples if samples is None else samples
        return Observation(self, system, t_end, formula, count, tolerance, device)

    def __hash__(self) -> int:
        return hash((self.name, self.run, self.reduce))


@arguments_checked
@dataclass(frozen=True)
class Observation:
    """Observable of the motions of a system.

    Attributes
    ----------
    observable : MotionObservable
    system : System
    t_end : float
        Duration of the motions.
    formula : sympy.Expr, optional
        Formula in state, definitions and parameters; None if the observable has no formula.
    samples : int
        Number of equidistant samples, or intervals, of each motion.
    tolerance : float
        See :mod:`flowlanes.system.tolerance`.
    device : "cpu" or "gpu"
        Device for the computation; see :func:`flowlanes.flow.batch.batch_integrator`.

    Raises
    ------
    InputError
        If a formula is missing or not allowed, or there are too few samples.

    Examples
    --------
    >>> import flowlanes
    >>> import numpy as np
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> pendulum = flowlanes.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)})
    >>> mean = flowlanes.scans.time_average(pendulum, 10.0, v**2)
    >>> mean(np.array([[1.0, 0.0]]), {})["value"].round(3).tolist()
    [0.447]
    """

    observable: MotionObservable[Any]
    system: System
    t_end: Positive
    formula: sp.Expr | None = None
    samples: int = 0
    tolerance: Positive = ENSEMBLE_TOLERANCE
    device: Device = "cpu"

    def __post_init__(self) -> None:
        name = self.observable.name
        if self.observable.of_formula != (self.formula is not None):
            wanted = "a formula is needed" if self.formula is None else "it takes no formula"
            raise InputError(f"{name}: {wanted}")
        if self.observable.samples and self.samples < self.observable.least_samples:
            raise InputError(
                f"samples = {self.samples}: at least {self.observable.least_samples} are needed"
            )

    @property
    def extra_columns(self) -> Mapping[str, str]:
        """Names and descriptions of further numbers, such as an error."""
        return self.observable.extra_columns

    @arguments_checked
    def __call__(
        self, starts: FloatArray, parameters: Parameters
    ) -> dict[str, FloatArray | IntArray]:
        """Values, further numbers, outcomes and last times reached, (n,) each."""
        run = self.observable.run(self, starts, parameters)
        numbers = self.observable.reduce(self, run)
        return {**numbers, "outcome": run.outcome, "ended": run.end_times}
