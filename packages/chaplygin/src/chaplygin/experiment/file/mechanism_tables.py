"""The tables of a file with a Lagrangian or with equations of motion.

Formulas are kept as they are typed; they are read when all names are known
(:mod:`chaplygin.experiment.subjects.mechanism_from_tables`).  The description of a field completes
the sentence "… must be".
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Self

from pydantic import (
    Field,
    GetJsonSchemaHandler,
    PlainValidator,
    Strict,
    field_validator,
    model_serializer,
    model_validator,
)
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema

from .number_lists import given_numbers
from .table import FORMULA, THREE, Table, Vector
from .toml import Tables
from .validation import value_text

FORMULAS = "formulas in quotes, in brackets"
NAMES = 'names in quotes, in brackets, such as ["x", "gamma[3]"]'
NUMBER = "a finite number, or finite numbers in brackets"

Text = Annotated[str, Strict()]
Texts = tuple[Text, ...]


def _formula(value: object) -> str:
    if not isinstance(value, str) or not value.strip():
        raise ValueError(f"must be {FORMULA}, not {value_text(value)}")
    return value


def _number(value: object) -> float | tuple[float, ...]:
    """A number, or the components of a vector."""
    return given_numbers(value, NUMBER)


#: A formula, for a table of them by name.
FormulaValue = Annotated[str, PlainValidator(_formula, json_schema_input_type=str)]
Formulas = dict[str, FormulaValue]
NumberValue = Annotated[
    float | tuple[float, ...],
    PlainValidator(_number, json_schema_input_type=float | tuple[float, ...]),
]


class _ValueWithNotes(Table):
    """A value with meaning and unit, or the value alone, as in ``m = 1.0``."""

    @model_validator(mode="before")
    @classmethod
    def _value_alone(cls, value: object) -> object:
        return value if isinstance(value, dict | cls) else {"value": value}

    @classmethod
    def __get_pydantic_json_schema__(
        cls, core: CoreSchema, handler: GetJsonSchemaHandler
    ) -> JsonSchemaValue:
        """The value alone, or the table."""
        table = handler(core)
        described = handler.resolve_ref_schema(table)
        value = described["properties"]["value"]
        return {"description": described["description"], "anyOf": [value, table]}

    @model_serializer(mode="wrap")
    def _as_given(self, serialise: Callable[[Self], Tables]) -> object:
        text = {
            key: value for key, value in serialise(self).items() if value not in (None, "", (), [])
        }
        return text.get("value") if set(text) == {"value"} else text


class NumberTable(_ValueWithNotes):
    """A parameter: a number, a vector of three, or a diagonal tensor."""

    value: NumberValue | None = Field(default=None, description=NUMBER)
    diagonal: Vector | None = Field(default=None, description=THREE)
    """The diagonal of a tensor, instead of a value."""
    unit: Text = Field(default="", description="a text in quotes")
    meaning: Text = Field(default="", description="a text in quotes")

    @model_validator(mode="after")
    def _one_of_both(self) -> Self:
        if (self.value is None) == (self.diagonal is None):
            raise ValueError("must have either a value or a diagonal")
        if isinstance(self.value, tuple) and len(self.value) != 3:
            raise ValueError(f"must be a number or 3 numbers, not {value_text(self.value)}")
        return self


class MeaningTable(Table):
    """Meaning and unit of a variable of the state."""

    meaning: Text = Field(description="a text in quotes")
    unit: Text = Field(default="", description="a text in quotes")


class LawTable(_ValueWithNotes):
    """A law by its formula."""

    value: FormulaValue = Field(description=FORMULA)
    meaning: Text = Field(default="", description="a text in quotes")
    unit: Text = Field(default="", description="a text in quotes")
    on: Texts = Field(default=(), description=FORMULAS)
    """Formulas that must vanish for the law to hold."""


class LawsTable(Table):
    """The laws that are claimed of the system, to be proved or refuted."""

    integrals: dict[str, LawTable] = Field(default={}, description="a table of named formulas")
    measures: dict[str, LawTable] = Field(default={}, description="a table of named formulas")
    symmetries: dict[str, Formulas] = Field(default={}, description="a table of named tables")
    """Fields by name; what is not named of the state has component zero."""


class ObservableTable(_ValueWithNotes):
    """A quantity to record."""

    value: FormulaValue = Field(description=FORMULA)
    meaning: Text = Field(default="", description="a text in quotes")
    unit: Text = Field(default="", description="a text in quotes")


class GuardTable(Table):
    """A quantity that must stay positive."""

    value: FormulaValue = Field(description=FORMULA)
    message: Text = Field(description='a text in quotes, such as "the disk lies flat"')


PLACE = 'two formulas for a place, such as ["x", "y"]'
PLACES = 'a list of places, each of two formulas, such as [["x", "y"]]'
POSES = 'a list of places with headings, each of three formulas, such as [["x", "y", "phi"]]'
RODS = (
    "a list of rods, each of four formulas, such as "
    '[["x", "y", "x + a*cos(phi)", "y + a*sin(phi)"]]'
)
_PointTexts = tuple[Text, Text]
_PoseTexts = tuple[Text, Text, Text]


class PlanTable(Table):
    """The drawing of the mechanism in the plane; lengths in the unit of x and y."""

    path: _PointTexts = Field(default=("x", "y"), description=PLACE)
    """The place whose path is drawn."""
    links: tuple[tuple[Text, Text, Text, Text], ...] = Field(default=(), description=RODS)
    """Rods from a place to another."""
    wheels: tuple[_PoseTexts, ...] = Field(default=(), description=POSES)
    """Wheels by place and heading."""
    axles: tuple[_PoseTexts, ...] = Field(default=(), description=POSES)
    """Two wheels side by side, by the place between them and their heading."""
    blades: tuple[_PoseTexts, ...] = Field(default=(), description=POSES)
    points: tuple[_PointTexts, ...] = Field(default=(), description=PLACES)
    """Marked by a ring, such as a centre of mass."""


class FrameTable(Table):
    """Coordinates and velocities (1.7)."""

    coordinates: Texts = Field(default=(), description=NAMES)
    velocities: Texts = Field(default=(), description=NAMES)
    """Without them the velocities are the rates of the coordinates, xdot of x."""
    rates: Formulas = Field(default={}, description="a table of named formulas")
    """The rate of each coordinate, linear in the velocities."""
    relations: Texts = Field(default=(), description=FORMULAS)
    """Vanish on the configuration space; the velocities keep them by themselves."""
    structure: Text | None = Field(
        default=None, description='"rotations(omega)" or "euclidean(omega, v)"'
    )
    """The group by which a frame moves fewer coordinates than it has velocities."""
    commutators: Formulas = Field(default={}, description="a table of named formulas")
    """The structure by commutators: ``"u, v" = "2*w"`` where [E_u, E_v] = 2 E_w."""

    @model_validator(mode="after")
    def _rates_and_velocities(self) -> Self:
        if self.rates and not self.velocities:
            raise ValueError("rates need velocities to be written in; give them their names")
        if self.velocities and self.coordinates and not self.rates:
            raise ValueError("velocities of your own need the rates of the coordinates")
        if not self.velocities and not self.coordinates:
            raise ValueError("must name coordinates or velocities")
        if self.structure and self.commutators:
            raise ValueError("must have either structure or commutators")
        return self


class LagrangianTable(Table):
    """L = T − U, by its parts or as a whole."""

    kinetic: FormulaValue | None = Field(default=None, description=FORMULA)
    potential: FormulaValue | None = Field(default=None, description=FORMULA)
    L: FormulaValue | None = Field(default=None, description=FORMULA)

    @model_validator(mode="after")
    def _one_description(self) -> Self:
        parts = self.kinetic is not None
        if parts == (self.L is not None) or (self.L is not None and self.potential is not None):
            raise ValueError("must have either kinetic (and perhaps potential) or L alone")
        return self


class ConstraintsTable(Table):
    """The formulas that vanish, with velocities and without."""

    velocity: Texts = Field(default=(), description=FORMULAS)
    position: Texts = Field(default=(), description=FORMULAS)


class EquationsTable(Table):
    """A vector field without a Lagrangian."""

    state: Texts = Field(description=NAMES)
    rates: Formulas = Field(description="a table of named formulas")
    relations: Texts = Field(default=(), description=FORMULAS)
    """Vanish on the phase space."""

    @field_validator("state")
    @classmethod
    def _not_empty(cls, state: Texts) -> Texts:
        if not state:
            raise ValueError(f"must be {NAMES}; it is empty")
        return state
