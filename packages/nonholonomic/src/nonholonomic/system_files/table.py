"""Tables of an experiment file, immutable and without unknown keys.

The description of a field completes the sentence "… must be", in errors and in documentation.
Units are SI, angles in radians.
"""

from __future__ import annotations

import keyword
import re
from typing import TYPE_CHECKING, Annotated, ClassVar

from pydantic import (
    AfterValidator,
    BaseModel,
    ConfigDict,
    Field,
    Strict,
    ValidationInfo,
    field_validator,
)

from flowlanes import parsing, system as core

if TYPE_CHECKING:
    import sympy as sp


Number = Annotated[float, Strict()]
Positive = Annotated[Number, Field(gt=0)]
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

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)


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
            if not re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*", name) or keyword.iskeyword(name):
                raise ValueError(
                    f"'{name}' cannot be used in a formula; a name has Latin letters, digits and _"
                )
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
