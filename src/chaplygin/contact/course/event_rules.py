"""The rules for events of a motion in contact: impacts, lift-off, Painlevé's paradox."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from ...arguments import arguments_checked
from ...errors import InputError
from ..impact.impact_law import ImpactLaw

OnLiftoff = Literal["fly", "stop"]
OnParadox = Literal["stop", "impact"]

#: The greatest tolerance: slips are followed to 1e-8 of a typical speed, which must be no rounding.
COARSEST_WITH_FRICTION = 1e-10


@arguments_checked
@dataclass(frozen=True)
class EventRules:
    """The rules for events: a body leaves its support, lands, or has no motion in contact.

    Parameters
    ----------
    restitution : float
        Of impacts, between 0 and 1.
    impact_law : str
        What the restitution means: ``"stronge"``, ``"poisson"`` or ``"newton"``.
    on_liftoff : str
        Whether a body that leaves its support flies on (``"fly"``) or the motion ends (``"stop"``).
    on_paradox : str
        Whether a motion ends where none in contact is possible (``"stop"``), or takes an impact
        without collision (``"impact"``).
    most_events : int
        Number of events after which a motion ends.

    Raises
    ------
    InputError
        If the restitution is not between 0 and 1, or a motion is allowed no event.

    Examples
    --------
    >>> from chaplygin.contact import EventRules
    >>> EventRules(restitution=0.6).on_liftoff
    'fly'
    """

    restitution: float = 0.0
    impact_law: ImpactLaw = "stronge"
    on_liftoff: OnLiftoff = "fly"
    on_paradox: OnParadox = "stop"
    most_events: int = 100_000

    def __post_init__(self) -> None:
        if not 0 <= self.restitution <= 1:
            raise InputError(f"restitution {self.restitution}: it must lie between 0 and 1")
        if self.most_events < 1:
            raise InputError(f"most_events {self.most_events}: it must be at least 1")
