"""Requests that a page may send, validated before anything is done.

A request is a JSON object; ``do`` says what is asked. Its subject is a system of the catalogue or
an experiment, with options as of ``--set``.
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

#: Bytes of a request at most.
LARGEST = 256 * 1024

#: Samples of a motion that is sent to a page at most.
MOST_SAMPLES = 20_001

#: Cells along each axis of a chart at most.
MOST_CELLS = 2000

#: A key of an experiment file, or the name of a parameter.
_KEY = re.compile(r"\w+(\.\w+)*")

Number: TypeAlias = Annotated[float, Field(allow_inf_nan=False)]
Short: TypeAlias = Annotated[str, Field(max_length=200)]
Formula: TypeAlias = Annotated[str, Field(max_length=2000)]


class _Request(BaseModel):
    """A table whose keys are all known, with values of exactly these kinds."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)


class Subject(_Request):
    """The subject of a request: a name of the catalogue or a file, and options.

    Attributes
    ----------
    what : str
    set : mapping
        Keys of the experiment file, or names of parameters, with their values.
    experiment : str, optional
        The text of an experiment file, in place of what `what` means.
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
    """A value as TOML writes it.

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
    """Which systems and files there are."""

    do: Literal["list"]


class Opening(_OfSubject):
    """The model of a page."""

    do: Literal["open"]


class Motion(_OfSubject):
    """A motion, sampled."""

    do: Literal["motion"]


class Proof(_OfSubject):
    """The verdicts on the laws of a system, or on one of them."""

    do: Literal["prove"]
    law: Short | None = None
    effort: Annotated[float, Field(gt=0, le=10)] = 1.0


class Search(_OfSubject):
    """Laws found from the equations alone."""

    do: Literal["find"]
    kind: Literal["integrals", "measure", "symmetries"]
    degree: Annotated[int, Field(ge=0, le=6)] = 2
    gamma_degree: Annotated[int, Field(ge=0, le=6)] = 2


class ClosedForm(_OfSubject):
    """The motion in closed form."""

    do: Literal["solve"]


class BifurcationDiagram(_OfSubject):
    """The bifurcation diagram of an integrable system."""

    do: Literal["bifurcation"]


class Chart(_OfSubject):
    """A number over a plane, kept in a store."""

    do: Literal["chart"]
    of: Formula
    x: Short
    y: Short
    until: Annotated[Number, Field(gt=0)] | None = None


class PeriodicOrbit(_OfSubject):
    """A periodic orbit near the motion."""

    do: Literal["orbit"]
    on: Formula
    value: Number = 0.0
    direction: Literal["rising", "falling", "both"] = "rising"
    after: Annotated[int, Field(ge=0, le=100_000)] = 1
    period: Annotated[int, Field(ge=1, le=1000)] = 1
    hold: Annotated[list[Short], Field(max_length=20)] = []


class Data(_OfSubject):
    """A trajectory as a file."""

    do: Literal["data"]
    format: Literal["nc", "csv"]


class Saving(_Request):
    """An experiment to be written to the folder."""

    do: Literal["save"]
    file: Short
    experiment: Annotated[str, Field(max_length=LARGEST)]
    replace: bool = False


#: What a worker computes.
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
    """The request that a message makes.

    Raises
    ------
    InputError
        If it makes none.

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
