"""The tables of the shapes that roll, each with the shape that it describes.

A kind of shape is registered by its table alone: the class of the shape, its name in titles, and
the length that decides whether it fits into a bowl.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar, Literal, get_args

from pydantic import Field, StrictBool, ValidationInfo, field_validator, model_validator

from ...mechanics import shapes
from .table import FORMULA, POSITIVE, THREE, FormulaTable, Number, Positive, Vector

if TYPE_CHECKING:
    from ...mechanics.shapes.shapes import Shape


class _ShapeTable(FormulaTable):
    """The keys that all shapes have: the position of the geometric centre."""

    place: ClassVar[str] = "body.shape"
    shape_class: ClassVar[str]
    """The name of the class, which is imported when a shape is made of the table."""
    shape_name: ClassVar[str]
    """The name of the shape in titles."""

    kind: str
    centre: Vector = Field(default=(0.0, 0.0, 0.0), description=THREE)
    """Geometric centre minus centre of mass, body axes."""

    def shape(self) -> Shape:
        """The shape, whose attributes have the names of the keys.

        Raises
        ------
        InputError
            If a number is not admissible.
        """
        shape: Shape = getattr(shapes, self.shape_class)(
            **self.model_dump(exclude={"kind", "parameters"})
        )
        return shape

    @property
    def size(self) -> tuple[float, str]:
        """A length which the radius of a bowl must exceed, and its meaning."""
        return 0.0, "size"


class BallTable(_ShapeTable):
    """A ball; a hollow one rolls with its inner surface around a sphere."""

    shape_class = "Ball"
    shape_name = "Ball"

    kind: Literal["ball"] = "ball"
    radius: Positive = Field(description=POSITIVE)
    hollow: StrictBool = Field(default=False, description="true or false")

    @property
    def size(self) -> tuple[float, str]:
        """The radius."""
        return self.radius, "radius"


class EllipsoidTable(_ShapeTable):
    """An ellipsoid, its third axis along body axis 3."""

    shape_class = "Ellipsoid"
    shape_name = "Ellipsoid"

    kind: Literal["ellipsoid"] = "ellipsoid"
    axes: tuple[Positive, Positive, Positive] = Field(description="3 positive semi-axes")
    turn: Number = Field(default=0.0, description="a finite angle (radians)")
    """The first semi-axis is (cos turn, sin turn, 0) in body axes."""

    @property
    def size(self) -> tuple[float, str]:
        """The largest radius of curvature."""
        longest, shortest = max(self.axes), min(self.axes)
        # Divided first, as the square of a large number may overflow.
        return longest / shortest * longest, "largest radius of curvature"


class DiskTable(_ShapeTable):
    """A disk with a sharp edge, normal to body axis 3."""

    shape_class = "Disk"
    shape_name = "Disk"

    kind: Literal["disk"] = "disk"
    radius: Positive = Field(description=POSITIVE)

    @property
    def size(self) -> tuple[float, str]:
        """The radius."""
        return self.radius, "radius"


class TorusTable(_ShapeTable):
    """A ring about body axis 3: tubes around a circle of radius `radius`."""

    shape_class = "Torus"
    shape_name = "Disk with a rounded edge"

    kind: Literal["torus"] = "torus"
    radius: Positive = Field(description=POSITIVE)
    tube: Positive = Field(description=POSITIVE)

    @property
    def size(self) -> tuple[float, str]:
        """The radius of the outer rim."""
        return self.radius + self.tube, "outer radius"


class RevolutionTable(_ShapeTable):
    """A body of revolution about body axis 3, by its support function or by χ₁ and χ₂."""

    shape_class = "Revolution"
    shape_name = "Body of revolution"

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
        """The body, its support function read or derived from χ₁ and χ₂."""
        if self.support is not None:
            return shapes.Revolution(self.expression(self.support), self.values, centre=self.centre)
        chi_1, chi_2 = (self.expression(text or "0") for text in (self.chi_1, self.chi_2))
        return shapes.Revolution.from_profile(chi_1, chi_2, dict(self.values), self.centre)


class ImplicitTable(_ShapeTable):
    """A smooth convex body f(x, y, z) < 0, in coordinates from its centre."""

    shape_class = "Implicit"
    shape_name = "Convex body"

    variables: ClassVar[tuple[str, ...]] = ("x", "y", "z")

    kind: Literal["implicit"] = "implicit"
    surface: str = Field(description=FORMULA)

    @field_validator("surface")
    @classmethod
    def _readable(cls, text: str, info: ValidationInfo) -> str:
        return cls._formula_in_space(text, info, "the formula of a surface")

    def shape(self) -> Shape:
        """The body, its equation read."""
        return shapes.Implicit(self.expression(self.surface), self.values, centre=self.centre)


ShapeTable = BallTable | EllipsoidTable | DiskTable | TorusTable | RevolutionTable | ImplicitTable

_NAMES = {table.shape_class: table.shape_name for table in get_args(ShapeTable)}


def shape_name(shape: Shape) -> str:
    """The name of a shape in titles."""
    return (
        "Hollow ball"
        if isinstance(shape, shapes.Ball) and shape.hollow
        else _NAMES[type(shape).__name__]
    )
