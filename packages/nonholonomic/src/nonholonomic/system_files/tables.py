"""The tables of a file with a Lagrangian or with equations of motion.

Formulas are stored as typed; they are parsed once all names are known
(:mod:`nonholonomic.system_files.equations`).  The description of a field completes
the sentence "… must be".
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Literal, Self

from pydantic import (
    Field,
    GetJsonSchemaHandler,
    PlainValidator,
    Strict,
    StrictBool,
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
CONDITIONS = 'conditions in quotes, in brackets, such as ["I_1 > 0", "I_1 <= I_2 + I_3"]'
NUMBER = "a finite number, or finite numbers in brackets"

Text = Annotated[str, Strict()]
Texts = tuple[Text, ...]


def formula_text(value: object) -> str:
    """A formula as a text, as it is typed."""
    if not isinstance(value, str) or not value.strip():
        raise ValueError(f"must be {FORMULA}, not {value_text(value)}")
    return value


def _number(value: object) -> float | tuple[float, ...]:
    """A number, or the components of a vector."""
    return given_numbers(value, NUMBER)


#: A formula, for a table of formulas by name.
FormulaValue = Annotated[str, PlainValidator(formula_text, json_schema_input_type=str)]
Formulas = dict[str, FormulaValue]
NumberValue = Annotated[
    float | tuple[float, ...],
    PlainValidator(_number, json_schema_input_type=float | tuple[float, ...]),
]


class ValueWithNotes(Table):
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
            key: value
            for key, value in serialise(self).items()
            if value is not False and value not in (None, "", (), [])
        }
        return text.get("value") if set(text) == {"value"} else text


class NumberTable(ValueWithNotes):
    """A parameter: a number, a vector of three, or a diagonal tensor."""

    value: NumberValue | None = Field(default=None, description=NUMBER)
    diagonal: Vector | None = Field(default=None, description=THREE)
    """The diagonal of a tensor, instead of a value."""
    unit: Text = Field(default="", description="a text in quotes")
    meaning: Text = Field(default="", description="a text in quotes")
    where: Texts = Field(default=(), description=CONDITIONS)
    """What the parameters must fulfil."""

    @model_validator(mode="after")
    def _one_of_both(self) -> Self:
        if (self.value is None) == (self.diagonal is None):
            raise ValueError("must have either a value or a diagonal")
        if isinstance(self.value, tuple) and len(self.value) != 3:
            raise ValueError(f"must be a number or 3 numbers, not {value_text(self.value)}")
        return self


class DefinitionTable(ValueWithNotes):
    """A formula that has a name."""

    value: FormulaValue = Field(description=FORMULA)
    shorthand: StrictBool = Field(default=False, description="true or false")
    """Whether the name is none of the system, but stands for the formula wherever it occurs."""


class MeaningTable(Table):
    """Meaning and unit of a variable."""

    meaning: Text = Field(description="a text in quotes")
    unit: Text = Field(default="", description="a text in quotes")


class ObservableTable(ValueWithNotes):
    """A quantity to record."""

    value: FormulaValue = Field(description=FORMULA)
    meaning: Text = Field(default="", description="a text in quotes")
    unit: Text = Field(default="", description="a text in quotes")
    frame: Literal["body", "space", "quaternion", ""] = Field(
        default="", description='"body", "space" or "quaternion"'
    )
    """The axes of a vector, or a quaternion that turns body axes into space axes."""
    source: Text = Field(default="", description="a text in quotes")


class GuardTable(Table):
    """A quantity that must stay positive."""

    value: FormulaValue = Field(description=FORMULA)
    message: Text = Field(description='a text in quotes, such as "the disk lies flat"')
    name: Text = Field(default="", description="a text in quotes")
    """The name, where another guard has the same."""
    lift_off: StrictBool = Field(default=False, description="true or false")
    """Whether the equations remain valid beyond, so that a run may go on."""


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
    """The formulas that vanish, with and without velocities."""

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


class ReconstructionTable(EquationsTable):
    """The motion in space that a reduced system leaves out: further variables and their rates."""

    observables: dict[str, ObservableTable] = Field(default={}, description="a table of formulas")


#: Vectors and tensors whose components are parameters, variables or definitions.
ComponentsTable = dict[str, Literal["vector", "diagonal", "symmetric"]]
