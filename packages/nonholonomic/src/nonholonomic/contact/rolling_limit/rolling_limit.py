"""Rolling bodies as limits of sliding ones with viscosity tending to infinity.

Here the contact is two-sided: it does not end where the normal force changes its sign.  A motion
with initial slip u⁻ passes through a layer at t = 0, in which the contact force acts like the
impulse that stops the slip,

    J = −A⁻¹u⁻,      v⁺ = v⁻ + J/m,      ω⁺ = ω⁻ + I⁻¹(r×J + Kγ),

where K stops the spin if the body does not spin in the limit either, and is zero otherwise.  Of the
momentum about the contact point, Iω − m r×v, only the component along γ changes.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import System

from ...mechanics.rolling.body import Body
from ...mechanics.rolling.equations import Forces
from ...mechanics.shapes.surfaces import Plane
from ..equations.equations_of_motion import contact_equations
from ..equations.situation import FrictionalContact
from ..friction.dry_friction import Coulomb
from ..friction.modes import Mode
from ..friction.viscous_friction import Viscous
from ..impact.mobility import mobility
from ..simulation.compiled import NORMAL, OMEGA, VELOCITY, WORK


@arguments_checked
def start_of_limit(body: Body, state: Sequence[float] | FloatArray, spinning: bool) -> FloatArray:
    """The state after the layer in which unlimited friction stops the slip.

    Parameters
    ----------
    body : Body
        A body in contact with a plane at rest.
    state : sequence of float
        Attitude (quaternion), centre of mass (space axes), its velocity, ω and γ (body axes).
    spinning : bool
        Whether the body goes on spinning; a couple ends the spin if it does not.

    Returns
    -------
    array (16,)
        The state without slip, and without spin unless spinning continues.
    """
    before = np.array(state, dtype=float)[:WORK]
    v, omega, gamma = before[VELOCITY], before[OMEGA], before[NORMAL]
    r = body.shape.contact_points()(gamma[None])[0]
    responses = mobility(body.mass, body.tensor, r, gamma)
    slip = v + np.cross(omega, r)
    if spinning:
        impulse, couple = -np.linalg.solve(responses.A, slip), 0.0
    else:
        across = responses.spin_force[:, None]
        answers = np.block([[responses.A, across], [across.T, np.array([[responses.spin]])]])
        solution = -np.linalg.solve(answers, np.append(slip, gamma @ omega))
        impulse, couple = solution[:3], float(solution[3])
    after = before.copy()
    after[VELOCITY] += responses.velocity_jump(impulse)
    after[OMEGA] += responses.angular_velocity_jump(impulse, couple)
    return after


def two_sided(situation: FrictionalContact, mode: Mode) -> System:
    """The equations of a mode in which the contact lasts for every sign of the normal force."""
    return replace(contact_equations(situation, mode), guards=())


def states_without_work(
    system: System, start: FloatArray, times: FloatArray, values: dict[str, float]
) -> FloatArray:
    """States without the work columns (n, 16)."""
    whole = [*start, *([0.0] * (len(system.symbols) - WORK))]
    states: FloatArray = integrate(system, whole, [0.0, *times], parameters=values).states
    return states[1:, :WORK]


def rolling_states(
    body: Body, field: Forces, start: FloatArray, times: FloatArray, spinning: bool
) -> FloatArray:
    """States (n, 16) of the rolling body, with or without spin, starting after the layer."""
    ideal = FrictionalContact(body, Plane(), (Coulomb(math.inf),), field)
    system = two_sided(ideal, Mode(sliding=False, spinning=spinning))
    return states_without_work(system, start_of_limit(body, start, spinning), times, {})


def checked_state(state: Sequence[float]) -> tuple[float, ...]:
    """The 16 numbers of a start; raises InputError if there are fewer, or one is not finite."""
    numbers = tuple(float(x) for x in state[:WORK])
    if len(numbers) < WORK or not all(map(math.isfinite, numbers)):
        raise InputError(
            f"state: it has {len(state)} numbers; there must be 16 finite ones: attitude, centre "
            "of mass, its velocity, omega and gamma"
        )
    return numbers


@arguments_checked
@dataclass(frozen=True)
class ViscousContact:
    """A body on a plane with the force −c u and the couple −c s Ωγ, for increasing c.

    Parameters
    ----------
    body : Body
    state : sequence of float
        The start: attitude (quaternion), centre of mass (space axes), its velocity, ω and γ (body
        axes), in contact; with or without slip.
    coefficients : sequence of float
        c, increasing (kg/s).
    spin_share : float
        s (m²).  Zero for the marble body as the limit, positive for the rubber body.
    field : Forces

    Raises
    ------
    InputError
        If the share is negative, or the state has fewer than 16 numbers.

    Examples
    --------
    A ball whose centre of mass lies 0.2 off its centre, started without slip:

    >>> import nonholonomic
    >>> from nonholonomic.contact.rolling_limit.rolling_limit import ViscousContact
    >>> ball = nonholonomic.Body(1.0, (0.4, 0.4, 0.4), nonholonomic.Ball(1.0, centre=(0.2, 0, 0)))
    >>> state = (1, 0, 0, 0, 0, 0, 1, 1, 0, -0.2, 0, 1, 0, 0, 0, 1)
    >>> ViscousContact(ball, state, (100, 200)).description
    'sliding with viscosity c → ∞, against rolling'
    """

    body: Body
    state: Sequence[float]
    coefficients: tuple[float, ...]
    spin_share: float = 0.0
    field: Forces = Forces(gravity=9.81)  # noqa: RUF009  (immutable)

    def __post_init__(self) -> None:
        object.__setattr__(self, "coefficients", tuple(map(float, self.coefficients)))
        object.__setattr__(self, "state", checked_state(self.state))
        if not (math.isfinite(self.spin_share) and self.spin_share >= 0):
            raise InputError(f"spin_share {self.spin_share}: it must be a finite number, 0 or more")

    @property
    def description(self) -> str:
        """A description of the family and its limit."""
        limit = "rolling without spin" if self.spin_share else "rolling"
        return f"sliding with viscosity c → ∞, against {limit}"

    @property
    def system(self) -> System:
        """The equations with the viscosity as parameters ``c_v`` and ``c_s``."""
        laws = (Viscous(1.0, self.spin_share),)
        return two_sided(FrictionalContact(self.body, Plane(), laws, self.field), Mode())

    @arguments_checked
    def motion(self, coefficient: float, times: FloatArray) -> FloatArray:
        """Attitude, centre of mass, velocity, ω and γ (n, 16)."""
        values = {"c_v": coefficient, "c_s": coefficient * self.spin_share}
        return states_without_work(self.system, np.array(self.state), times, values)

    @arguments_checked
    def limit(self, times: FloatArray) -> FloatArray:
        """The states of the body that rolls (n, 16)."""
        return rolling_states(
            self.body, self.field, np.array(self.state), times, spinning=not self.spin_share
        )

    @arguments_checked
    def normal_force(self, coefficient: float, times: FloatArray) -> FloatArray:
        """Normal force (N) at given times (n,); it may be negative in the layer."""
        values = {"c_v": coefficient, "c_s": coefficient * self.spin_share}
        whole = [*self.state, *([0.0] * (len(self.system.symbols) - WORK))]
        motion = integrate(self.system, whole, [0.0, *times], parameters=values)
        force: FloatArray = motion["normal_force"][1:]
        return force
