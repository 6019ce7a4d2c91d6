"""The laws that can be proved for a body on its support, depending on its friction laws.

The normal force is unspecified, so each law holds through all changes of the contact, in impacts
and in flight.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.laws import Integral, Law
from flowlanes.system.named_formulas import scalars
from flowlanes.system.system import System
from flowlanes.system.vectors import zero

from ..equations.situation import FrictionalContact
from ..friction.friction_law import FrictionLaw
from ..friction.modes import Mode
from .dissipation import decrease_of_energy
from .free_contact import ANY_COUPLE, couple_on_jellett, free_contact, jellett, power
from .sliding_ball import (
    ANY_COUPLE as ANY_SPIN_COUPLE,
    ANY_FORCE,
    against_slip,
    ball_parameters,
    momenta,
    sliding_ball,
    slip_direction,
)

Claim = tuple[System, Law]


def provable_laws(contact: FrictionalContact) -> tuple[Claim, ...]:
    """Conserved and dissipated quantities of a body with friction, each with its system.

    Parameters
    ----------
    contact : FrictionalContact

    Returns
    -------
    tuple of (System, Law)
        Jellett's integral of a spherical body of revolution, or how couples change it; momentum
        about the contact and direction of slip of a homogeneous ball; on a support at rest the
        power of the contact and the share of each friction law. For bodies on spheres or in a
        potential only the last is known.

    Examples
    --------
    >>> import nonholonomic
    >>> from nonholonomic.contact import Coulomb, FrictionalContact
    >>> from nonholonomic.contact.invariants.provable_laws import provable_laws
    >>> top = nonholonomic.Body(1.0, (0.4, 0.4, 0.3), nonholonomic.Ball(1.0, centre=(0, 0, 0.2)))
    >>> contact = FrictionalContact(
    ...     top, laws=(Coulomb(0.2),), field=nonholonomic.Forces(gravity=9.81)
    ... )
    >>> [law.name for _, law in provable_laws(contact)]
    ['jellett', 'power', 'coulomb_power']
    """
    at_rest = contact.surface.turntable == 0
    losses = _dissipation_laws(contact.laws) if at_rest else ()
    if not contact.surface.is_flat or contact.field.potential != 0:
        return losses
    kept = (*_top_laws(contact), *_ball_laws(contact))
    if not at_rest or contact.body.shape.by_equation:
        return kept
    gravity = contact.field.gravity
    free = free_contact(contact.body, gravity, couple=ANY_COUPLE)
    return (*kept, (free, power(contact.body)), *losses)


def _dissipation_laws(laws: tuple[FrictionLaw, ...]) -> tuple[Claim, ...]:
    """The power that each law dissipates, where it is a sum of nonnegative products."""
    claims = []
    for law in laws:
        try:
            claims.append(decrease_of_energy(law))
        except InputError:  # formulas of the user may give energy
            continue
    return tuple(claims)


def _has_couple(contact: FrictionalContact) -> bool:
    for law in contact.laws:
        absent = {p.symbol: 0 for p in law.parameters if p.default == 0}
        reaction = law.reaction(Mode(range="inner"))
        parts = scalars((reaction.q, reaction.couple))
        if any(sp.sympify(part).xreplace(absent) != 0 for part in parts):
            return True
    return False


def _top_laws(contact: FrictionalContact) -> tuple[Claim, ...]:
    """Jellett's integral, or the rate at which couples change it."""
    body = contact.body
    if not body.shape.is_ball or not body.principal:
        return ()
    first, second = body.inertia[:2]
    if first != second or any(body.shape.centre[:2]) or any(body.gyrostat[:2]):
        return ()
    gravity = contact.field.gravity
    if _has_couple(contact):
        return ((free_contact(body, gravity, couple=ANY_COUPLE), couple_on_jellett(body)),)
    return ((free_contact(body, gravity), jellett(body)),)


def _ball_laws(contact: FrictionalContact) -> tuple[Claim, ...]:
    """Momentum about the contact, and the direction of the slip, of a homogeneous ball."""
    body, laws = contact.body, contact.laws
    if not body.shape.is_balanced_ball or any(law.resists_rolling for law in laws):
        return ()
    if not body.principal or len(set(body.inertia)) > 1 or any(body.gyrostat):
        return ()
    moment = float(body.tensor[0, 0])
    numbers = ball_parameters(body.mass, moment, body.shape.half_breadth, contact.field.gravity)
    couple = ANY_SPIN_COUPLE if _has_couple(contact) else zero[0, 0]
    ball = sliding_ball(ANY_FORCE, couple, numbers)
    kept: tuple[Integral, ...] = momenta()[: 2 if _has_couple(contact) else 3]
    claims: tuple[Claim, ...] = tuple((ball, law) for law in kept)
    if contact.surface.turntable == 0:
        sliding = sliding_ball(against_slip(), couple, numbers)
        sliding = replace(sliding, title="Homogeneous ball under any force against its slip")
        claims += tuple((sliding, law) for law in slip_direction())
    return claims
