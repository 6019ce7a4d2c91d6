"""Tables of an experiment file, immutable and without unknown keys.

The description of a field completes the sentence "… must be", in errors and in documentation.
Units are SI, angles in radians.
"""

from __future__ import annotations

import keyword
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    Strict,
    ValidationInfo,
    field_validator,
)

from flowlanes import parsing, system as core
from flowlanes.errors import InputError

if TYPE_CHECKING:
    import sympy as sp


@dataclass(frozen=True)
class ParameterValues:
    """The values of the parameters of a file, in which its numbers may be written.

    Examples
    --------
    >>> from nonholonomic.system_files.table import ParameterValues
    >>> ParameterValues({"m": 2.0, "R": 0.5}).number("m*R**2")
    0.5
    """

    values: Mapping[str, float]

    def number(self, text: str) -> float:
        """The value of a formula.

        Raises
        ------
        ValueError
            If it cannot be read, or its value is no real number.
        """
        if text in self.values:
            return self.values[text]
        symbols = {name: core.real_symbol(name) for name in self.values}
        try:
            formula = parsing.parse(text, symbols, further="[parameters]")
        except InputError as error:
            raise ValueError(error.message) from None
        value = formula.xreplace({symbols[name]: self.values[name] for name in self.values})
        if not (value.is_real and value.is_finite):
            raise ValueError(f"'{text}' has no finite value for these parameters")
        return float(value)


def _evaluated(value: object, info: ValidationInfo) -> object:
    """The value of a formula in the parameters of the file, where it has any; else as given."""
    if isinstance(value, str) and isinstance(info.context, ParameterValues):
        return info.context.number(value)
    return value


def or_formula(**bounds: Any) -> BeforeValidator:
    """Accept a formula in the parameters of the file where a number within bounds is allowed."""
    return BeforeValidator(
        _evaluated, json_schema_input_type=Annotated[float, Field(**bounds)] | str
    )


Number = Annotated[float, Strict(), or_formula()]
Positive = Annotated[float, Strict(), Field(gt=0), or_formula(gt=0)]
NotNegative = Annotated[float, Strict(), Field(ge=0), or_formula(ge=0)]
Vector = tuple[Number, Number, Number]


def _not_zero(numbers: tuple[float, ...]) -> tuple[float, ...]:
    if not any(numbers):
        raise ValueError("must not be zero, as only its direction counts")
    return numbers


#: A vector, or a quaternion w, x, y, z, of any length.
Direction = Annotated[Vector, AfterValidator(_not_zero)]
Quaternion = Annotated[tuple[Number, Number, Number, Number], AfterValidator(_not_zero)]


def _positive_radius(radius: float) -> float:
    """A positive radius.

    Explain the former convention of a negative one for the inside of a sphere.
    """
    if radius < 0:
        raise ValueError(
            f'must be positive; for the inside write radius = {-radius!r} and side = "inside"'
        )
    if radius == 0:
        raise ValueError("must be positive")
    return radius


SphereRadius = Annotated[Number, AfterValidator(_positive_radius)]

POSITIVE = "a positive finite number"
SIDES = '"outside" or "inside"'
THREE = "3 finite numbers"
DIRECTION = "3 finite numbers with at least one not zero"
TURN = "4 finite numbers w, x, y, z with at least one not zero"
FORMULA = "a formula in quotes"


class Table(BaseModel):
    """A table of the file: immutable, without unknown keys or infinite numbers."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False, defer_build=True)


def require_name(name: str) -> None:
    """Raise ValueError unless a formula can contain a name."""
    if not re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*", name) or keyword.iskeyword(name):
        raise ValueError(
            f"'{name}' cannot be used in a formula; a name has Latin letters, digits and _"
        )


class FormulaTable(Table):
    """A table whose formulas may use named numbers."""

    variables: ClassVar[tuple[str, ...]] = ()
    place: ClassVar[str]
    """The path of the table in a file."""

    parameters: dict[str, Number] = Field(default={}, description="a table of named numbers")

    @property
    def names(self) -> tuple[str, ...]:
        """All names that a formula of this table may use, besides functions and ``pi``."""
        return (*self.variables, *self.parameters)

    def expression(self, text: str) -> sp.Expr:
        """A formula of this table as an expression in the symbols of its names."""
        return _expression(text, self.names)

    @field_validator("parameters")
    @classmethod
    def _nameable(cls, parameters: dict[str, float]) -> dict[str, float]:
        if parameters and not cls.variables:
            raise ValueError("only a shape given by a formula (revolution, implicit) has any")
        for name in parameters:
            require_name(name)
            if name in parsing.RESERVED_WORDS or name in _CORRECTIONS or name in cls.variables:
                raise ValueError(f"the name '{name}' has a meaning already; choose another")
        return parameters

    @classmethod
    def _formula(cls, text: str, info: ValidationInfo) -> sp.Expr | None:
        """Parse a formula; None if wrong parameters leave its names unknown."""
        if "parameters" not in info.data:
            return None
        names = (*cls.variables, *info.data["parameters"])
        return _expression(text, names, f"[{cls.place}.parameters]")

    @classmethod
    def _formula_in_space(cls, text: str, info: ValidationInfo, subject: str) -> str:
        """The text of a formula that must depend on x, y or z."""
        formula = cls._formula(text, info)
        if formula is not None and not {s.name for s in formula.free_symbols} & {"x", "y", "z"}:
            raise ValueError(f"{subject} must contain x, y or z")
        return text


_CORRECTIONS = frozenset(
    ["m", "g", "x", "y", "z", *(f"{letter}_{i}" for letter in ("gamma", "I") for i in (1, 2, 3))]
)


def _expression(text: str, names: tuple[str, ...], further: str = "") -> sp.Expr:
    return parsing.parse(text, {name: core.real_symbol(name) for name in names}, further=further)
