"""What an integration method is: the request of a motion, and the class that meets it.

A new method is one class: it says which options it has, and makes a `Trajectory` whose `Statistics`
say how, which is what files and reports repeat.  :func:`flowlanes.flow.methods.register` makes it
known under its name.
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
    """One motion that is wanted; see :func:`flowlanes.flow.integrator.integrate`.

    Attributes
    ----------
    start : sequence of numbers
        The state at ``times[0]``, with the motion in space where there is one, in flat order.
    tolerance, time_limit : float or None
        None where none is asked for.
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
    """A method of integrating one motion.

    Attributes
    ----------
    name : str
        The word by which it is asked for.
    options : frozenset of str
        Those of ``tolerance``, ``time_limit`` and ``dense`` that it has.
    """

    name: ClassVar[str]
    options: ClassVar[frozenset[str]] = frozenset()

    @abstractmethod
    def motion(self, request: MotionRequest) -> Trajectory:
        """The motion; a RunError carries the last good time and the trajectory so far."""
