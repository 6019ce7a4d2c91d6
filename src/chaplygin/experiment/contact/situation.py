"""From the tables of an experiment with friction to the body on its support, and its start."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ...contact.course.rules import Rules
from ...contact.equations.situation import FrictionalContact
from ...contact.friction.dry_friction import ContensouErismann, Coulomb, SpinFriction
from ...contact.friction.friction_law import FrictionLaw
from ...contact.friction.rolling_friction import (
    ContourResistance,
    RollingResistance,
    ViscousRolling,
)
from ...contact.friction.user_friction import UserFriction
from ...contact.friction.viscous_friction import NormalViscous, PowerFriction, Viscous
from ...contact.starts import start_in_contact, start_in_space
from ...core.arrays import FloatArray
from ...mechanics.rolling.surfaces import Plane, Sphere
from ..file.contact_tables import FrictionTable
from ..file.rolling_model import FrictionExperiment
from ..rolling import body_of, forces_of


def contact_and_rules(experiment: FrictionExperiment) -> tuple[FrictionalContact, Rules]:
    """The body on its support, and what happens at its events.

    Raises
    ------
    InputError
        If its parts do not fit together; the message names the place in the file.
    """
    body = body_of(experiment)
    table = experiment.surface
    surface = (
        Plane(table.turntable)
        if table.kind == "plane"
        else Sphere(table.radius, table.side, table.turntable)
    )
    field = forces_of(experiment)
    with experiment.placing_errors("contact"):
        contact = FrictionalContact(body, surface, _laws(experiment.contact), field)
        rules = Rules(
            experiment.contact.restitution,
            experiment.contact.impact_law,
            experiment.run.on_liftoff,
            experiment.contact.on_paradox,
        )
    return contact, rules


def start_of(contact: FrictionalContact, values: Mapping[str, Any]) -> FloatArray:
    """The state that follows from a start, in contact or above the support.

    Parameters
    ----------
    contact : FrictionalContact
    values : mapping
        The keys of [start] that are given.

    Raises
    ------
    InputError
        If the start cannot be used.
    """
    if "position" in values:
        return start_in_space(contact, **values)
    return start_in_contact(contact, **values)


def _laws(table: FrictionTable) -> tuple[FrictionLaw, ...]:
    """The laws of a table; coefficients of zero make none."""
    laws: list[FrictionLaw] = []
    if table.patch is not None and table.mu is not None:
        laws.append(ContensouErismann(table.mu, table.patch))
    elif table.mu:
        laws.append(Coulomb(table.mu))
    if table.spin_arm:
        laws.append(SpinFriction(table.spin_arm))
    if table.viscous or table.spin_viscous:
        laws.append(Viscous(table.viscous or 0.0, table.spin_viscous or 0.0))
    if table.slip and table.slip_order not in (None, 1.0):
        laws.append(PowerFriction(table.slip, table.slip_order))
    elif table.slip:
        laws.append(NormalViscous(table.slip))
    if table.force is not None:
        laws.append(UserFriction(table.force, table.couple or 0, table.mu_static, table.values))
    if table.rolling:
        laws.append(RollingResistance(table.rolling))
    if table.rolling_viscous:
        laws.append(ViscousRolling(table.rolling_viscous))
    if table.contour:
        laws.append(ContourResistance(table.contour))
    return tuple(laws)
