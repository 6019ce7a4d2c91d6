"""Projection of a state onto its phase space.

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
        Residuals from a state and the parameters, in working precision.
    slope : callable
        Derivatives with respect to the corrected columns, in doubles, row by row.
    count : int
        Number of residuals.
    """

    residual: Callable[[WorkingArray, WorkingArray], WorkingArray]
    slope: Callable[[FloatArray, FloatArray], FloatArray]
    count: int


@dataclass(frozen=True)
class Projector:
    """Projection of some columns of a state, such that residuals have their target values.

    Attributes
    ----------
    blocks : tuple of Block
    columns : slice
        Columns of the state that are corrected.
    parameters : array
        Parameter values in working precision.
    threshold : float
        Smaller residuals are not corrected.
    target : array or None
        Target values of the residuals instead of zero.
    """

    blocks: tuple[Block, ...]
    columns: slice
    parameters: WorkingArray
    threshold: float
    target: WorkingArray | None = None

    def values(self, state: WorkingArray) -> WorkingArray:
        """All residuals at a state."""
        return np.concatenate([b.residual(state, self.parameters) for b in self.blocks])

    def defect(self, state: WorkingArray) -> WorkingArray:
        """Residuals minus their targets."""
        values = self.values(state)
        return values if self.target is None else values - self.target

    def __call__(self, state: WorkingArray) -> bool:
        """Project `state` in place; True if it was changed."""
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
