"""Rolling as the limit of dry friction with a coefficient that tends to infinity.

Dry friction is not a small perturbation of rolling: as soon as the force needed for rolling is less
than μN, the body rolls exactly.  Only the time until then depends on μ; it is of order 1/μ.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.system.arrays import FloatArray

from ...mechanics.rolling.body import Body
from ...mechanics.rolling.equations import Forces
from ...mechanics.shapes.surfaces import Plane
from ..equations.equations_of_motion import contact_equations
from ..equations.situation import FrictionalContact
from ..friction.dry_friction import Coulomb
from ..friction.modes import Mode
from ..simulation.compiled import WORK
from .rolling_limit import checked_state, rolling_states


@arguments_checked
@dataclass(frozen=True)
class DryContact:
    """A body on a plane with dry friction and initial slip, for increasing μ.

    A body whose contact does not lie below its centre of mass has no such limit: for large μ it
    meets Painlevé's paradox.

    Parameters
    ----------
    body : Body
    state : sequence of float
        The start: attitude (quaternion), centre of mass (space axes), its velocity, ω and γ (body
        axes), in contact and with a slip.
    coefficients : sequence of float
        μ, increasing.
    field : Forces

    Raises
    ------
    InputError
        If the state has fewer than 16 numbers.

    Examples
    --------
    >>> import nonholonomic
    >>> from nonholonomic.contact.rolling_limit.dry_limit import DryContact
    >>> ball = nonholonomic.Body(1.0, (0.4, 0.5, 0.6), nonholonomic.Ball(1.0))
    >>> state = (1, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 1)
    >>> DryContact(ball, state, (1, 2)).description
    'dry friction with μ → ∞, against rolling'
    """

    body: Body
    state: Sequence[float]
    coefficients: tuple[float, ...]
    field: Forces = Forces(gravity=9.81)  # noqa: RUF009  (immutable)

    def __post_init__(self) -> None:
        object.__setattr__(self, "coefficients", tuple(map(float, self.coefficients)))
        object.__setattr__(self, "state", checked_state(self.state))

    @property
    def description(self) -> str:
        """A description of the family and its limit."""
        return "dry friction with μ → ∞, against rolling"

    @arguments_checked
    def motion(self, coefficient: float, times: FloatArray) -> FloatArray:
        """Attitude, centre of mass, velocity, ω and γ (n, 16).

        Raises
        ------
        InputError
            If the body still slides at the first moment, or friction cannot hold it afterwards.
        """
        situation = FrictionalContact(self.body, Plane(), (Coulomb(coefficient),), self.field)
        sliding = contact_equations(situation, Mode())
        stick = tuple(guard for guard in sliding.guards if guard.name == "stick")
        start = [*self.state, *([0.0] * (len(sliding.symbols) - WORK))]
        slide = integrate(replace(sliding, guards=stick), start, [0.0, times[0]])
        if not slide.events:
            raise InputError(
                f"mu {coefficient:g}: the body still slides at t = {times[0]:g}; compare the "
                "motions later"
            )
        stop, state = float(slide.times[-1]), slide.states[-1]
        held = contact_equations(situation, Mode(sliding=False))
        rolling = integrate(replace(held, guards=()), [*state], [0.0, *(times - stop)])
        force = np.linalg.norm(rolling["friction_force"], axis=1)
        if np.any(force > coefficient * rolling["normal_force"]):
            raise InputError(f"mu {coefficient:g}: the body slides again after t = {stop:.9g}")
        states: FloatArray = rolling.states[1:, :WORK]
        return states

    @arguments_checked
    def limit(self, times: FloatArray) -> FloatArray:
        """The states of the body that rolls (n, 16)."""
        return rolling_states(self.body, self.field, np.array(self.state), times, spinning=True)
