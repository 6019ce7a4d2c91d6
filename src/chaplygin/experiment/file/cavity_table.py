"""The table of a cavity filled with fluid, and those of bodies and starts with fluid."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated, cast

from pydantic import Field, field_serializer, field_validator

from ...mechanics import rolling
from .table import THREE, Number, Table, Vector

if TYPE_CHECKING:
    from ...mechanics.rolling.cavity import Cavity

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
        default=(1.0, 0.0, 0.0, 0.0),
        description="4 finite numbers w, x, y, z with at least one not zero",
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
        return rolling.Cavity(self.axes, self.mass, self.turn, self.centre)


class CavitiesTable(Table):
    """A table that may have ``[….cavity]``, or ``[[….cavity]]`` for each of several."""

    cavity: tuple[CavityTable, ...] | None = Field(
        default=None,
        description="a table with axes and mass, or one in double brackets for each of several",
    )
    """Cavities filled with fluid; mass and inertia of the body are those without it."""

    @property
    def cavities(self) -> tuple[Cavity, ...]:
        """The cavities, none by default."""
        return tuple(table.cavity() for table in self.cavity or ())

    @field_validator("cavity", mode="before")
    @classmethod
    def _one_or_several(cls, value: object) -> object:
        return [value] if isinstance(value, dict | CavityTable) else value

    @field_serializer("cavity")
    def _one_as_a_table(self, cavities: tuple[CavityTable, ...] | None) -> object:
        tables = [cavity.model_dump() for cavity in cavities or ()]
        return tables[0] if len(tables) == 1 else tables or None


class FluidStartTable(Table):
    """A start that may have the motion of fluids."""

    fluid: Vector | tuple[Vector, ...] | None = Field(
        default=None, description="3 finite numbers, or 3 for each of several cavities"
    )
    """Motion ξ of the fluid in a cavity relative to the body, body axes; zero by default."""

    def require_cavities(self, cavities: Sequence[Cavity], table: str) -> None:
        """Raise ValueError unless there are as many motions as cavities, or none."""
        count = len(self._rows)
        if not count or count == len(cavities):
            return
        if not cavities:
            raise ValueError(f"fluid is given, but there is no cavity; add [{table}.cavity]")
        raise ValueError(
            f"fluid must be 3 finite numbers for each cavity; there are {len(cavities)} of these, "
            f"and {count} in fluid"
        )

    def motion_of_fluids(self, cavities: Sequence[Cavity]) -> dict[str, Vector]:
        """The motion of each fluid by the name of its variable, zero by default."""
        motions = self._rows or ((0.0, 0.0, 0.0),) * len(cavities)
        several = len(cavities) > 1
        return {
            f"fluid{i if several else ''}": motion
            for i, (cavity, motion) in enumerate(zip(cavities, motions, strict=True), 1)
            if cavity.mass
        }

    @property
    def _rows(self) -> tuple[Vector, ...]:
        if self.fluid is None:
            return ()
        rows = tuple(row for row in self.fluid if isinstance(row, tuple))
        return rows or (cast(Vector, self.fluid),)
