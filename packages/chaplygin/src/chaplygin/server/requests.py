"""Requests that a page may send, validated before anything is done.

A request is a JSON object; ``do`` names the action.  Its subject is a system of the catalogue or an
experiment, with options as for ``--set``.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Mapping
from typing import Annotated, Literal, TypeAlias

import tomli_w
from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError, field_validator

from flowlanes.errors import InputError

#: Maximum size of a request in bytes.
LARGEST = 256 * 1024

#: Maximum number of samples of a motion sent to a page.
MOST_SAMPLES = 20_001

#: Maximum number of cells along each axis of a chart.
MOST_CELLS = 2000

#: A key of an experiment file, or the name of a parameter.
_KEY = re.compile(r"\w+(\.\w+)*")

Number: TypeAlias = Annotated[float, Field(allow_inf_nan=False)]
Short: TypeAlias = Annotated[str, Field(max_length=200)]
Formula: TypeAlias = Annotated[str, Field(max_length=2000)]


class _Request(BaseModel):
    """A table with known keys and strictly typed values."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)


class Subject(_Request):
    """The subject of a request: a catalogue name or a file, and options.

    Attributes
    ----------
    what : str
    set : mapping
        Keys of the experiment file, or names of parameters, with their values.
    experiment : str, optional
        The text of an experiment file, used in place of the subject named by `what`.
    """

    what: Short
    experiment: Annotated[str, Field(max_length=LARGEST)] | None = None
    set: dict[Short, object] = Field(default_factory=dict, max_length=200)

    @field_validator("set")
    @classmethod
    def _is_plain(cls, values: dict[str, object]) -> dict[str, object]:
        for key, value in values.items():
            if not _KEY.fullmatch(key):
                raise ValueError(f"{key!r} is no key of an experiment file")
            _toml(value, key)
        return values

    @property
    def options(self) -> list[str]:
        """The changes as options ``KEY=VALUE``."""
        return [f"{key}={_toml(value, key)}" for key, value in self.set.items()]


def _toml(value: object, key: str, depth: int = 0) -> str:
    """A value written as TOML.

    Raises
    ------
    ValueError
        If it is neither a number, a text, a truth value nor a short list of such.
    """
    match value:
        case bool():
            return str(value).lower()
        case int() if abs(value) < 2**63:
            return str(value)
        case float() if math.isfinite(value):
            return repr(value)
        case str() if len(value) <= 2000 and value.isprintable():
            return tomli_w.dumps({"x": value}).removeprefix("x = ").rstrip("\n")
        case list() if len(value) <= 200 and depth < 3:
            return f"[{', '.join(_toml(inner, key, depth + 1) for inner in value)}]"
    raise ValueError(f"{key} must be a finite number, a line of text, or a short list of such")


class _OfSubject(_Request):
    subject: Subject


class Listing(_Request):
    """Lists the available systems and files."""

    do: Literal["list"]


class Opening(_OfSubject):
    """Requests the model of a page."""

    do: Literal["open"]


class Motion(_OfSubject):
    """Requests a sampled motion."""

    do: Literal["motion"]


class Proof(_OfSubject):
    """Requests the verdicts on the laws of a system, or on one of them."""

    do: Literal["prove"]
    law: Short | None = None
    effort: Annotated[float, Field(gt=0, le=10)] = 1.0


class Search(_OfSubject):
    """Requests a search for laws from the equations alone."""

    do: Literal["find"]
    kind: Literal["integrals", "measure", "symmetries"]
    degree: Annotated[int, Field(ge=0, le=6)] = 2
    gamma_degree: Annotated[int, Field(ge=0, le=6)] = 2


class ClosedForm(_OfSubject):
    """Requests the motion in closed form."""

    do: Literal["solve"]


class BifurcationDiagram(_OfSubject):
    """Requests the bifurcation diagram of an integrable system."""

    do: Literal["bifurcation"]


class Chart(_OfSubject):
    """Requests a quantity over a plane, kept in a store."""

    do: Literal["chart"]
    of: Formula
    x: Short
    y: Short
    until: Annotated[Number, Field(gt=0)] | None = None


class PeriodicOrbit(_OfSubject):
    """Requests a periodic orbit near the motion."""

    do: Literal["orbit"]
    on: Formula
    value: Number = 0.0
    direction: Literal["rising", "falling", "both"] = "rising"
    after: Annotated[int, Field(ge=0, le=100_000)] = 1
    period: Annotated[int, Field(ge=1, le=1000)] = 1
    hold: Annotated[list[Short], Field(max_length=20)] = []


class Data(_OfSubject):
    """Requests a trajectory as a file."""

    do: Literal["data"]
    format: Literal["nc", "csv"]


class Saving(_Request):
    """Requests that an experiment be written to the folder."""

    do: Literal["save"]
    file: Short
    experiment: Annotated[str, Field(max_length=LARGEST)]
    replace: bool = False


#: The requests that a worker computes.
Computation: TypeAlias = (
    Opening
    | Motion
    | Proof
    | Search
    | ClosedForm
    | BifurcationDiagram
    | Chart
    | PeriodicOrbit
    | Data
    | Saving
)

Request: TypeAlias = Annotated[Computation | Listing, Field(discriminator="do")]

_REQUEST: TypeAdapter[Computation | Listing] = TypeAdapter(Request)


def request_of(body: bytes) -> Computation | Listing:
    """Parse a message into a request.

    Raises
    ------
    InputError
        If the message is not a valid request.

    Examples
    --------
    >>> request_of(b'{"do": "solve", "subject": {"what": "veselova"}}').subject.what
    'veselova'
    """
    try:
        value = json.loads(body, parse_constant=_no_number)
    except (ValueError, RecursionError):
        raise InputError("the message is not JSON") from None
    if not isinstance(value, Mapping):
        raise InputError("the message must be a JSON object")
    try:
        return _REQUEST.validate_python(value)
    except ValidationError as error:
        first = error.errors(include_url=False, include_input=False, include_context=False)[0]
        place = ".".join(str(part) for part in first["loc"][1:]) or "do"
        words = first["msg"].removeprefix("Value error, ")
        raise InputError(f"{place}: {words[0].lower()}{words[1:]}") from None


def _no_number(name: str) -> None:
    raise ValueError(name)
