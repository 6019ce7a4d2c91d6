"""The experiment in which a body rolls on a plane or a sphere."""

from __future__ import annotations

from pydantic import Field, ValidationInfo, field_validator

from .base import ExperimentBase
from .shape_tables import BallTable, ShapeTable
from .tables import (
    BodyTable,
    ContactTable,
    FieldTable,
    PlaneTable,
    RunTable,
    SphereTable,
    StartTable,
    SurfaceTable,
)

#: The description that a file needs.
BODY = "a table [body], or [system], [lagrangian] or [equations] instead of it"


class RollingExperiment(ExperimentBase):
    """A body rolls on a surface.

    Raises
    ------
    pydantic.ValidationError
        (A ValueError.) If it is made in Python of parts that do not fit; `load` raises InputError.
    """

    body: BodyTable = Field(description=BODY)
    surface: SurfaceTable = Field(
        default=PlaneTable(), discriminator="kind", description="a table", validate_default=True
    )
    contact: ContactTable = Field(default=ContactTable(), description="a table")
    field: FieldTable = Field(default=FieldTable(), description="a table")
    start: StartTable = Field(description="a table [start] with gamma and omega")
    run: RunTable = Field(default=RunTable(), description="a table")

    @field_validator("surface", mode="before")
    @classmethod
    def _plane_by_default(cls, surface: object) -> object:
        return {"kind": "plane"} if surface == {} else surface

    @field_validator("surface")
    @classmethod
    def _body_fits(cls, surface: SurfaceTable, info: ValidationInfo) -> SurfaceTable:
        body = info.data.get("body")
        misfit = _misfit(body.shape, surface) if body else None
        if misfit:
            raise ValueError(misfit)
        return surface

    @field_validator("field")
    @classmethod
    def _names_once(cls, field: FieldTable, info: ValidationInfo) -> FieldTable:
        body = info.data.get("body")
        twice = sorted(field.parameters.keys() & body.shape.parameters.keys()) if body else []
        if twice:
            raise ValueError(
                f"the parameter '{twice[0]}' is one of body.shape.parameters too; rename one"
            )
        return field

    @field_validator("start")
    @classmethod
    def _normal_of_surface(cls, start: StartTable, info: ValidationInfo) -> StartTable:
        if isinstance(info.data.get("surface"), PlaneTable) and start.normal != (0.0, 0.0, 1.0):
            raise ValueError("normal is for a sphere alone; on a plane it is always [0, 0, 1]")
        return start


def _misfit(shape: ShapeTable, surface: SurfaceTable) -> str | None:
    """The reason why a body certainly cannot roll on a surface, if there is one."""
    radius = surface.radius if isinstance(surface, SphereTable) else None
    inside = isinstance(surface, SphereTable) and surface.side == "inside"
    if isinstance(shape, BallTable) and shape.hollow:
        if radius is None or inside:
            return 'a hollow ball rolls around a sphere: its side must be "outside"'
        if shape.radius <= radius:
            return (
                f"a hollow ball of radius {shape.radius:.15g} does not go around a sphere of "
                f"radius {radius:.15g}; the ball must be the larger one"
            )
        return None
    if radius is None or not inside:
        return None
    size, meaning = shape.size
    if size < radius:
        return None
    return (
        f"a bowl of radius {radius:.15g} is too small for this {shape.kind}, whose {meaning} is "
        f"{size:.15g}; the bowl must be larger than that"
    )
