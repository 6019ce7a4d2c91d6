"""What bounds need to know of a motion on a degenerate curve."""

from __future__ import annotations

from typing import Any, Protocol

from ..genus_two.separation import SeparatedSystem
from .exact_start import Beginning
from .quadratures import Quadratures, Window
from .theta_motion import Asymptotic, Periodic

__all__ = ["DegenerateMotion"]


class DegenerateMotion(Protocol):
    """A motion on a curve of genus two with a double root, as bounds need it."""

    @property
    def separable(self) -> SeparatedSystem:
        """The formulas."""

    @property
    def beginning(self) -> Beginning:
        """The start, exactly."""

    @property
    def motion(self) -> Periodic | Asymptotic:
        """The motion on the curve."""

    @property
    def start(self) -> tuple[Any, ...]:
        """The state at t = 0, as given."""

    @property
    def lifted(self) -> bool:
        """Whether the motion in space is part of the states."""

    @property
    def pace(self) -> float:
        """How fast the phase grows with time, in turns."""

    @property
    def clock(self) -> Quadratures | Window:
        """t and places in space as functions of τ."""

    def states(self, times: Any) -> Any:
        """Lifted states (n, size) at `times` (n,), in double precision."""
