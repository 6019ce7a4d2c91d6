"""Experiments with a body on a plane or a sphere: it rolls, or slides with friction."""

from __future__ import annotations

from typing import TypeVar

from pydantic import Field, ValidationInfo, field_validator

from nonholonomic.system_files.bodies import BodyOnSurface, RollingFile
from nonholonomic.system_files.body_tables import BodyTable
from nonholonomic.system_files.rolling_tables import FieldTable, PlaneTable

from ..file.contact_tables import (
    WAYS,
    FrictionPlaneTable,
    FrictionRunTable,
    FrictionStartTable,
    FrictionSurfaceTable,
    FrictionTable,
)
from ..file.tables import RunTable, StartTable
from .base import ExperimentBase

AnyStart = TypeVar("AnyStart", StartTable, FrictionStartTable)


class _Started(ExperimentBase):
    """A body on a plane or a sphere with its start."""

    @field_validator("start", check_fields=False)
    @classmethod
    def _normal_of_surface(cls, start: AnyStart, info: ValidationInfo) -> AnyStart:
        surface = info.data.get("surface")
        if surface is not None and start.normal not in (None, (0.0, 0.0, 1.0)):
            refusal = surface.surface().refusal_of_normal(start.normal)
            if refusal:
                raise ValueError(refusal)
        return start


class RollingExperiment(RollingFile, _Started):
    """A body rolls on a surface.

    Raises
    ------
    pydantic.ValidationError
        (A ValueError.) If it is made in Python of parts that do not fit; `load` raises InputError.
    """

    start: StartTable = Field(description="a table [start] with gamma and omega")
    run: RunTable = Field(default=RunTable(), description="a table")

    @field_validator("start")
    @classmethod
    def _fluid_in_cavities(cls, start: StartTable, info: ValidationInfo) -> StartTable:
        body = info.data.get("body")
        if body is not None:
            start.require_cavities(body.cavities, "body")
        return start


class FrictionExperiment(BodyOnSurface, _Started):
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
