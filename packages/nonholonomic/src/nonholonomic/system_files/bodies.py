"""Files with a body: it rolls on a plane or a sphere, or it is a ball on any surface.

Their numbers may be formulas in the parameters of a table [parameters], whose values they take
when the file is read.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Self

from pydantic import Field, ValidationInfo, field_validator

from .ball_tables import SMOOTH_SURFACES, BallFieldTable, FlatTable, SmoothTable
from .body_tables import BodyTable, ShapeTable
from .catalogue_table import CatalogueTable
from .rolling_tables import SURFACES, ContactTable, FieldTable, PlaneTable, SurfaceTable
from .sourced import SourcedTables
from .table import ParameterValues, Table, require_name
from .toml import Tables

#: The required description of a file.
BODY = "a table [body], or [system], [lagrangian] or [equations] instead of it"


class _Parameters(SourcedTables):
    """The parameters in which the numbers of a file may be written."""

    parameters: dict[str, float] = Field(
        default={}, exclude=True, description="a table of named numbers"
    )
    """Empty in a file that has been read, which has the numbers themselves."""

    @field_validator("parameters")
    @classmethod
    def _nameable(cls, parameters: dict[str, float]) -> dict[str, float]:
        for name in parameters:
            require_name(name)
        return parameters


class BodyFile(_Parameters):
    """The tables common to all files with a body."""

    summary: str | None = Field(default=None, description="a text in quotes")
    """One or two sentences on what moves, for reports."""
    source: str | None = Field(default=None, description="a text in quotes")
    """Where the system is described."""
    catalogue: CatalogueTable | None = Field(default=None, description="a table with group")

    @classmethod
    def of_tables(cls, tables: Tables) -> Self:
        """The model of tables whose numbers may be formulas in [parameters].

        Raises
        ------
        pydantic.ValidationError
            If something is wrong in the tables, or first of all in [parameters].
        """
        # they are numbers once the file is read, and nothing else remembers them
        others = {key: value for key, value in tables.items() if key != "parameters"}
        if "parameters" not in tables:
            return cls.model_validate(others)
        parameters = _Parameters.model_validate({"parameters": tables["parameters"]}).parameters
        return cls.model_validate(others, context=ParameterValues(parameters))


def is_ball_file(tables: Mapping[str, object]) -> bool:
    """Whether the tables describe a surface on which only a ball rolls.

    This includes a plane or a sphere if the start gives the position of the ball, not γ.
    """
    surface, start = tables.get("surface"), tables.get("start")
    kind = surface.get("kind") if isinstance(surface, dict) else None
    placed = isinstance(start, dict) and start.keys() & {"contact", "centre"}
    return bool(placed) or (
        isinstance(kind, str) and SMOOTH_SURFACES.knows(kind) and not SURFACES.knows(kind)
    )


# --- a body on a plane or a sphere ---------------------------------------------------------


class BodyOnSurface(BodyFile):
    """A body on a plane or a sphere."""

    body: BodyTable = Field(description=BODY)
    surface: Annotated[SurfaceTable, SURFACES] = Field(
        default=PlaneTable(), description="a table", validate_default=True
    )
    contact: Table = Field(description="a table")
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


class RollingFile(BodyOnSurface):
    """A body that rolls on a plane or a sphere."""

    contact: ContactTable = Field(default=ContactTable(), description="a table")


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


# --- a homogeneous ball --------------------------------------------------------------------


class BallFile(BodyFile):
    """A homogeneous ball that rolls on a surface."""

    surface: Annotated[SmoothTable, SMOOTH_SURFACES] = Field(
        default=FlatTable(), description="a table", validate_default=True
    )
    body: BodyTable = Field(description="a table [body] with a homogeneous ball")
    contact: ContactTable = Field(default=ContactTable(), description="a table")
    field: BallFieldTable = Field(default=BallFieldTable(), description="a table")

    @field_validator("body")
    @classmethod
    def _homogeneous(cls, body: BodyTable, info: ValidationInfo) -> BodyTable:
        surface = info.data.get("surface")
        if surface is not None and not _is_homogeneous_ball(body):
            raise ValueError(
                f"on the surface {surface.kind!r} only a homogeneous ball rolls (shape ball, not "
                "hollow, three equal moments of inertia, centre [0, 0, 0], no gyrostat and no "
                "cavity); any other body needs a plane or a sphere and a start by gamma"
            )
        return body


def _is_homogeneous_ball(body: BodyTable) -> bool:
    shape = body.shape
    return (
        shape.is_ball
        and not shape.goes_around
        and not any(shape.centre)
        and not any(body.gyrostat)
        and not body.cavities
        and moment(body) is not None
    )


def moment(body: BodyTable) -> float | None:
    """The moment of inertia about every axis; None if it differs from axis to axis."""
    rows = body.inertia
    if not isinstance(rows[0], tuple):
        return rows[0] if rows[0] == rows[1] == rows[2] else None
    first = rows[0][0]
    wanted = tuple(tuple(first if i == j else 0.0 for j in range(3)) for i in range(3))
    return first if rows == wanted else None
