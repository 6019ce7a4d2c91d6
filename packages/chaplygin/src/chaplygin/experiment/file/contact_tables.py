"""The tables of an experiment with friction: the contact, its support, the start and the run.

The description of a field completes the sentence "… must be", in errors and in documentation.
Units are SI, angles in radians.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Annotated, Literal

from pydantic import (
    AfterValidator,
    BeforeValidator,
    Field,
    StrictFloat,
    field_validator,
    model_validator,
)

from nonholonomic.contact.simulation.event_rules import COARSEST_WITH_FRICTION
from nonholonomic.system_files.open_kinds import KindTable, OpenTable
from nonholonomic.system_files.rolling_tables import PlaneTable, SphereTable
from nonholonomic.system_files.table import (
    DIRECTION,
    POSITIVE,
    THREE,
    TURN,
    Direction,
    NotNegative,
    Number,
    Positive,
    Quaternion,
    Table,
    Vector,
    or_formula,
)

from .tables import FINEST_DOUBLE, CommonRunTable

if TYPE_CHECKING:
    from nonholonomic.contact.friction.friction_law import FrictionLaw

COEFFICIENT = "a finite number not below zero"
FRICTION_COEFFICIENT = "a number not below zero, or inf"


def _infinity(value: object) -> object:
    """The word inf as a number."""
    return math.inf if value == "inf" else value


def _not_below_zero(value: float) -> float:
    if not value >= 0:
        raise ValueError(f"must be {FRICTION_COEFFICIENT}, not {value:g}")
    return value


FrictionCoefficient = Annotated[
    StrictFloat,
    Field(allow_inf_nan=True),
    or_formula(allow_inf_nan=True),
    BeforeValidator(_infinity),
    AfterValidator(_not_below_zero),
]


#: Laws of friction that have keys of their own in [contact].
_WITH_KEYS = frozenset(
    [
        *("coulomb", "contensou", "spin", "viscous", "slip", "power", "user"),
        *("rolling", "viscous_rolling", "contour", "air"),
    ]
)


#: Laws of friction that other modules have added.
def _laws_of_friction() -> type[FrictionLaw]:
    from nonholonomic.contact.friction.friction_law import FrictionLaw

    return FrictionLaw


LAWS = OpenTable(KindTable, _laws_of_friction, _WITH_KEYS)


class FrictionTable(Table):
    """The friction laws of a contact, which add up, and the behaviour in impacts."""

    model: Literal["friction"] = Field(description='"marble", "rubber" or "friction"')
    mu: FrictionCoefficient | None = Field(default=None, description=FRICTION_COEFFICIENT)
    """Coefficient of dry friction; inf for a contact that never slips."""
    spin_arm: NotNegative | None = Field(default=None, description=COEFFICIENT)
    """The friction couple against spin is at most this length (m) times the normal force."""
    patch: Positive | None = Field(default=None, description=POSITIVE)
    """Radius of the patch of contact (m), over which mu acts by Hertz' pressure."""
    viscous: NotNegative | None = Field(default=None, description=COEFFICIENT)
    """Viscous friction (kg/s): the force is this times the slip."""
    spin_viscous: NotNegative | None = Field(default=None, description=COEFFICIENT)
    """Viscous friction against spin (kg m²/s): the couple is this times the spin."""
    slip: NotNegative | None = Field(default=None, description=COEFFICIENT)
    """The force is this (s/m) times normal force and slip."""
    slip_order: Positive | None = Field(default=None, description=POSITIVE)
    """The power of the slip in the law of `slip`, 1 if it is not given."""
    force: str | None = Field(default=None, description="a formula")
    """Force for each unit of normal force: a formula in slip_speed, spin and normal_force."""
    couple: str | None = Field(default=None, description="a formula")
    """Couple against spin for each unit of normal force (m), besides `force`."""
    mu_static: NotNegative | None = Field(default=None, description=COEFFICIENT)
    """Coefficient of static friction, where it exceeds the limit of `force` at zero slip."""
    values: dict[str, Number] = Field(default_factory=dict, description="names with numbers")
    """Numbers for further names in `force` and `couple`."""
    rolling: NotNegative | None = Field(default=None, description=COEFFICIENT)
    """The couple against rolling is this length (m) times the normal force."""
    rolling_viscous: NotNegative | None = Field(default=None, description=COEFFICIENT)
    """The couple against rolling is this (m s) times normal force and angular velocity."""
    contour: NotNegative | None = Field(default=None, description=COEFFICIENT)
    """Power lost by the wandering contact point: this times normal force and its speed."""
    air: NotNegative | None = Field(default=None, description=COEFFICIENT)
    """Viscosity (Pa s) of the air in the wedge between a disk and the plane."""
    laws: Annotated[Table | None, LAWS] = Field(
        default=None, description="a table with a table for each law of another module"
    )
    """Laws of friction that other modules have added, by their kinds."""
    restitution: Annotated[StrictFloat, Field(ge=0, le=1), or_formula(ge=0, le=1)] = Field(
        default=0.0, description="a number from 0 to 1"
    )
    """Of impacts: 0 without bounce, 1 without loss."""
    impact_law: Literal["stronge", "poisson", "newton"] = Field(
        default="stronge", description='"stronge", "poisson" or "newton"'
    )
    """Whether restitution is that of work, impulse or velocity along the normal."""
    on_paradox: Literal["stop", "impact"] = Field(default="stop", description='"stop" or "impact"')
    """The continuation where no motion in contact is possible: end, or impact without collision."""

    @model_validator(mode="after")
    def _laws_together(self) -> FrictionTable:
        if self.patch is not None:
            if self.mu is None:
                raise ValueError("patch needs mu, the coefficient of friction on the patch")
            if not 0 < self.mu < math.inf:
                raise ValueError(
                    f"mu must be positive and finite with patch, not {self.mu:g}; leave out patch "
                    "for a contact at a point"
                )
            if self.spin_arm:
                raise ValueError(
                    "spin_arm and patch exclude each other: over a patch slip and spin share the "
                    "friction of mu; leave out one of them"
                )
        if self.slip_order is not None and self.slip is None:
            raise ValueError("slip_order needs slip, the coefficient of its law")
        if self.force is None:
            for name in ("couple", "mu_static", "values"):
                if getattr(self, name):
                    raise ValueError(f"{name} needs force, the formula that it belongs to")
        elif self.mu is not None:
            raise ValueError(
                "force and mu exclude each other, as both resist sliding; leave out one"
            )
        if self.rolling and self.contour:
            raise ValueError(
                "rolling and contour exclude each other, as both resist rolling; leave out one "
                "of them"
            )
        return self


