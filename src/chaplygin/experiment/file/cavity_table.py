"""The table of a cavity filled with fluid, and of several."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field, field_validator

from ...mechanics.rolling.cavity import UNTURNED, Cavity
from .table import THREE, Number, Table, Vector

Quaternion = tuple[Number, Number, Number, Number]
PositiveNumber = Annotated[Number, Field(gt=0)]


class CavityTable(Table):
    """An ellipsoidal cavity filled with an ideal fluid."""

    axes: tuple[PositiveNumber, PositiveNumber, PositiveNumber] = Field(
        description="3 positive semi-axes"
    )
    mass: Annotated[Number, Field(ge=0)] = Field(description="a finite number not below zero")
    """Of the fluid; it adds to the mass of the body."""
    turn: Quaternion = Field(
        default=UNTURNED, description="4 finite numbers w, x, y, z with at least one not zero"
    )
    """Quaternion that turns the axes of the cavity into its axes in the body; any length."""
    centre: Vector = Field(default=(0.0, 0.0, 0.0), description=THREE)
    """Centre of the cavity minus centre of mass of the solid body, body axes."""

    @field_validator("turn")
    @classmethod
    def _not_zero(cls, turn: Quaternion) -> Quaternion:
        if not any(turn):
            raise ValueError("must not be zero, as it has a direction alone")
        return turn

    def cavity(self) -> Cavity:
        """The cavity that it describes."""
        return Cavity(self.axes, self.mass, self.turn, self.centre)


def as_several(value: object) -> object:
    """One table as a list of one: ``[body.cavity]`` as ``[[body.cavity]]``."""
    return [value] if isinstance(value, dict | CavityTable) else value


def as_written(cavities: tuple[CavityTable, ...] | None) -> object:
    """A list of one as one table."""
    tables = [cavity.model_dump() for cavity in cavities or ()]
    return tables[0] if len(tables) == 1 else tables
