"""Keeping a state on its phase space.

The relations (γ² = 1, (ω, γ) = 0, …) are left alone while their residual is at rounding level and
restored by Newton's method, along the shortest way, once it is not.  The lift to space is moved
onto the reduced state, never the other way round, so that an error of the attitude cannot spoil
the dynamics.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

__all__ = ["Projector"]


def call(function: Any, state: Any, parameters: Any) -> Any:
    """A compiled function at states (size,) or (size, n); it may know the first few parameters only."""
    # heyoka counts the parameters up to the last one that occurs in the formulas
    known = function.nparams
    return function(state, pars=parameters[:known])


@dataclass(frozen=True)
class Projector:
    """Moves some columns of a state until some residuals vanish.

    Attributes
    ----------
    residual : heyoka.cfunc
        The residuals, in working precision.
    slope : heyoka.cfunc
        Their derivatives with respect to the columns, in double, row by row.
    count : int
        Number of residuals.
    columns : slice
        The part of the state that is moved.
    parameters : array
        Parameter values in working precision.
    threshold : float
        Residuals below this are left alone.
    target : array or None
        Values that the residual functions should have instead of zero.
    """

    residual: Any
    slope: Any
    count: int
    columns: slice
    parameters: Any
    threshold: float
    target: Any = None

    def defect(self, state: Any) -> Any:
        """The residuals at a state."""
        value = call(self.residual, state, self.parameters)
        return value if self.target is None else value - self.target

    def __call__(self, state: Any) -> bool:
        """Project `state` in place; return whether it had to be moved."""
        if not self.count:
            return False
        defect = self.defect(state)
        if max(abs(float(x)) for x in defect) <= self.threshold:
            return False
        pars = np.array([float(x) for x in self.parameters])
        for _ in range(3):
            point = np.array([float(x) for x in state])
            slope = call(self.slope, point, pars).reshape(self.count, -1)
            # redundant relations (an attitude tied to a unit vector) make the rows dependent
            step = np.linalg.pinv(slope, rcond=1e-9) @ np.array([float(x) for x in defect])
            state[self.columns] -= step
            defect = self.defect(state)
            if max(abs(float(x)) for x in defect) <= self.threshold:
                break
        return True
