"""Motions derived from the closed form of another motion."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from flowlanes.arguments import NumberOrText
from flowlanes.system.system import System

from .solution import ClosedForm, Solution


@dataclass(frozen=True, repr=False)
class DerivedSolution(Solution):
    """A motion whose states are functions of the states of another motion at the same times.

    Attributes
    ----------
    system : System
        Lifted to space if it has a motion there.
    inner : Solution
        The other motion, which provides the closed form.
    """

    system: System
    parameters: Mapping[sp.Symbol, NumberOrText]
    inner: Solution

    @property
    def form(self) -> ClosedForm:
        """The closed form of the other motion."""
        return self.inner.form

    @property
    def phase_rate(self) -> float:
        """The phase rate of the other motion."""
        return self.inner.phase_rate

    @property
    def not_rigorous(self) -> str:
        """:attr:`Solution.not_rigorous` of the other motion."""
        return self.inner.not_rigorous
