"""Projection of a state back onto its phase space.

The relations (u² = 1, (u, v) = 0, …) are left alone while their residuals are at rounding level,
and otherwise restored by Newton's method with steps of minimal norm.  The lift to space is
projected onto the reduced state, never the reverse, so an error of the reconstruction cannot
affect the dynamics.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ...system.arrays import FloatArray
from .working_numbers import WorkingArray


@dataclass(frozen=True)
class Block:
    """Compiled residuals.

    Attributes
    ----------
    residual : callable
        From a state and the parameters to the residuals, in working precision.
    slope : callable
        Their derivatives with respect to the moved columns, in double, row by row.
    count : int
        Number of residuals.
    """

    residual: Callable[[WorkingArray, WorkingArray], WorkingArray]
    slope: Callable[[FloatArray, FloatArray], FloatArray]
    count: int


@dataclass(frozen=True)
class Projector:
    """Projects some columns of a state until residuals have their target values.

    Attributes
    ----------
    blocks : tuple of Block
    columns : slice
        The part of the state that is moved.
    parameters : array
        Parameter values in working precision.
    threshold : float
        Residuals below this are left alone.
    target : array or None
        Values that the residuals should have instead of zero.
    """

    blocks: tuple[Block, ...]
    columns: slice
    parameters: WorkingArray
    threshold: float
    target: WorkingArray | None = None

    def values(self, state: WorkingArray) -> WorkingArray:
        """All residual functions at a state."""
        return np.concatenate([b.residual(state, self.parameters) for b in self.blocks])

    def defect(self, state: WorkingArray) -> WorkingArray:
        """The residuals minus their targets."""
        values = self.values(state)
        return values if self.target is None else values - self.target

    def __call__(self, state: WorkingArray) -> bool:
        """Project `state` in place; return whether it had to be moved."""
        if not self.blocks:
            return False
        defect = self.defect(state).astype(float)
        if np.abs(defect).max() <= self.threshold:
            return False
        pars = self.parameters.astype(float)
        for _ in range(3):
            point = state.astype(float)
            slope = np.concatenate([b.slope(point, pars).reshape(b.count, -1) for b in self.blocks])
            # Redundant relations (a rotation tied to a unit vector) make the rows dependent.
            state[self.columns] -= np.linalg.pinv(slope, rcond=1e-9) @ defect
            defect = self.defect(state).astype(float)
            if np.abs(defect).max() <= self.threshold:
                break
        return True
