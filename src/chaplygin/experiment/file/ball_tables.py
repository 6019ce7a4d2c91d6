"""The tables of an experiment in which a homogeneous ball rolls on a surface of any kind.

As in :mod:`chaplygin.experiment.file.tables` the description of a field completes "… must be".
"""

from __future__ import annotations

from typing import ClassVar, Literal

import sympy as sp
from pydantic import Field, ValidationInfo, field_validator, model_validator

from .table import (
    DIRECTION,
    FORMULA,
    POSITIVE,
    SIDES,
    THREE,
    FormulaTable,
    Number,
    Positive,
    SphereRadius,
    Table,
    Vector,
)

__all__ = [
    "BallFieldTable",
    "BallStartTable",
    "ConeTable",
    "CylinderTable",
    "EllipsoidSurfaceTable",
    "FlatTable",
    "ImplicitSurfaceTable",
    "ParaboloidTable",
    "RingTable",
    "RoundTable",
    "SmoothTable",
]


class _SurfaceTable(FormulaTable):
    """What all surfaces have."""

    kind: str
    given: Literal["support", "centre"] = Field(
        default="support", description='"support" or "centre"'
    )
    """Whether it carries the ball, or is the surface on which the ball's centre moves."""
    axis: Literal["x", "y", "z"] = Field(default="z", description='"x", "y" or "z"')
    """The space axis that plays the part of z in the description of the surface."""
    side: Literal["outside", "inside"] = Field(default="outside", description=SIDES)
    """Where the ball is; above counts as outside, below as inside."""


class FlatTable(_SurfaceTable):
    """The plane z = 0."""

    kind: Literal["plane"] = "plane"


class RoundTable(_SurfaceTable):
    """A sphere about the origin."""

    kind: Literal["sphere"] = "sphere"
    radius: SphereRadius = Field(description=POSITIVE)


class CylinderTable(_SurfaceTable):
    """A cylinder about the axis, circular (radius) or elliptic (axes)."""

    kind: Literal["cylinder"] = "cylinder"
    radius: Positive | None = Field(default=None, description=POSITIVE)
    axes: tuple[Positive, Positive] | None = Field(default=None, description="2 positive semi-axes")

    @model_validator(mode="after")
    def _one_description(self) -> CylinderTable:
        if (self.radius is None) == (self.axes is None):
            raise ValueError("give either radius (circular) or axes (elliptic) of the cylinder")
        return self


class ConeTable(_SurfaceTable):
    """The half z > 0 of the cone x² + y² = slope² z²."""

    kind: Literal["cone"] = "cone"
    slope: Positive = Field(description=POSITIVE)


class EllipsoidSurfaceTable(_SurfaceTable):
    """An ellipsoid about the origin with its axes along x, y, z."""

    kind: Literal["ellipsoid"] = "ellipsoid"
    axes: tuple[Positive, Positive, Positive] = Field(description="3 positive semi-axes")


class ParaboloidTable(_SurfaceTable):
    """The paraboloid z = x²/2p + y²/2q, with radii = [p, q]; hyperbolic where the signs differ."""

    kind: Literal["paraboloid"] = "paraboloid"
    radii: tuple[Number, Number] = Field(description="2 finite numbers, not zero")

    @field_validator("radii")
    @classmethod
    def _not_zero(cls, radii: tuple[float, float]) -> tuple[float, float]:
        if 0 in radii:
            raise ValueError("must be 2 finite numbers, not zero; a cylinder is implicit")
        return radii


class RingTable(_SurfaceTable):
    """A torus about the axis: tubes of radius `tube` around a circle of radius `radius`."""

    kind: Literal["torus"] = "torus"
    radius: Positive = Field(description=POSITIVE)
    tube: Positive = Field(description=POSITIVE)


class ImplicitSurfaceTable(_SurfaceTable):
    """The surface f(x, y, z) = 0, space axes; outside is where f is positive."""

    variables: ClassVar[tuple[str, ...]] = ("x", "y", "z")

    kind: Literal["implicit"] = "implicit"
    equation: str = Field(description=FORMULA)

    @field_validator("equation")
    @classmethod
    def _readable(cls, text: str, info: ValidationInfo) -> str:
        formula = cls._formula(text, info)
        if formula is not None and not {s.name for s in formula.free_symbols} & set(cls.variables):
            raise ValueError("the equation of a surface must contain x, y or z")
        return text


SmoothTable = (
    FlatTable
    | RoundTable
    | CylinderTable
    | ConeTable
    | EllipsoidSurfaceTable
    | ParaboloidTable
    | RingTable
    | ImplicitSurfaceTable
)


class BallFieldTable(FormulaTable):
    """The forces: gravity in any direction, and a potential U(x, y, z) of the ball's centre."""

    variables: ClassVar[tuple[str, ...]] = ("x", "y", "z", "m")

    gravity: Number = Field(default=9.81, ge=0, description="a finite number not below zero")
    direction: Vector = Field(default=(0.0, 0.0, -1.0), description=DIRECTION)
    """Where gravity points, space axes; any length."""
    potential: str = Field(default="", description=FORMULA)
    """A formula in x, y, z of the centre, m and the parameters; empty for none."""

    @field_validator("direction")
    @classmethod
    def _not_zero(cls, direction: tuple[float, ...]) -> tuple[float, ...]:
        if not any(direction):
            raise ValueError("must not be zero, as it is a direction")
        return direction

    @field_validator("potential")
    @classmethod
    def _readable(cls, text: str, info: ValidationInfo) -> str:
        formula = cls._formula(text, info) if text else sp.S.Zero
        if formula is not None and formula.is_number and formula != 0:
            raise ValueError("a potential must contain x, y or z; a constant one does nothing")
        return text


class BallStartTable(Table):
    """Where the ball is and how it turns at the start, space axes."""

    contact: Vector | None = Field(default=None, description=THREE)
    """The contact point, on the surface that carries the ball."""
    centre: Vector | None = Field(default=None, description=THREE)
    """The centre of the ball, on the surface on which it moves."""
    omega: Vector = Field(description=THREE)
    """Angular velocity, space axes."""
