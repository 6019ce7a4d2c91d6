"""The experiment in which a homogeneous ball rolls on a surface of any kind."""

from __future__ import annotations

from pydantic import Field, ValidationInfo, field_validator

from nonholonomic.system_files.ball_tables import BallStartTable
from nonholonomic.system_files.bodies import BallFile

from ..file.tables import RunTable
from .base import ExperimentBase


class BallExperiment(BallFile, ExperimentBase):
    """A homogeneous ball rolls on a surface.

    Raises
    ------
    pydantic.ValidationError
        (A ValueError.) If it is made in Python of parts that do not fit; `load` raises InputError.
    """

    start: BallStartTable = Field(description="a table [start] with contact or centre, and omega")
    run: RunTable = Field(default=RunTable(), description="a table")

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
