"""Rotation numbers on a section, for many motions at once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import sympy as sp

from ..arguments import Positive, arguments_checked
from ..flow.devices.graphics import Device
from ..flow.kernel.equations import Section
from ..flow.sections.poincare_map import PoincareMap
from ..orbits.return_map import rotations
from ..system.arrays import FloatArray, IntArray
from ..system.parameters import Parameters
from ..system.system import System
from ..system.tolerance import ENSEMBLE_TOLERANCE


@arguments_checked
@dataclass(frozen=True)
class Winding:
    """The winding number of an angle per return, with an error estimate.

    Attributes
    ----------
    system : System
    t_end : float
        Time after which a motion without enough returns is abandoned.
    formula : sympy.Expr
        An angle in radians, modulo full turns.
    section : Section
        The section.
    tolerance : float
        See :mod:`flowlanes.system.tolerance`.
    count : int
        Number of returns.
    device : "cpu" or "gpu"
        Where the motions are computed.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> phi, w = sp.symbols("phi w", real=True)
    >>> rotor = flowlanes.System("rotor", "Rotor", {phi: w, w: 0})
    >>> once = flowlanes.poincare_section(rotor, "phi", angle=True)
    >>> flowlanes.scans.Winding(rotor, 100.0, 2 * phi, once, count=20).extra_columns
    {'error': 'difference between the halves of the motion'}
    """

    system: System
    t_end: Positive
    formula: sp.Expr
    section: Section
    tolerance: Positive = ENSEMBLE_TOLERANCE
    count: int = 500
    device: Device = "cpu"
    extra_columns: ClassVar[Mapping[str, str]] = {
        "error": "difference between the halves of the motion"
    }

    @arguments_checked
    def __call__(
        self, starts: FloatArray, parameters: Parameters
    ) -> dict[str, FloatArray | IntArray]:
        """Arrays (n,) of values, errors and outcomes; there are no end times."""
        returning = PoincareMap(
            self.system,
            self.section,
            dict(parameters),
            self.tolerance,
            t_end=self.t_end,
            device=self.device,
        )
        result = rotations(returning, starts, self.formula, self.count)
        return {
            "value": result.values,
            "error": result.errors,
            # An angle without a lift has no rotation number; the motion itself did not end.
            "outcome": np.maximum(result.outcome, 0),
            "ended": np.full(len(starts), np.nan),
        }
