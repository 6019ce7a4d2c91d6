"""Dry friction whose direction is prescribed as a function of time.

Where a held contact begins to slide, the slip grows like t² and its direction is that of the
friction force: the equations are smooth in time only if the direction is known.  So it is taken as
a polynomial of the time, whose coefficients are chosen such that the slip that it causes has it.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..core.named_formulas import Pairs
from ..core.system import Parameter
from ..core.vectors import Vector, cross, dot, norm_squared, real_symbol
from .contensou import shares
from .dry_friction import mu, patch
from .friction_law import FrictionLaw, Reaction
from .modes import Mode, Range
from .symbols import gamma

#: Time since sliding began, in units of its length, which is a parameter.
clock, duration = real_symbol("clock"), real_symbol("duration")

#: Direction at the start, body axes; the direction at a time; its angle from the first one.
first_direction, direction = Vector("n_0"), Vector("direction")
heading, latitude = real_symbol("phi_n"), real_symbol("theta_n")
first_latitude = real_symbol("theta_0")

DEGREE = 7
HEADING_COEFFICIENTS = tuple(real_symbol(f"phi_{i}") for i in range(1, DEGREE + 1))
LATITUDE_COEFFICIENTS = tuple(real_symbol(f"theta_{i}") for i in range(1, DEGREE + 1))

_across = Vector("across")


def _polynomial(first: sp.Expr, coefficients: tuple[sp.Symbol, ...]) -> sp.Expr:
    value: sp.Expr = sp.S.Zero
    for coefficient in reversed(coefficients):
        value = (value + coefficient) * clock
    return first + value


@dataclass(frozen=True)
class PrescribedDirection(FrictionLaw):
    """Coulomb's law, or Contensou's, with the direction of slip (and spin) prescribed.

    Parameters
    ----------
    name : str
        That of the law in whose place it stands.
    range : str
        The range of Contensou's law; empty for Coulomb's.
    """

    name: str = "coulomb"
    range: Range = ""
    words = "friction of prescribed direction"

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The coefficients of the law and of the polynomials; their values are set later."""
        coupled = bool(self.range)
        symbols = (mu, patch) if coupled else (mu,)
        angles = HEADING_COEFFICIENTS + (LATITUDE_COEFFICIENTS if coupled else ())
        others = (duration, *first_direction.symbols, *((first_latitude,) if coupled else ()))
        return tuple(
            Parameter(s, "of the beginning of sliding", 1.0) for s in (*symbols, *others, *angles)
        )

    @property
    def clocks(self) -> Pairs:
        """The time in units of the duration."""
        return ((clock, 1 / duration),)

    def definitions(self, mode: Mode) -> Pairs:
        """The direction as a function of the time."""
        tangential = first_direction - dot(gamma, first_direction) * gamma
        angles: Pairs = ((heading, _polynomial(sp.S.Zero, HEADING_COEFFICIENTS)),)
        if self.range:
            angles += ((latitude, _polynomial(first_latitude, LATITUDE_COEFFICIENTS)),)
        return (
            *angles,
            (_across, tangential / sp.sqrt(norm_squared(tangential))),
            (direction, sp.cos(heading) * _across + sp.sin(heading) * cross(gamma, _across)),
        )

    def reaction(self, mode: Mode) -> Reaction:
        """The force against the direction, and the couple that belongs to it."""
        if not self.range:
            return Reaction(p=-mu * direction)
        sine = sp.sin(latitude)
        force, couple = shares(self.range, sine, sine**2, sp.cos(latitude))
        return Reaction(p=-mu * force * sine * direction, q=-mu * patch * couple * gamma)
