"""The body with friction described by an experiment file."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import mpmath
import numpy as np

from flowlanes.errors import InputError
from flowlanes.printing.numerals import number
from flowlanes.system.arrays import FloatArray
from flowlanes.system.laws import Law
from flowlanes.system.system import System
from nonholonomic.contact.dataset import work_meanings
from nonholonomic.contact.equations.equations_of_motion import contact_equations
from nonholonomic.contact.equations.situation import FrictionalContact
from nonholonomic.contact.friction.air_film import AirFilm
from nonholonomic.contact.friction.dry_friction import ContensouErismann, Coulomb, SpinFriction
from nonholonomic.contact.friction.friction_law import FrictionLaw
from nonholonomic.contact.friction.modes import Mode
from nonholonomic.contact.friction.rolling_friction import (
    ContourResistance,
    RollingResistance,
    ViscousRolling,
)
from nonholonomic.contact.friction.user_friction import UserFriction
from nonholonomic.contact.friction.viscous_friction import NormalViscous, PowerFriction, Viscous
from nonholonomic.contact.simulation.compiled import OMEGA, VELOCITY, CompiledContact
from nonholonomic.contact.simulation.event_rules import EventRules
from nonholonomic.contact.starts import SLACK, clearance
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.shapes.surfaces import Surface
from nonholonomic.starts import initial_state
from nonholonomic.system_files.body_objects import body_of, forces_of
from nonholonomic.system_files.open_kinds import KindTable
from nonholonomic.system_files.sourced import identifier

from ..contact.trajectory import ContactTrajectory, contact_trajectory
from ..file.contact_tables import FrictionTable
from ..file.tables import CommonRunTable
from ..models.rolling_model import FrictionExperiment
from .glossary import glossary
from .subject import Subject, Variables

#: Letters of a sliding body, in body axes, besides those of every body on a surface.
_LETTERS = {
    "attitude": "unit quaternion that turns body axes into space axes",
    "position": "centre of mass in space",
    "v": "velocity of the centre of mass",
    "gamma": "outward normal of the support",
    "N": "normal force",
    "A": "acceleration of the contact point by a unit force there",
    "acceleration": "that of the centre of mass without contact force",
    "angular_acceleration": "that without contact force",
    "contact_velocity": "that of the body's point in contact",
    "slip": "velocity of the body's point in contact over the support",
    "slip_speed": "length of the slip",
    "slip_rate": "rate of the slip without contact force",
    "spin": "angular velocity about γ",
    "rolling": "the rest of ω",
    "rolling_speed": "length of the rolling",
    "wandering": "velocity of the contact point over the body",
    "contour_couple": "couple along the contour by a unit coefficient and a unit normal force",
    "reaction": "force of the support",
    "couple": "couple of the support",
    "friction": "tangential force of the support",
    "force_share": "friction over μN by a unit slip",
    "couple_share": "couple of friction over μN and the radius of the patch",
    "normal_rate": "part of bₙ that the rate of γ gives",
    "normal_rate_free": "acceleration of the contact along γ without normal force",
    "normal_response": "acceleration of the contact along γ by a unit normal force alone",
    "work_impact": "work lost in impacts",
}

_ONE_MODE = (
    "These are the equations of one mode of the contact, {mode}. They change where friction holds "
    "the contact or lets it go, and where the body leaves its support or lands; a run follows the "
    "motion through these events."
)

#: Range of validity of the formulas of force and couple shares, as the end of a sentence.
_INNER = " with a slip below the speed of the edge of the patch, u < patch |spin|"


@dataclass(frozen=True, kw_only=True)
class ContactSubject(Subject):
    """A body on a support that it touches with friction, and may leave.

    Attributes
    ----------
    contact : FrictionalContact
        Body, support, laws of friction and forces.
    rules : EventRules
        Rules for lift-off, landing and states without a motion in contact.
    """

    contact: FrictionalContact
    rules: EventRules

    changes_equations: ClassVar[bool] = True

    @property
    def claims(self) -> tuple[tuple[System, Law], ...]:
        """The laws of each mode of the contact that can be proved."""
        from nonholonomic.contact.invariants.provable_laws import provable_laws

        return provable_laws(self.contact)

    @property
    def body(self) -> Body:
        """The body."""
        return self.contact.body

    @property
    def surface(self) -> Surface:
        """The plane or sphere that it touches."""
        return self.contact.surface

    @property
    def start_words(self) -> Variables:
        """Meaning and unit of position and direction at the start."""
        return {
            "position": ("centre of mass", "m"),
            "heading": ("angle by which the body is turned about the normal", "rad"),
            "normal": ("normal of the support at the contact, in space", ""),
        }

    @property
    def setting(self) -> str:
        """The body, its support, the laws of friction and the forces."""
        return _setting(self.contact)

    @property
    def summary(self) -> str:
        """Empty, since the setting describes the system."""
        return ""

    @property
    def remarks(self) -> tuple[str, ...]:
        """Sentences on unusual properties of the body and its start."""
        with contextlib.suppress(InputError):
            return (*super().remarks, *self._remarks_on_start())
        return super().remarks

    def _remarks_on_start(self) -> tuple[str, ...]:
        if "position" not in self.start_values:
            return ()
        known = clearance(
            self.contact, self.start_vector("position"), self.start_vector("attitude")
        )
        if known.gap > SLACK * float(np.linalg.norm(known.r)):
            return ()
        state = self._state()
        turning = np.cross(state[OMEGA], known.r)
        speed = -float(known.gamma @ (state[VELOCITY] + turning))
        falling = math.sqrt(self.contact.field.gravity * float(np.linalg.norm(known.r)))
        moving = float(np.linalg.norm(state[VELOCITY]) + np.linalg.norm(turning))
        if speed <= SLACK * (falling + moving):
            return ()
        return (
            f"the body touches its support at the start and moves into it with {speed:.6g} m/s; "
            "the motion begins with an impact",
        )

    @property
    def directions(self) -> set[str]:
        """γ and the attitude."""
        return {"gamma", "attitude"}

    def initial_state(self) -> tuple[mpmath.mpf, ...]:
        """The state that follows from the start, in contact or above the support."""
        return tuple(map(mpmath.mpf, self._state().tolist()))

    def _state(self) -> FloatArray:
        return start_of(self.contact, self.start_values)

    @property
    def legend(self) -> str:
        """The meaning of the letters of its equations."""
        lost = {f"work_{law.name}": "work lost to this law" for law in self.contact.laws}
        return glossary(self.system, True, _LETTERS | lost)

    @property
    def derivation_notes(self) -> tuple[str, ...]:
        """A sentence on the mode whose equations are shown."""
        mode = shown_mode(self.contact)
        return (_ONE_MODE.format(mode=mode.name + (_INNER if mode.range else "")),)

    @property
    def weight(self) -> float | None:
        """m g under gravity."""
        return self.contact.body.mass * self.contact.field.gravity or None

    @property
    def state_names(self) -> list[str]:
        """Centre of mass, its velocity, ω and γ."""
        return ["centre", "velocity", "omega", "gamma"]

    @property
    def recorded_names(self) -> list[str]:
        """Slip, spin, forces and energy."""
        return ["slip", "spin", "normal_force", "friction_force", "gap", "energy"]

    def trajectory(
        self,
        system: System,
        start: Sequence[mpmath.mpf],
        times: FloatArray,
        run: CommonRunTable,
        dense: bool,
        progress: Callable[[float], None] | None,
    ) -> ContactTrajectory:
        """The motion through all its events.

        Raises
        ------
        InputError
            If there is no motion from the start, or a continuous trajectory is asked for.
        RunError
            If the motion ends early, except at a lift-off at which it was to stop; it carries the
            trajectory so far.
        """
        if dense:
            raise InputError("dense: a motion with friction is in pieces; ask for more samples")
        compiled = CompiledContact(self.contact, run.tolerance)
        state = np.array([float(x) for x in start])
        return contact_trajectory(compiled, system, state, times, self.rules, progress)


def shown_mode(contact: FrictionalContact) -> Mode:
    """The mode whose equations are shown: sliding, or rolling if nothing slips."""
    if contact.never_slips:
        return Mode(sliding=False)
    coupled = any(law.patch_radius for law in contact.laws)
    return Mode(range="inner" if coupled else "")


def contact_subject(experiment: FrictionExperiment) -> ContactSubject:
    """The body with friction of an experiment.

    Raises
    ------
    InputError
        If its parts do not fit together; the message names the place in the file.
    """
    contact, rules = contact_and_rules(experiment)
    body, surface = contact.body, contact.surface
    title = experiment.title or f"{body.shape.title} on {surface.title}, with friction"
    with experiment.placing_errors("body"):
        system = contact_equations(contact, shown_mode(contact))
    return ContactSubject(
        system=replace(system, name=identifier(title), title=title),
        start_values=experiment.start.model_dump(exclude_none=True),
        until=experiment.run.until,
        variables=work_meanings(contact, system),
        contact=contact,
        rules=rules,
    )


def _setting(contact: FrictionalContact) -> str:
    """The body, its support, the laws of friction and the forces in one line."""
    surface, field = contact.surface, contact.field
    ground = surface.setting
    if surface.turntable:
        ground += f", which turns with {number(surface.turntable, 6)} rad/s"
    force = f"gravity {number(field.gravity, 6)} m/s²" if field.gravity else "no gravity"
    if field.potential != 0:
        force += ", a potential U(γ)"
    if any(contact.body.gyrostat):
        force += "; with rotors"
    return f"{contact.body.shape.title} on {ground}; {contact.setting}; {force}"


def contact_and_rules(experiment: FrictionExperiment) -> tuple[FrictionalContact, EventRules]:
    """The body on its support, and the rules for its events.

    Raises
    ------
    InputError
        If its parts do not fit together; the message names the place in the file.
    """
    body = body_of(experiment)
    with experiment.placing_errors("surface"):
        surface = experiment.surface.surface()
    field = forces_of(experiment)
    with experiment.placing_errors("contact"):
        laws = _laws(experiment.contact, body, surface) + _added_laws(experiment)
        contact = FrictionalContact(body, surface, laws, field)
        rules = EventRules(
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
    return np.array(initial_state(contact, **values), dtype=float)


def _laws(table: FrictionTable, body: Body, surface: Surface) -> tuple[FrictionLaw, ...]:
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
    if table.air:
        radius = body.shape.edge_radius
        if radius is None or not surface.is_flat:
            raise InputError(
                "air: the drag of the air is that of the wedge between a disk and a plane; leave "
                "it out for other bodies and supports"
            )
        laws.append(AirFilm(table.air, radius))
    return tuple(laws)


def _added_laws(experiment: FrictionExperiment) -> tuple[FrictionLaw, ...]:
    """The laws of other modules, each of which has a table of its own."""
    laws: list[FrictionLaw] = []
    for word, row in experiment.contact.laws or ():
        if isinstance(row, KindTable):
            with experiment.placing_errors("contact", "laws", word):
                laws.append(row.made())
    return tuple(laws)
