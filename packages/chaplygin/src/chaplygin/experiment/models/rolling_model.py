"""Experiments with a body on a plane or a sphere: it rolls, or slides with friction."""

from __future__ import annotations

from typing import Annotated, TypeVar

from pydantic import Field, ValidationInfo, field_validator

from ..file.body_tables import BodyTable, ShapeTable
from ..file.contact_tables import (
    WAYS,
    FrictionPlaneTable,
    FrictionRunTable,
    FrictionStartTable,
    FrictionSurfaceTable,
    FrictionTable,
)
from ..file.tables import (
    SURFACES,
    ContactTable,
    FieldTable,
    PlaneTable,
    RunTable,
    StartTable,
    SurfaceTable,
)
from .base import ExperimentBase

AnyStart = TypeVar("AnyStart", StartTable, FrictionStartTable)

#: The required description of a file.
BODY = "a table [body], or [system], [lagrangian] or [equations] instead of it"


class BodyOnSurface(ExperimentBase):
    """The part common to all bodies on a plane or a sphere."""

    body: BodyTable = Field(description=BODY)
    surface: Annotated[SurfaceTable, SURFACES] = Field(
        default=PlaneTable(), description="a table", validate_default=True
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
        surface = info.data.get("surface")
        if surface is not None and start.normal not in (None, (0.0, 0.0, 1.0)):
            refusal = surface.surface().refusal_of_normal(start.normal)
            if refusal:
                raise ValueError(refusal)
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
        if field.potential and info.data.get("surface", PlaneTable()).sphere:
            raise ValueError(
                "a potential U(gamma) with friction is for a plane alone; leave it out"
            )
        return field


def _misfit(shape: ShapeTable, surface: SurfaceTable) -> str | None:
    """Why a body certainly cannot roll on a surface, or None."""
    radius, inside = surface.sphere or (None, False)
    size, meaning = shape.size
    if shape.goes_around:
        if radius is None or inside:
            return 'a hollow ball rolls around a sphere: its side must be "outside"'
        if size <= radius:
            return (
                f"a hollow ball of radius {size:.15g} does not go around a sphere of "
                f"radius {radius:.15g}; the ball must be the larger one"
            )
        return None
    if radius is None or not inside or size < radius:
        return None
    return (
        f"a bowl of radius {radius:.15g} is too small for this {shape.kind}, whose {meaning} is "
        f"{size:.15g}; the bowl must be larger than that"
    )
