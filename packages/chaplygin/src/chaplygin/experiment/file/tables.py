"""The tables of an experiment file: their keys, meanings and allowed values.

The description of a field completes the sentence "… must be", in errors and in documentation.
Units are SI, angles in radians.
"""

from __future__ import annotations

import json
from typing import Annotated, Any, Literal

from pydantic import (
    AfterValidator,
    Field,
    PlainValidator,
    StrictBool,
    StrictFloat,
    StrictInt,
    ValidationInfo,
    field_validator,
    model_validator,
)

from flowlanes.system.tolerance import FINEST_TOLERANCE, TOLERANCE
from nonholonomic.system_files.body_tables import FluidStartTable
from nonholonomic.system_files.number_lists import ParameterValue, given_rows
from nonholonomic.system_files.table import (
    DIRECTION,
    THREE,
    Direction,
    Number,
    Positive,
    Table,
    Vector,
)

STATE = "a finite number, or finite numbers in brackets"

COARSEST = 1e-3
FINEST, FINEST_DOUBLE = FINEST_TOLERANCE["quad"], FINEST_TOLERANCE["double"]
MOST_SAMPLES = 10_000_000


#: Keys of [system] that an n-dimensional system has besides its parameters.
OF_A_DIMENSION = ("dimension", "moments", "mass_tensor", "factors", "mass", "radius", "a")


def _setting(value: object) -> ParameterValue:
    """A parameter: a number; for an n-dimensional system also numbers or rows of numbers."""
    return given_rows(value, "a finite number")


class SystemTable(Table):
    """A system of the catalogue, with parameters that differ from its defaults."""

    name: str = Field(description="the name of a system, in quotes", min_length=1)
    parameters: dict[str, Annotated[ParameterValue, PlainValidator(_setting)]] = Field(
        default={}, description="a table of named numbers"
    )

    @model_validator(mode="before")
    @classmethod
    def _settings(cls, table: object) -> object:
        """The additional keys of n-dimensional systems are parameters, in whatever table."""
        if not isinstance(table, dict):
            return table
        if "cavity" in table:
            raise ValueError("a cavity belongs to the body; write [body.cavity]")
        keys = [key for key in OF_A_DIMENSION if key in table]
        parameters = table.get("parameters", {})
        if not keys or not isinstance(parameters, dict):
            return table
        if twice := [key for key in keys if key in parameters]:
            raise ValueError(f"{twice[0]} is given twice, in [system] and in its parameters")
        others = {key: value for key, value in table.items() if key not in keys}
        return others | {"parameters": {key: table[key] for key in keys} | parameters}

    @field_validator("parameters")
    @classmethod
    def _whole_dimension(cls, parameters: dict[str, ParameterValue]) -> dict[str, ParameterValue]:
        dimension = parameters.get("dimension")
        if isinstance(dimension, float) and dimension.is_integer():
            return parameters | {"dimension": int(dimension)}
        return parameters


class _StartTable(FluidStartTable):
    """Orientation and angular velocity of the body at the start."""

    gamma: Vector | None
    """Outward normal of the surface at the contact, body axes; any length."""
    omega: Vector | None
    """Angular velocity, body axes."""
    heading: Number = Field(default=0.0, description="a finite angle (radians)")
    """Angle by which the body is turned about the normal."""
    normal: Direction = Field(default=(0.0, 0.0, 1.0), description=DIRECTION)
    """Outward normal of the surface at the first contact, space axes; any length."""


class StartTable(_StartTable):
    """The start of a rolling body."""

    gamma: Direction = Field(description=DIRECTION)
    omega: Vector = Field(description=THREE)


class SystemStartTable(_StartTable):
    """The start of a catalogue system; None for what it leaves out."""

    gamma: Direction | None = Field(default=None, description=DIRECTION)
    omega: Vector | None = Field(default=None, description=THREE)


def _state_value(value: object) -> ParameterValue:
    """A number, numbers in brackets, or rows of them, as the variable of the system requires."""
    return given_rows(value, STATE)


StateTable = dict[str, Annotated[ParameterValue, PlainValidator(_state_value)]]
"""The start of a system that is not given by ω and γ: variables of its state by name."""


