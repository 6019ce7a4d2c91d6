"""Integration methods: the request of a motion, and the base class of methods.

A new method is one class.  It declares its options and returns a `Trajectory` with `Statistics`,
which are also written to files and reports.  :func:`flowlanes.flow.methods.register` makes it
available under its name.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import ClassVar, Literal

from ..arguments import Numbers, Parameters
from ..system.system import System
from ..system.tolerance import Precision
from .taylor.working_numbers import WorkingNumber
from .trajectory import Trajectory


@dataclass(frozen=True)
class MotionRequest:
    """Request for one motion; see :func:`flowlanes.flow.integrator.integrate`.

    Attributes
    ----------
    start : sequence of numbers
        State at ``times[0]``, with the motion in space if there is one, in flat order.
    tolerance, time_limit : float or None
        None if not given.
    """

    system: System
    start: Sequence[WorkingNumber]
    times: Numbers
    parameters: Parameters = None
    tolerance: float | None = None
    precision: Precision = "double"
    on_liftoff: Literal["stop", "warn"] = "stop"
    keep_integrals: bool = False
    time_limit: float | None = None
    dense: bool = False
    progress: Callable[[float], None] | None = None


class IntegrationMethod(ABC):
    """Method of integration for one motion.

    Attributes
    ----------
    name : str
        Value of the argument `method` for this method.
    options : frozenset of str
        Supported options out of ``tolerance``, ``time_limit`` and ``dense``.
    """

    name: ClassVar[str]
    options: ClassVar[frozenset[str]] = frozenset()

    @abstractmethod
    def motion(self, request: MotionRequest) -> Trajectory:
        """The motion; a RunError holds the last valid time and the trajectory up to it."""
