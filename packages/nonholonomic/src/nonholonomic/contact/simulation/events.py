"""Events of a motion in contact."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from flowlanes.system.arrays import FloatArray

EventKind = Literal[
    "stick",
    "slip",
    "direct restart",
    "spin stop",
    "spin start",
    "spin reversal",
    "lift-off",
    "landing",
    "impact without collision",
    "rolling stop",
    "rolling start",
    "rolling reversal",
    "rest",
]


@dataclass(frozen=True, eq=False)
class ContactEvent:
    """A change of the contact.

    Attributes
    ----------
    time : float
    kind : str
        ``"stick"``: sliding ends; ``"slip"``: it begins; ``"direct restart"``: it ends and begins
        again at once; ``"spin stop"``, ``"spin start"``, ``"spin reversal"`` the same for the spin,
        and for rolling; ``"lift-off"``, ``"landing"``, ``"impact without collision"``; ``"rest"``:
        all motion ends.
    mode : str
        The mode that follows.
    before, after : array (size,)
        States before and after the event.
    impulse : array (3,)
        Impulse of the support on the body, body axes (N s); zero except for impacts.
    couple_impulse : float
        Impulse of the couple about the normal (N m s).
    unique : bool
        False if the laws of friction allow another motion after it.

    Examples
    --------
    >>> import numpy as np
    >>> from nonholonomic.contact.simulation.events import ContactEvent
    >>> print(ContactEvent(0.25, "stick", "rolling", np.zeros(17), np.zeros(17)))
    t = 0.25: stick, then rolling
    """

    time: float
    kind: EventKind
    mode: str
    before: FloatArray
    after: FloatArray
    impulse: FloatArray = field(default_factory=lambda: np.zeros(3))
    couple_impulse: float = 0.0
    unique: bool = True

    def __str__(self) -> str:
        return f"t = {self.time:.9g}: {self.kind}, then {self.mode}"