def _known_method(name: str) -> str:
    from flowlanes.flow.methods import methods

    if name not in methods():
        raise ValueError(f"must be {' or '.join(json.dumps(m) for m in methods())}")
    return name


def _method_choices(schema: dict[str, Any]) -> None:
    """The methods that there are, for the schema of a file."""
    from flowlanes.flow.methods import methods

    schema["enum"] = list(methods())


def _require_option(info: ValidationInfo, option: str) -> None:
    """Refuse an option that the method of a run does not have."""
    from flowlanes.flow.methods import methods

    name = str(info.data.get("method"))
    if name in methods() and option not in methods()[name].options:
        raise ValueError(f"there is none with run.method = {json.dumps(name)}; leave it out")


class CommonRunTable(Table):
    """The keys common to all computations of a motion."""

    until: float | None
    """Duration, also of a computation backward in time."""
    samples: Annotated[StrictInt, Field(ge=2, le=MOST_SAMPLES)] = Field(
        default=101, description=f"a whole number from 2 to {MOST_SAMPLES}"
    )
    """Equidistant instants, both ends included."""
    precision: Literal["double", "quad"] = Field(default="double", description='"double" or "quad"')
    method: Annotated[str, AfterValidator(_known_method)] = Field(
        default="taylor", description='"taylor" or "gauss"', json_schema_extra=_method_choices
    )
    """Taylor series of a tolerance, or Gauss–Legendre collocation with all digits."""
    tolerance: Annotated[StrictFloat, Field(ge=FINEST, le=COARSEST)] = Field(
        default=None,
        validate_default=True,
        description=f"a number from {FINEST:g} to {COARSEST:g}",
    )
    """Local error allowed, relative to the size of the state; by default 1e-15, or 1e-30 in
    quad precision."""
    direction: Literal["forward", "backward"] = Field(
        default="forward", description='"forward" or "backward"'
    )
    """Of time."""
    on_liftoff: Literal["fly", "stop", "warn"]
    """The reaction when the normal force falls to zero."""
    keep_integrals: StrictBool = Field(default=False, description="true or false")
    """Whether the solution is projected on its integrals, and not on the constraints alone."""
    time_limit: Positive | None = Field(default=None, description="a positive number of seconds")
    """Time on the clock after which the computation stops."""

    @field_validator("tolerance", mode="before")
    @classmethod
    def _finest_by_default(cls, tolerance: object, info: ValidationInfo) -> object:
        finest = TOLERANCE[info.data.get("precision", "double")]
        if tolerance not in (None, finest):
            _require_option(info, "tolerance")
        return finest if tolerance is None else tolerance

    @field_validator("tolerance")
    @classmethod
    def _within_precision(cls, tolerance: float, info: ValidationInfo) -> float:
        if tolerance < FINEST_DOUBLE and info.data.get("precision") == "double":
            raise ValueError(
                f'{tolerance:g} needs run.precision = "quad"; with "double" it must be at '
                f"least {FINEST_DOUBLE:g}"
            )
        return tolerance

    @field_validator("time_limit")
    @classmethod
    def _where_there_is_one(cls, limit: float | None, info: ValidationInfo) -> float | None:
        if limit is not None:
            _require_option(info, "time_limit")
        return limit


class _RollingRunTable(CommonRunTable):
    """The run of a body whose constraints keep it on the surface."""

    on_liftoff: Literal["stop", "warn"] = Field(default="stop", description='"stop" or "warn"')

    @field_validator("on_liftoff", mode="before")
    @classmethod
    def _no_flight(cls, word: object) -> object:
        if word == "fly":
            raise ValueError(
                'must be "stop" or "warn"; a body that rolls by a constraint cannot leave the '
                'surface ("fly" needs contact.model = "friction")'
            )
        return word


class RunTable(_RollingRunTable):
    """The computation of the motion of a rolling body."""

    until: Positive = Field(default=10.0, description="a positive finite time")


class SystemRunTable(_RollingRunTable):
    """The computation of the motion of a system of the catalogue."""

    until: Positive | None = Field(default=None, description="a positive finite time")
    """Duration; None for the one that the catalogue suggests."""
