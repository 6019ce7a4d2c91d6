"""The interface of a motion on a degenerate curve to its rigorous bounds."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from ...arguments import Written
from ...core.arrays import FloatArray
from ..genus_two.separation import SeparatedSystem
from .exact_start import ExactStart
from .quadratures import Quadratures
from .theta_motion import Asymptotic, Periodic

__all__ = ["DegenerateMotion"]


class DegenerateMotion(Protocol):
    """A motion on a curve of genus two with a double root."""

    @property
    def separable(self) -> SeparatedSystem:
        """The formulas."""

    @property
    def exact(self) -> ExactStart:
        """The start in numbers of high precision."""

    @property
    def motion(self) -> Periodic | Asymptotic:
        """The motion on the curve."""

    @property
    def start(self) -> tuple[Written, ...]:
        """The state at t = 0, as given."""

    @property
    def in_space(self) -> bool:
        """Whether the motion in space is part of the states."""

    @property
    def pace(self) -> float:
        """Periods in a unit of time."""

    @property
    def clock(self) -> Quadratures:
        """t and the position in space as functions of τ."""

    def states(self, times: Sequence[float] | FloatArray) -> FloatArray:
        """Lifted states (n, size) at `times` (n,), in double precision."""