class FrictionPlaneTable(PlaneTable):
    """The plane z = 0 of space, at rest or turning about the z axis."""

    turntable: Number = Field(default=0.0, description="a finite angular velocity (rad/s)")


class FrictionSphereTable(SphereTable):
    """A sphere about the origin of space, at rest or turning about the z axis."""

    turntable: Number = Field(default=0.0, description="a finite angular velocity (rad/s)")


FrictionSurfaceTable = FrictionPlaneTable | FrictionSphereTable

#: Keys of the two kinds of start.
IN_CONTACT = ("gamma", "slip", "heading", "normal")
IN_SPACE = ("position", "attitude", "velocity")

WAYS = (
    "a start has either gamma, omega and slip (a body in contact), or position, attitude, velocity "
    "and omega"
)


class FrictionStartTable(Table):
    """The start of a body with friction: in contact, or anywhere in space."""

    gamma: Direction | None = Field(default=None, description=DIRECTION)
    """Outward normal of the surface at the contact, body axes; any length."""
    omega: Vector = Field(description=THREE)
    """Angular velocity, body axes."""
    slip: Vector | None = Field(default=None, description=THREE)
    """Velocity of the body's contact point over the support, body axes; zero by default."""
    heading: Number | None = Field(default=None, description="a finite angle (radians)")
    """Angle by which the body is turned about the normal; zero by default."""
    normal: Direction | None = Field(default=None, description=DIRECTION)
    """Outward normal of the surface at the contact, space axes; [0, 0, 1] by default."""
    position: Vector | None = Field(default=None, description=THREE)
    """Centre of mass, space axes."""
    attitude: Quaternion | None = Field(default=None, description=TURN)
    """Quaternion that turns body axes into space axes; any length."""
    velocity: Vector | None = Field(default=None, description=THREE)
    """Of the centre of mass, space axes."""

    @model_validator(mode="after")
    def _one_way(self) -> FrictionStartTable:
        given = self.model_dump(exclude_none=True)
        touching = [name for name in IN_CONTACT if name in given]
        free = [name for name in IN_SPACE if name in given]
        if touching and free:
            raise ValueError(f"{free[0]} and {touching[0]} are given together; {WAYS}")
        missing = [name for name in IN_SPACE if name not in given] if free else []
        if not free and self.gamma is None:
            missing = ["gamma"]
        if missing:
            raise ValueError(f"{' and '.join(missing)} missing; {WAYS}")
        return self


class FrictionRunTable(CommonRunTable):
    """The computation of a motion with friction: forward in time, in double precision."""

    until: Positive = Field(default=10.0, description="a positive finite time")
    precision: Literal["double"] = Field(default="double", description='"double" with friction')
    method: Literal["taylor"] = Field(default="taylor", description='"taylor" with friction')
    tolerance: Annotated[StrictFloat, Field(ge=FINEST_DOUBLE, le=COARSEST_WITH_FRICTION)] = Field(
        default=FINEST_DOUBLE,
        description=f"a number from {FINEST_DOUBLE:g} to {COARSEST_WITH_FRICTION:g} with friction",
    )
    direction: Literal["forward"] = Field(
        default="forward",
        description='"forward" with friction, whose motions do not determine their past',
    )
    on_liftoff: Literal["fly", "stop"] = Field(default="fly", description='"fly" or "stop"')
    """Whether a body that leaves its support flies on, or the run ends."""
    keep_integrals: Literal[False] = Field(
        default=False, description="false with friction, which has no integrals to keep"
    )
    time_limit: None = Field(default=None, description="left out with friction")

    @field_validator("on_liftoff", mode="before")
    @classmethod
    def _no_warning(cls, word: object) -> object:
        if word == "warn":
            raise ValueError(
                'must be "fly" or "stop" with friction: "warn" follows a body that its support '
                "pulls, and where it pulls there is no friction"
            )
        return word
