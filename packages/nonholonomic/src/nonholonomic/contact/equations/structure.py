"""Which situations share their equations, and differ in the values of parameters alone."""

from __future__ import annotations

import math
from collections.abc import Hashable
from dataclasses import dataclass, fields
from functools import cached_property

from ...mechanics.rolling.body import Body
from ...mechanics.rolling.equations import Forces
from ...mechanics.shapes.shapes import Ball, Disk, Ellipsoid, Torus
from ...mechanics.shapes.surfaces import Plane, Sphere
from ..friction.air_film import AirFilm
from ..friction.dry_friction import ContensouErismann, Coulomb, SpinFriction
from ..friction.rolling_friction import ContourResistance, RollingResistance, ViscousRolling
from ..friction.viscous_friction import NormalViscous, Viscous
from .situation import FrictionalContact

#: Values whose numbers are parameters of the equations, unless they are zero or infinite.
_BY_PARAMETERS = (
    FrictionalContact,
    Body,
    Forces,
    Ball,
    Disk,
    Ellipsoid,
    Torus,
    Plane,
    Sphere,
    Coulomb,
    ContensouErismann,
    SpinFriction,
    Viscous,
    NormalViscous,
    RollingResistance,
    ViscousRolling,
    ContourResistance,
    AirFilm,
)


@dataclass(frozen=True, eq=False)
class SharedEquations:
    """A situation that equals all those with the same equations.

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
    """A value with its numbers replaced, where they are parameters of the equations."""
    if isinstance(value, tuple):
        return tuple(map(_pattern_of, value))
    if isinstance(value, float | int) and not isinstance(value, bool):
        return "zero" if value == 0 else "infinite" if math.isinf(value) else "number"
    if isinstance(value, _BY_PARAMETERS):
        parts = tuple(_pattern_of(getattr(value, field.name)) for field in fields(value))
        return (type(value).__name__, *parts)
    # formulas, names, and values that put their numbers into formulas
    return value if isinstance(value, Hashable) else repr(value)
