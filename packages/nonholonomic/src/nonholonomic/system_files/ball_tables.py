"""The tables of an experiment with a homogeneous ball on an arbitrary surface.

The description of a field completes "… must be", in errors and in documentation.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar, Literal

from pydantic import Field, ValidationInfo, field_validator, model_validator

from ..mechanics import ball as balls
from .open_kinds import KindTable, OpenKinds
from .table import (
    DIRECTION,
    FORMULA,
    POSITIVE,
    SIDES,
    THREE,
    Direction,
    FormulaTable,
    NotNegative,
    Number,
    Positive,
    SphereRadius,
    Table,
    Vector,
)

if TYPE_CHECKING:
    from ..mechanics.ball import SmoothSurface


class SmoothTable(FormulaTable, KindTable):
    """The keys common to all surfaces."""

    place: ClassVar[str] = "surface"

    kind: str
    given: Literal["support", "centre"] = Field(
        default="support", description='"support" or "centre"'
    )
    """Whether it carries the ball, or is the surface on which the ball's centre moves."""
    axis: Literal["x", "y", "z"] = Field(default="z", description='"x", "y" or "z"')
    """The space axis that plays the part of z in the description of the surface."""
    side: Literal["outside", "inside"] = Field(default="outside", description=SIDES)
    """The side of the ball; above counts as outside, below as inside."""

    surface_class: ClassVar[str]
    """The name of the class, which is imported when a surface is made of the table."""
    surface_name: ClassVar[str] = ""
    """The name of the surface in titles, with its article; by default that of its class."""

    def surface(self) -> SmoothSurface:
        """The surface; its parameters are named like the keys.

        Raises
        ------
        InputError
            If a number is not admissible.
        """
        numbers = self.model_dump(exclude={"kind", "given", "parameters"})
        kind = self.described or getattr(balls, self.surface_class)
        surface: SmoothSurface = kind(**numbers)
        return surface

    @property
    def title(self) -> str:
        """The surface in titles, with its article."""
        return self.surface_name or self.surface().title


class FlatTable(SmoothTable):
    """The plane z = 0."""

    surface_class = "FlatSurface"
    surface_name = "a plane"

    kind: Literal["plane"] = "plane"


class RoundTable(SmoothTable):
    """A sphere about the origin."""

    surface_class = "SphericalSurface"
    surface_name = "a sphere"

    kind: Literal["sphere"] = "sphere"
    radius: SphereRadius = Field(description=POSITIVE)

    def surface(self) -> SmoothSurface:
        """The sphere."""
        return balls.SphericalSurface(self.radius, side=self.side, axis=self.axis)


class CylinderTable(SmoothTable):
    """A cylinder about the axis, circular (radius) or elliptic (axes)."""

    surface_class = "CircularCylinder"
    surface_name = "a cylinder"

    kind: Literal["cylinder"] = "cylinder"
    radius: Positive | None = Field(default=None, description=POSITIVE)
    axes: tuple[Positive, Positive] | None = Field(default=None, description="2 positive semi-axes")

    @model_validator(mode="after")
    def _one_description(self) -> CylinderTable:
        if (self.radius is None) == (self.axes is None):
            raise ValueError("give either radius (circular) or axes (elliptic) of the cylinder")
        return self

    def surface(self) -> SmoothSurface:
        """The circular or the elliptic cylinder."""
        if self.axes is not None:
            return balls.EllipticCylinder(self.axes, side=self.side, axis=self.axis)
        return balls.CircularCylinder(self.radius or 0.0, side=self.side, axis=self.axis)


class ConeTable(SmoothTable):
    """The half z > 0 of the cone x² + y² = slope² z²."""

    surface_class = "Cone"
    surface_name = "a cone"

    kind: Literal["cone"] = "cone"
    slope: Positive = Field(description=POSITIVE)


class EllipsoidSurfaceTable(SmoothTable):
    """An ellipsoid about the origin with its axes along x, y, z."""

    surface_class = "EllipsoidSurface"
    surface_name = "an ellipsoid"

    kind: Literal["ellipsoid"] = "ellipsoid"
    axes: tuple[Positive, Positive, Positive] = Field(description="3 positive semi-axes")


class ParaboloidTable(SmoothTable):
    """The paraboloid z = x²/2p + y²/2q with radii = [p, q], also hyperbolic."""

    surface_class = "Paraboloid"
    surface_name = "a paraboloid"

    kind: Literal["paraboloid"] = "paraboloid"
    radii: tuple[Number, Number] = Field(description="2 finite numbers, not zero")

    @field_validator("radii")
    @classmethod
    def _not_zero(cls, radii: tuple[float, float]) -> tuple[float, float]:
        if 0 in radii:
            raise ValueError("must be 2 finite numbers, not zero; a cylinder is implicit")
        return radii


class RingTable(SmoothTable):
    """A torus about the axis: radius of the centre circle and radius of the tube."""

    surface_class = "Ring"
    surface_name = "a torus"

    kind: Literal["torus"] = "torus"
    radius: Positive = Field(description=POSITIVE)
    tube: Positive = Field(description=POSITIVE)


class ImplicitSurfaceTable(SmoothTable):
    """The surface f(x, y, z) = 0, space axes; outside is where f is positive."""

    variables: ClassVar[tuple[str, ...]] = ("x", "y", "z")

    surface_class = "ImplicitSurface"
    surface_name = "a surface given by an equation"

    kind: Literal["implicit"] = "implicit"
    equation: str = Field(description=FORMULA)

    @field_validator("equation")
    @classmethod
    def _readable(cls, text: str, info: ValidationInfo) -> str:
        return cls._formula_in_space(text, info, "the equation of a surface")

    def surface(self) -> SmoothSurface:
        """The surface, its equation read."""
        return balls.ImplicitSurface(
            self.expression(self.equation), self.parameters, side=self.side, axis=self.axis
        )


SMOOTH_SURFACES = OpenKinds(
    SmoothTable,
    (
        FlatTable,
        RoundTable,
        CylinderTable,
        ConeTable,
        EllipsoidSurfaceTable,
        ParaboloidTable,
        RingTable,
        ImplicitSurfaceTable,
    ),
    lambda: balls.SmoothSurface,
)


class BallFieldTable(FormulaTable):
    """Gravity in any direction, and a potential U(x, y, z) of the ball's centre."""

    place: ClassVar[str] = "field"
    variables: ClassVar[tuple[str, ...]] = ("x", "y", "z", "m")

    gravity: NotNegative = Field(default=9.81, description="a finite number not below zero")
    direction: Direction = Field(default=(0.0, 0.0, -1.0), description=DIRECTION)
    """Direction of gravity, space axes; any length."""
    potential: str = Field(default="", description=FORMULA)
    """A formula in x, y, z of the centre, m and the parameters; empty for none."""

    @field_validator("potential")
    @classmethod
    def _readable(cls, text: str, info: ValidationInfo) -> str:
        formula = cls._formula(text, info) if text else None
        if formula is not None and formula.is_number and formula != 0:
            raise ValueError("a potential must contain x, y or z; a constant one does nothing")
        return text


class BallStartTable(Table):
    """Position and angular velocity of the ball at the start, space axes."""

    contact: Vector | None = Field(default=None, description=THREE)
    """The contact point, on the surface that carries the ball."""
    centre: Vector | None = Field(default=None, description=THREE)
    """The centre of the ball, on the surface on which it moves."""
    omega: Vector = Field(description=THREE)
    """Angular velocity, space axes."""
