"""The tables of surface, contact and forces of a body that rolls on a plane or a sphere."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar, Literal

from pydantic import Field, ValidationInfo, field_validator, model_validator

from ..mechanics import shapes
from .open_kinds import KindTable, OpenKinds
from .table import FORMULA, POSITIVE, SIDES, FormulaTable, NotNegative, SphereRadius, Table

if TYPE_CHECKING:
    from ..mechanics.shapes.surfaces import Surface


class SurfaceTable(KindTable):
    """A surface at rest."""

    surface_class: ClassVar[str]
    """The name of the class, which is imported when a surface is made of the table."""

    kind: str

    def surface(self) -> Surface:
        """The surface, whose attributes have the names of the keys.

        Raises
        ------
        InputError
            If a number is not admissible.
        """
        if self.described is not None:
            made: Surface = self.made()
            return made
        surface: Surface = getattr(shapes, self.surface_class)(**self.model_dump(exclude={"kind"}))
        return surface

    @property
    def sphere(self) -> tuple[float, bool] | None:
        """Radius of a sphere and whether the body is inside; None of another surface."""
        return None

    @model_validator(mode="before")
    @classmethod
    def _at_rest(cls, table: object) -> object:
        if isinstance(table, dict) and "turntable" in table.keys() - cls.model_fields.keys():
            raise ValueError(
                "turntable is for a contact with friction; a body rolls without slipping on a "
                'surface at rest alone (contact.model = "friction" has both)'
            )
        return table


class PlaneTable(SurfaceTable):
    """The horizontal plane z = 0 of space."""

    surface_class = "Plane"

    kind: Literal["plane"] = "plane"


class SphereTable(SurfaceTable):
    """A sphere about the origin of space, with the body outside or inside."""

    surface_class = "Sphere"

    kind: Literal["sphere"] = "sphere"
    radius: SphereRadius = Field(description=POSITIVE)
    side: Literal["outside", "inside"] = Field(default="outside", description=SIDES)
    """The side on which the body rolls: the outside, or the inside of a bowl."""

    @property
    def sphere(self) -> tuple[float, bool]:
        """Radius, and whether the body is inside."""
        return self.radius, self.side == "inside"


SURFACES = OpenKinds(SurfaceTable, (PlaneTable, SphereTable), lambda: shapes.Surface)


#: Keys of [contact] that apply only to a contact with friction.
FRICTION_KEYS = (
    "mu",
    "spin_arm",
    "patch",
    "viscous",
    "spin_viscous",
    "slip",
    "slip_order",
    "force",
    "couple",
    "mu_static",
    "values",
    "rolling",
    "rolling_viscous",
    "contour",
    "air",
    "laws",
    "restitution",
    "impact_law",
    "on_paradox",
)


class ContactTable(Table):
    """The contact: ``marble`` does not slip, ``rubber`` does not spin either."""

    model: Literal["marble", "rubber"] = Field(
        default="marble", description='"marble", "rubber" or "friction"'
    )

    @model_validator(mode="before")
    @classmethod
    def _without_friction(cls, table: object) -> object:
        # If the model has another name, that is the mistake to report.
        if not isinstance(table, dict) or table.get("model", "marble") not in ("marble", "rubber"):
            return table
        keys = [key for key in table if key in FRICTION_KEYS]
        if keys:
            raise ValueError(
                f'{keys[0]} is for a contact with friction: write model = "friction" with it, or '
                "leave it out"
            )
        return table


class FieldTable(FormulaTable):
    """The forces: gravity along −z of space, and a couple with the potential U(γ)."""

    place: ClassVar[str] = "field"
    variables: ClassVar[tuple[str, ...]] = (
        "gamma_1", "gamma_2", "gamma_3", "I_1", "I_2", "I_3", "m",
    )  # fmt: skip

    gravity: NotNegative = Field(default=9.81, description="a finite number not below zero")
    potential: str = Field(default="", description=FORMULA)
    """A formula in γ₁, γ₂, γ₃, I₁, I₂, I₃, m and the parameters; empty for none."""

    @field_validator("potential")
    @classmethod
    def _readable(cls, text: str, info: ValidationInfo) -> str:
        if text:
            cls._formula(text, info)
        return text
