"""The tables of a body: its shape, its fluid-filled cavities, and the motion of the fluid.

A kind of shape that another module adds has a table made of its fields.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated, ClassVar, Literal, cast

import numpy as np
from pydantic import (
    Field,
    StrictBool,
    ValidationInfo,
    field_serializer,
    field_validator,
    model_validator,
)

from flowlanes.errors import InputError

from ..mechanics import rolling, shapes
from ..mechanics.rolling.inertia import check_inertia
from .open_kinds import KindTable, OpenKinds
from .table import (
    FORMULA,
    POSITIVE,
    THREE,
    TURN,
    FormulaTable,
    NotNegative,
    Number,
    Positive,
    Quaternion,
    Table,
    Vector,
)

if TYPE_CHECKING:
    from ..mechanics.rolling.cavity import Cavity
    from ..mechanics.shapes.shape_base import Shape

Inertia = Vector | tuple[Vector, Vector, Vector]


# --- shapes ---------------------------------------------------------------------------------


class ShapeTable(FormulaTable, KindTable):
    """The keys common to all shapes: the position of the geometric centre."""

    place: ClassVar[str] = "body.shape"
    shape_class: ClassVar[str]
    """The name of the class, which is imported when a shape is made of the table."""
    is_ball: ClassVar[bool] = False

    kind: str
    centre: Vector = Field(default=(0.0, 0.0, 0.0), description=THREE)
    """Geometric centre minus centre of mass, body axes."""

    def shape(self) -> Shape:
        """The shape; its attributes are named like the keys.

        Raises
        ------
        InputError
            If a number is not admissible.
        """
        if self.described is not None:
            made: Shape = self.made()
            return made
        shape: Shape = getattr(shapes, self.shape_class)(
            **self.model_dump(exclude={"kind", "parameters"})
        )
        return shape

    @property
    def goes_around(self) -> bool:
        """Whether it is hollow and rolls around a sphere."""
        return False

    @property
    def size(self) -> tuple[float, str]:
        """A length that the radius of a bowl must exceed, and its meaning."""
        return 0.0, "size"


class BallTable(ShapeTable):
    """A ball; a hollow one rolls with its inner surface around a sphere."""

    shape_class = "Ball"

    kind: Literal["ball"] = "ball"
    radius: Positive = Field(description=POSITIVE)
    hollow: StrictBool = Field(default=False, description="true or false")

    is_ball = True

    @property
    def goes_around(self) -> bool:
        """Whether it is hollow."""
        return self.hollow

    @property
    def size(self) -> tuple[float, str]:
        """The radius."""
        return self.radius, "radius"


class EllipsoidTable(ShapeTable):
    """An ellipsoid, its third axis along body axis 3."""

    shape_class = "Ellipsoid"

    kind: Literal["ellipsoid"] = "ellipsoid"
    axes: tuple[Positive, Positive, Positive] = Field(description="3 positive semi-axes")
    turn: Number = Field(default=0.0, description="a finite angle (radians)")
    """The first semi-axis is (cos turn, sin turn, 0) in body axes."""

    @property
    def size(self) -> tuple[float, str]:
        """The largest radius of curvature."""
        longest, shortest = max(self.axes), min(self.axes)
        # Divide first, as the square of a large number may overflow.
        return longest / shortest * longest, "largest radius of curvature"


class DiskTable(ShapeTable):
    """A disk with a sharp edge, normal to body axis 3."""

    shape_class = "Disk"

    kind: Literal["disk"] = "disk"
    radius: Positive = Field(description=POSITIVE)

    @property
    def size(self) -> tuple[float, str]:
        """The radius."""
        return self.radius, "radius"


class TorusTable(ShapeTable):
    """A ring about body axis 3: tubes around a circle of radius `radius`."""

    shape_class = "Torus"

    kind: Literal["torus"] = "torus"
    radius: Positive = Field(description=POSITIVE)
    tube: Positive = Field(description=POSITIVE)

    @property
    def size(self) -> tuple[float, str]:
        """The radius of the outer rim."""
        return self.radius + self.tube, "outer radius"


class RevolutionTable(ShapeTable):
    """A body of revolution about body axis 3, by its support function or by χ₁ and χ₂."""

    shape_class = "ShapeOfRevolution"

    variables: ClassVar[tuple[str, ...]] = ("gamma_3",)

    kind: Literal["revolution"] = "revolution"
    support: str | None = Field(default=None, description=FORMULA)
    chi_1: str | None = Field(default=None, description=FORMULA)
    chi_2: str | None = Field(default=None, description=FORMULA)

    @field_validator("support", "chi_1", "chi_2")
    @classmethod
    def _readable(cls, text: str | None, info: ValidationInfo) -> str | None:
        if text is not None:
            cls._formula(text, info)
        return text

    @model_validator(mode="after")
    def _one_description(self) -> RevolutionTable:
        names = [name for name in ("support", "chi_1", "chi_2") if getattr(self, name) is not None]
        if names not in (["support"], ["chi_1", "chi_2"]):
            present = " and ".join(names) or "neither"
            raise ValueError(f"give either support or both chi_1 and chi_2, not {present}")
        return self

    def shape(self) -> Shape:
        """The body, with its support function read or derived from χ₁ and χ₂."""
        if self.support is not None:
            return shapes.ShapeOfRevolution(
                self.expression(self.support), self.parameters, centre=self.centre
            )
        chi_1, chi_2 = (self.expression(text or "0") for text in (self.chi_1, self.chi_2))
        return shapes.ShapeOfRevolution.from_profile(chi_1, chi_2, self.parameters, self.centre)


class ImplicitTable(ShapeTable):
    """A smooth convex body f(x, y, z) < 0, in coordinates from its centre."""

    shape_class = "ImplicitShape"

    variables: ClassVar[tuple[str, ...]] = ("x", "y", "z")

    kind: Literal["implicit"] = "implicit"
    surface: str = Field(description=FORMULA)

    @field_validator("surface")
    @classmethod
    def _readable(cls, text: str, info: ValidationInfo) -> str:
        return cls._formula_in_space(text, info, "the formula of a surface")

    def shape(self) -> Shape:
        """The body, with its equation read."""
        return shapes.ImplicitShape(
            self.expression(self.surface), self.parameters, centre=self.centre
        )


SHAPES = OpenKinds(
    ShapeTable,
    (BallTable, EllipsoidTable, DiskTable, TorusTable, RevolutionTable, ImplicitTable),
    lambda: shapes.Shape,
)


# --- cavities and fluid ---------------------------------------------------------------------


class CavityTable(Table):
    """An ellipsoidal cavity filled with an ideal fluid."""

    axes: tuple[Positive, Positive, Positive] = Field(description="3 positive semi-axes")
    mass: NotNegative = Field(description="a finite number not below zero")
    """Of the fluid; it adds to the mass of the body."""
    turn: Quaternion = Field(default=(1.0, 0.0, 0.0, 0.0), description=TURN)
    """Quaternion that turns the axes of the cavity into its axes in the body; any length."""
    centre: Vector = Field(default=(0.0, 0.0, 0.0), description=THREE)
    """Centre of the cavity minus centre of mass of the solid body, body axes."""

    def cavity(self) -> Cavity:
        """The cavity described by the table."""
        return rolling.Cavity(self.axes, self.mass, self.turn, self.centre)


class CavitiesTable(Table):
    """A table with optional ``[….cavity]``, or several ``[[….cavity]]``."""

    cavity: tuple[CavityTable, ...] | None = Field(
        default=None,
        description="a table with axes and mass, or one in double brackets for each of several",
    )
    """Cavities filled with fluid; mass and inertia of the body are those without it."""

    @property
    def cavities(self) -> tuple[Cavity, ...]:
        """The cavities, none by default."""
        return tuple(table.cavity() for table in self.cavity or ())

    @field_validator("cavity", mode="before")
    @classmethod
    def _one_or_several(cls, value: object) -> object:
        return [value] if isinstance(value, dict | CavityTable) else value

    @field_serializer("cavity")
    def _one_as_a_table(self, cavities: tuple[CavityTable, ...] | None) -> object:
        tables = [cavity.model_dump() for cavity in cavities or ()]
        return tables[0] if len(tables) == 1 else tables or None


class FluidStartTable(Table):
    """A start that may include the motion of fluids."""

    fluid: Vector | tuple[Vector, ...] | None = Field(
        default=None, description="3 finite numbers, or 3 for each of several cavities"
    )
    """Motion ξ of the fluid in a cavity relative to the body, body axes; zero by default."""

    def require_cavities(self, cavities: Sequence[Cavity], table: str) -> None:
        """Raise ValueError unless there are as many motions as cavities, or no motion."""
        count = len(self._rows)
        if not count or count == len(cavities):
            return
        if not cavities:
            raise ValueError(f"fluid is given, but there is no cavity; add [{table}.cavity]")
        raise ValueError(
            f"fluid must be 3 finite numbers for each cavity; there are {len(cavities)} of these, "
            f"and {count} in fluid"
        )

    def motion_of_fluids(self, cavities: Sequence[Cavity]) -> dict[str, Vector]:
        """The motion of each fluid by the name of its variable, zero by default."""
        motions = self._rows or ((0.0, 0.0, 0.0),) * len(cavities)
        several = len(cavities) > 1
        return {
            f"fluid{i if several else ''}": motion
            for i, (cavity, motion) in enumerate(zip(cavities, motions, strict=True), 1)
            if cavity.mass
        }

    @property
    def _rows(self) -> tuple[Vector, ...]:
        if self.fluid is None:
            return ()
        rows = tuple(row for row in self.fluid if isinstance(row, tuple))
        return rows or (cast(Vector, self.fluid),)


# --- the body -------------------------------------------------------------------------------


class BodyTable(CavitiesTable):
    """A rigid body; the origin of the body axes is its centre of mass, excluding fluid."""

    mass: Positive = Field(description=POSITIVE)
    inertia: Inertia = Field(description="3 principal moments or a symmetric 3x3 matrix")
    gyrostat: Vector = Field(default=(0.0, 0.0, 0.0), description=THREE)
    """Constant momentum k of rotors, body axes: the total momentum is Iω + k."""
    shape: Annotated[ShapeTable, SHAPES] = Field(description="a table with the kind of shape")

    @field_validator("inertia")
    @classmethod
    def _of_a_body(cls, inertia: Inertia) -> Inertia:
        try:
            with np.errstate(over="ignore"):
                check_inertia(inertia)
        except InputError as error:
            # The key already names the subject.
            raise ValueError(error.message.removeprefix("inertia").lstrip(": ")) from None
        return inertia


class FilledBodyTable(CavitiesTable):
    """The body of a catalogue system, to which only fluid-filled cavities can be added."""

    @model_validator(mode="before")
    @classmethod
    def _cavities_alone(cls, table: object) -> object:
        others = table.keys() - cls.model_fields.keys() if isinstance(table, dict) else ()
        if others:
            raise ValueError(
                f"{min(others)} must be absent, as the table [system] decides the body; beside it "
                "[body] has cavities alone, and numbers stand in [system.parameters]"
            )
        return table
