"""Find the situations that share their equations and differ only in parameter values."""

from __future__ import annotations

import math
from collections.abc import Hashable
from dataclasses import dataclass, fields
from functools import cached_property
from typing import TYPE_CHECKING, TypeGuard

from ...mechanics.rolling.body import Body
from ...mechanics.rolling.equations import Forces
from ...mechanics.shapes.shape_base import Shape
from ...mechanics.shapes.surfaces import Surface
from ..friction.friction_law import FrictionLaw
from .situation import FrictionalContact

if TYPE_CHECKING:
    from _typeshed import DataclassInstance


@dataclass(frozen=True, eq=False)
class SharedEquations:
    """A situation that compares equal to all those with the same equations.

    Two of them are equal if the equations of motion of their situations agree in every mode but
    for the values of parameters.

    Parameters
    ----------
    situation : FrictionalContact

    Examples
    --------
    >>> import nonholonomic
    >>> from nonholonomic.contact import Coulomb, FrictionalContact
    >>> from nonholonomic.contact.equations.structure import SharedEquations
    >>> ball = nonholonomic.Body(1.0, (0.4, 0.4, 0.4), nonholonomic.Ball(1.0))
    >>> rough, smooth = (FrictionalContact(ball, laws=(Coulomb(mu),)) for mu in (0.3, 0.1))
    >>> SharedEquations(rough) == SharedEquations(smooth)
    True
    """

    situation: FrictionalContact

    @cached_property
    def _pattern(self) -> Hashable:
        return _pattern_of(self.situation)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, SharedEquations) and self._pattern == other._pattern

    def __hash__(self) -> int:
        return hash(self._pattern)


def _pattern_of(value: object) -> Hashable:
    """A value with placeholders for the numbers that are parameters of the equations."""
    if isinstance(value, tuple):
        return tuple(map(_pattern_of, value))
    if isinstance(value, float | int) and not isinstance(value, bool):
        return "zero" if value == 0 else "infinite" if math.isinf(value) else "number"
    if _has_parameters(value):
        parts = tuple(_pattern_of(getattr(value, field.name)) for field in fields(value))
        return (type(value), *parts)
    # Formulas, names, and values whose numbers enter formulas.
    return value if isinstance(value, Hashable) else repr(value)


def _has_parameters(value: object) -> TypeGuard[DataclassInstance]:
    """Whether its numbers are parameters of the equations, unless they are zero or infinite."""
    if isinstance(value, Shape | Surface | FrictionLaw):
        return value.numbers_are_parameters
    return isinstance(value, FrictionalContact | Body | Forces)
