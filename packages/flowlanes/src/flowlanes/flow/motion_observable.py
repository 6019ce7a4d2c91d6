"""Observables of motions: one number of each, computed for many motions at once.

An observable is a pair of functions: `run` follows the motions and keeps what is needed of them,
`reduce` makes the number of it.  An `Observation` is the observable of one system until a time.  A
motion that ends early has no value, and does not disturb the others.
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
    """What motions leave: how they ended, besides what an observable keeps of them."""

    @property
    def outcome(self) -> IntArray:
        """0, or why a motion ended, (n,)."""
        ...

    @property
    def end_times(self) -> FloatArray:
        """The times reached, (n,)."""
        ...


AnyRun = TypeVar("AnyRun", bound=Run)


@dataclass(frozen=True)
class MotionObservable(Generic[AnyRun]):
    """A number of a motion, for scans and ensembles.

    Called with a system and a time it gives an `Observation`.

    Attributes
    ----------
    name : str
        The word by which a user asks for it.
    title, unit : str
        Its meaning in words, and its unit; ``{}`` stands for the formula and for its unit.
    run : callable
        (observation, starts (n, size), parameters) ↦ what is kept of the motions.
    reduce : callable
        (observation, run) ↦ arrays (n,) by name: the number ``"value"``, and further ones.
    of_formula : bool
        Whether it is a number of a formula in state, definitions and parameters.
    samples : int
        Equidistant samples, or intervals, of each motion by default; 0 where there are none.
    least_samples : int
        The fewest of them.
    extra_columns : mapping of str to str
        Meanings of further numbers by name, such as an error.
    require : callable, optional
        (system, text, formula, unit) ↦ None; refuses a formula that has no such number.

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
        """The observable of motions of a system; see `Observation`."""
        count = self.samples if samples is None else samples
        return Observation(self, system, t_end, formula, count, tolerance, device)

    def __hash__(self) -> int:
        return hash((self.name, self.run, self.reduce))


@arguments_checked
@dataclass(frozen=True)
class Observation:
    """An observable of the motions of a system.

    Attributes
    ----------
    observable : MotionObservable
    system : System
    t_end : float
        Length of the motions.
    formula : sympy.Expr, optional
        In state, definitions and parameters; None where it is no number of a formula.
    samples : int
        Equidistant samples, or intervals, of each motion.
    tolerance : float
        See :mod:`flowlanes.system.tolerance`.
    device : "cpu" or "gpu"
        Where motions are computed; see :func:`flowlanes.flow.batch.batch_integrator`.

    Raises
    ------
    InputError
        If a formula is missing or is one too many, or there are too few samples.

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
        """Names and meanings of further numbers, such as an error."""
        return self.observable.extra_columns

    @arguments_checked
    def __call__(
        self, starts: FloatArray, parameters: Parameters
    ) -> dict[str, FloatArray | IntArray]:
        """Values, further numbers, outcomes and times reached, (n,) each."""
        run = self.observable.run(self, starts, parameters)
        numbers = self.observable.reduce(self, run)
        return {**numbers, "outcome": run.outcome, "ended": run.end_times}
