"""The experiment in which a homogeneous ball rolls on a surface of any kind."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field, ValidationInfo, field_validator

from ..file.ball_tables import (
    SMOOTH_SURFACES,
    BallFieldTable,
    BallStartTable,
    FlatTable,
    SmoothTable,
)
from ..file.body_tables import BodyTable
from ..file.tables import ContactTable, RunTable
from .base import ExperimentBase


class BallExperiment(ExperimentBase):
    """A homogeneous ball rolls on a surface.

    Raises
    ------
    pydantic.ValidationError
        (A ValueError.) If it is made in Python of parts that do not fit; `load` raises InputError.
    """

    surface: Annotated[SmoothTable, SMOOTH_SURFACES] = Field(
        default=FlatTable(), description="a table", validate_default=True
    )
    body: BodyTable = Field(description="a table [body] with a homogeneous ball")
    contact: ContactTable = Field(default=ContactTable(), description="a table")
    field: BallFieldTable = Field(default=BallFieldTable(), description="a table")
    start: BallStartTable = Field(description="a table [start] with contact or centre, and omega")
    run: RunTable = Field(default=RunTable(), description="a table")

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

    @field_validator("start")
    @classmethod
    def _place_on_given(cls, start: BallStartTable, info: ValidationInfo) -> BallStartTable:
        surface = info.data.get("surface")
        if surface is None:
            return start
        wanted, other = ("contact", "centre")[:: 1 if surface.given == "support" else -1]
        if getattr(start, wanted) is None or getattr(start, other) is not None:
            raise ValueError(
                f"give {wanted} and omega, not {other}: the surface is given as that of the "
                f'{wanted if wanted == "centre" else "support"} (surface.given = "{surface.given}")'
            )
        return start


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
