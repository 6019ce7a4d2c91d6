"""The properties of a motion on a torus that error bounds require."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

import numpy.typing as npt
import sympy as sp

from flowlanes.arguments import NumberOrText
from flowlanes.system.arrays import FloatArray

from ..genus_two.separated_motion import SeparatedMotion


class TorusMotion(Protocol):
    """A motion on a two-dimensional torus, as error bounds require it."""

    @property
    def separated_motion(self) -> SeparatedMotion:
        """Constants, curve and torus."""

    @property
    def parameters(self) -> Mapping[sp.Symbol, NumberOrText]:
        """Values of the parameters."""

    @property
    def start(self) -> tuple[NumberOrText, ...]:
        """The lifted state at t = 0, as given."""

    @property
    def phase_rate(self) -> float:
        """The rate at which the phases grow with time, in turns."""

    @property
    def not_rigorous(self) -> str:
        """A sentence on the part of the state that has no bounds; or ""."""

    def states(self, times: npt.ArrayLike) -> FloatArray:
        """Lifted states (n, size) at `times` (n,), in double precision."""

    def __hash__(self) -> int: ...
