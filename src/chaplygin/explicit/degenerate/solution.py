"""Motions on a degenerate curve in closed form."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from flint import arb

from ...arguments import NumberOrText, arguments_checked
from ..base.solution import ClosedForm, Solution
from .closed_form import form_of
from .motion import DegenerateMotion
from .rigorous import rigorous_state


@dataclass(frozen=True, repr=False)
class DegenerateSolution(DegenerateMotion, Solution):
    """A motion on a curve of genus two that has a double root."""

    @arguments_checked
    def rigorous(self, time: NumberOrText, digits: int = 30) -> tuple[arb, ...]:
        """The lifted state at one time as balls."""
        return rigorous_state(self, time, digits)

    @cached_property
    def form(self) -> ClosedForm:
        """The curve, its double root, the frequencies."""
        return form_of(self.separable, self.exact, self.motion, self.e, self.turn)
