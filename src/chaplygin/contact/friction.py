"""The laws of friction, and which of them exclude each other."""

from __future__ import annotations

from collections.abc import Sequence

from ..errors import InputError
from .dry_friction import (
    ContensouErismann,
    Coulomb,
    SpinFriction,
)
from .friction_law import FrictionLaw, Reaction
from .rolling_friction import (
    ContourResistance,
    RollingResistance,
    ViscousRolling,
)
from .viscous_friction import NormalViscous, Viscous

__all__ = [
    "ContensouErismann",
    "ContourResistance",
    "Coulomb",
    "FrictionLaw",
    "NormalViscous",
    "Reaction",
    "RollingResistance",
    "SpinFriction",
    "Viscous",
    "ViscousRolling",
    "require_compatible",
]


def require_compatible(laws: Sequence[FrictionLaw]) -> None:
    """Refuse laws that say two things of one motion.

    Raises
    ------
    InputError
        If a law is given twice, or Contensou's law together with dry friction at a point or a
        spin couple of its own.
    """
    names = [law.name for law in laws]
    for name in names:
        if names.count(name) > 1:
            raise InputError(f"friction: the law {name!r} is given twice")
    for other in ("coulomb", "spin"):
        if "contensou" in names and other in names:
            raise InputError(
                "friction: a patch of contact has its own law of sliding and spinning; "
                f"it excludes the law {other!r}"
            )
    if "rolling" in names and "contour" in names:
        raise InputError("friction: resistance to rolling excludes resistance along the contour")
