"""Events of a motion in contact."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ..core.arrays import FloatArray


@dataclass(frozen=True, eq=False)
class ContactEvent:
    """A change of the contact.

    Attributes
    ----------
    time : float
    kind : str
        ``"stick"``, ``"stop"``, ``"slip"``, ``"spin stop"``, ``"spin start"``, ``"spin reversal"``,
        ``"lift-off"``, ``"landing"``, ``"impact without collision"`` or ``"rest"``.
    mode : str
        The mode that follows.
    before, after : array (size,)
        States.
    impulse : array (3,)
        Of the support on the body, body axes (N s); zero but for impacts.
    couple_impulse : float
        About the normal (N m s).
    """

    time: float
    kind: str
    mode: str
    before: FloatArray
    after: FloatArray
    impulse: FloatArray = field(default_factory=lambda: np.zeros(3))
    couple_impulse: float = 0.0

    def __str__(self) -> str:
        return f"t = {self.time:.9g}: {self.kind}, then {self.mode}"
