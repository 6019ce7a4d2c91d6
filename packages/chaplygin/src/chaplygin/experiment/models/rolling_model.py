"""The experiments with a body on a plane or a sphere: it rolls, or slides with friction."""

from __future__ import annotations

from typing import TypeVar

from pydantic import Field, ValidationInfo, field_validator

from ..file.body_tables import BallTable, BodyTable, ShapeTable
from ..file.contact_tables import (
    WAYS,
    FrictionPlaneTable,
    FrictionRunTable,
    FrictionStartTable,
    FrictionSurfaceTable,
    FrictionTable,
)
from ..file.tables import (
    ContactTable,
    FieldTable,
    PlaneTable,
    RunTable,
    SphereTable,
    StartTable,
    SurfaceTable,
)
from .base import ExperimentBase

AnyStart = TypeVar("AnyStart", StartTable, FrictionStartTable)

#: The description that a file needs.
BODY = "a table [body], or [system], [lagrangian] or [equations] instead of it"


class BodyOnSurface(ExperimentBase):
    """The part that all bodies on a plane or a sphere have in common."""

    body: BodyTable = Field(description=BODY)
    surface: SurfaceTable = Field(
        default=PlaneTable(), discriminator="kind", description="a table", validate_default=True
    )
    contact: ContactTable | FrictionTable
    field: FieldTable = Field(default=FieldTable(), description="a table")

    @field_validator("surface", mode="before", check_fields=False)
    @classmethod
    def _plane_by_default(cls, surface: object) -> object:
        if isinstance(surface, dict) and surface.keys() <= {"turntable"}:
            return {"kind": "plane", **surface}
        return surface

    @field_validator("surface", check_fields=False)
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

    @field_validator("start", check_fields=False)
    @classmethod
    def _normal_of_surface(cls, start: AnyStart, info: ValidationInfo) -> AnyStart:
        on_plane = isinstance(info.data.get("surface"), PlaneTable)
        if on_plane and start.normal not in (None, (0.0, 0.0, 1.0)):
            raise ValueError("normal is for a sphere alone; on a plane it is always [0, 0, 1]")
        return start


class RollingExperiment(BodyOnSurface):
    """A body rolls on a surface.

    Raises
    ------
    pydantic.ValidationError
        (A ValueError.) If it is made in Python of parts that do not fit; `load` raises InputError.
    """

    contact: ContactTable = Field(default=ContactTable(), description="a table")
    start: StartTable = Field(description="a table [start] with gamma and omega")
    run: RunTable = Field(default=RunTable(), description="a table")

    @field_validator("start")
    @classmethod
    def _fluid_in_cavities(cls, start: StartTable, info: ValidationInfo) -> StartTable:
        body = info.data.get("body")
        if body is not None:
            start.require_cavities(body.cavities, "body")
        return start


class FrictionExperiment(BodyOnSurface):
    """A body on a support that it touches with friction, and may leave.

    Raises
    ------
    pydantic.ValidationError
        (A ValueError.) If it is made in Python of parts that do not fit; `load` raises InputError.
    """

    surface: FrictionSurfaceTable = Field(
        default=FrictionPlaneTable(),
        discriminator="kind",
        description="a table",
        validate_default=True,
    )
    contact: FrictionTable = Field(description="a table [contact] with the laws of friction")
    start: FrictionStartTable = Field(description=f"a table [start]; {WAYS}")
    run: FrictionRunTable = Field(default=FrictionRunTable(), description="a table")

    @field_validator("body")
    @classmethod
    def _without_fluid(cls, body: BodyTable) -> BodyTable:
        if body.cavities:
            raise ValueError(
                "a cavity with fluid needs a contact without friction; write contact.model = "
                '"marble" or "rubber", or leave the cavity out'
            )
        return body

    @field_validator("field")
    @classmethod
    def _potential_on_plane(cls, field: FieldTable, info: ValidationInfo) -> FieldTable:
        if field.potential and isinstance(info.data.get("surface"), SphereTable):
            raise ValueError(
                "a potential U(gamma) with friction is for a plane alone; leave it out"
            )
        return field


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
