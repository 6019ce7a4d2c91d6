"""Rules for the events of a motion in contact: impacts, lift-off, Painlevé's paradox."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError

from ..impact.impact_law import ImpactLaw
from .end_reasons import EndError, EndReason

OnLiftoff = Literal["fly", "stop"]
OnParadox = Literal["stop", "impact"]

#: Coarsest tolerance: slips are followed down to 1e-8 of a typical speed, which must stay well
#: above the error of a step.
COARSEST_WITH_FRICTION = 1e-10

#: A motion ends early if, judged by its first steps, it would take more than OUT_OF_REACH times
#: the allowed number of steps; FIRST_PART is the fraction of the allowed steps after which this is
#: judged.
OUT_OF_REACH, FIRST_PART = 4.0, 0.02


@arguments_checked
@dataclass(frozen=True)
class EventRules:
    """What happens when a body leaves its support, lands, or has no motion in contact.

    Parameters
    ----------
    restitution : float
        Coefficient of restitution of impacts, between 0 and 1.
    impact_law : str
        Definition of the coefficient: ``"stronge"``, ``"poisson"`` or ``"newton"``.
    on_liftoff : str
        Whether a body that leaves its support flies on (``"fly"``) or the motion ends (``"stop"``).
    on_paradox : str
        Whether a motion ends where none in contact is possible (``"stop"``), or takes an impact
        without collision (``"impact"``).
    most_events, most_steps : int
        Maximum numbers of events and of integration steps; a motion ends earlier if it would
        certainly take more than `OUT_OF_REACH` times these steps.

    Raises
    ------
    InputError
        If the restitution is not between 0 and 1, or a motion is allowed no event or no step.

    Examples
    --------
    >>> from nonholonomic.contact import EventRules
    >>> EventRules(restitution=0.6).on_liftoff
    'fly'
    """

    restitution: float = 0.0
    impact_law: ImpactLaw = "stronge"
    on_liftoff: OnLiftoff = "fly"
    on_paradox: OnParadox = "stop"
    most_events: int = 20_000
    most_steps: int = 1_000_000

    def __post_init__(self) -> None:
        if not 0 <= self.restitution <= 1:
            raise InputError(f"restitution {self.restitution}: it must lie between 0 and 1")
        for name, most in (("most_events", self.most_events), ("most_steps", self.most_steps)):
            if most < 1:
                raise InputError(f"{name} {most}: it must be at least 1")

    def require_few(
        self,
        events: int,
        steps: int,
        begin: float,
        time: float,
        end: float,
        turning: float,
        speed: float,
    ) -> None:
        """End a motion that takes too many events or steps, or certainly will.

        Parameters
        ----------
        events, steps : int
            Numbers up to the present time.
        begin, time, end : float
        turning, speed : float
            Angular velocity and speed of the body at that time, in rad/s and m/s.

        Raises
        ------
        EndError
            With the numbers taken, and advice to reduce them.
        """
        passed, left = time - begin, end - time
        ending: EndReason = "many events" if events > self.most_events else "many steps"
        name, count, most = "steps", steps, self.most_steps
        if ending == "many events":
            name, count, most = "events", events, self.most_events
        first = steps >= FIRST_PART * most and steps * left > OUT_OF_REACH * most * passed
        if not left or not (count >= most or first):
            return
        whole = "" if count >= most else f", of about {steps * (1 + left / passed):.1g} in all,"
        raise EndError(
            ending,
            f"the motion took {count:,} {name}{whole} up to t = {time:.9g}, where the body turns "
            f"with {turning:.3g} rad/s and moves with {speed:.3g} m/s, and {most:,} are allowed: "
            "start it more slowly, follow it for a shorter time, or, in Python, allow more "
            f"(EventRules(most_{name}=…))",
        )
