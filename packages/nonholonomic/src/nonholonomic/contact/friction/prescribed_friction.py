"""Friction, or rolling resistance, with a direction or force prescribed as a function of time.

When a held contact begins to slide, the slip grows like t² and its direction is that of the
friction force, so the equations are smooth in time only if the direction is known.  It is therefore
a polynomial in time, with coefficients chosen such that the resulting slip has this direction.  The
same holds for rolling that a resistance has held.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from flowlanes.system.arrays import FloatArray
from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Parameter
from flowlanes.system.vectors import Vector, cross, dot, norm_squared, real_symbol

from .contensou import shares
from .dry_friction import mu, patch
from .friction_law import FrictionLaw, Reaction
from .modes import Mode, Range
from .symbols import gamma, slip

#: Time since sliding began, relative to the duration, which is a parameter.
clock, duration = real_symbol("clock"), real_symbol("duration")

#: Initial direction (body axes), current direction, and its angle from the initial one.
first_direction, direction = Vector("n_0"), Vector("direction")
heading, latitude = real_symbol("phi_n"), real_symbol("theta_n")
first_latitude = real_symbol("theta_0")

DEGREE = 7
HEADING_COEFFICIENTS = tuple(real_symbol(f"phi_{i}") for i in range(1, DEGREE + 1))
LATITUDE_COEFFICIENTS = tuple(real_symbol(f"theta_{i}") for i in range(1, DEGREE + 1))
SIZE_COEFFICIENTS = tuple(real_symbol(f"size_{i}") for i in range(1, DEGREE + 1))

#: Components of a prescribed force per unit of normal force, along `_across` and γ×`_across`.
FORCE_COEFFICIENTS = tuple(
    tuple(real_symbol(f"force_{axis}_{i}") for i in range(DEGREE + 1)) for axis in (1, 2)
)

_across, _force = Vector("across"), Vector("force_n")


def _polynomial(first: sp.Expr, coefficients: tuple[sp.Symbol, ...]) -> sp.Expr:
    value: sp.Expr = sp.S.Zero
    for coefficient in reversed(coefficients):
        value = (value + coefficient) * clock
    return first + value


def first_direction_values(first: FloatArray) -> dict[str, float]:
    """The parameters that describe an initial direction (3,), by name."""
    return {str(symbol): float(x) for symbol, x in zip(first_direction.symbols, first, strict=True)}


_MEANING = "of the beginning of a motion that was held"

_TANGENTIAL = first_direction - dot(gamma, first_direction) * gamma

_ACROSS: Pairs = ((_across, _TANGENTIAL / sp.sqrt(norm_squared(_TANGENTIAL))),)

_DIRECTION: Pairs = (
    (heading, _polynomial(sp.S.Zero, HEADING_COEFFICIENTS)),
    *_ACROSS,
    (direction, sp.cos(heading) * _across + sp.sin(heading) * cross(gamma, _across)),
)


@dataclass(frozen=True)
class PrescribedRolling(FrictionLaw):
    """Rolling resistance with a prescribed direction of rolling.

    Parameters
    ----------
    law : FrictionLaw
        The law that is replaced.
    """

    law: FrictionLaw
    description = "resistance to a rolling of prescribed direction"

    @property
    def name(self) -> str:
        """Name of the law that is replaced."""
        return self.law.name

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The coefficient of the law, and those of the polynomial; these are set later."""
        symbols = (duration, *first_direction.symbols, *HEADING_COEFFICIENTS)
        return self.law.parameters + tuple(Parameter(symbol, _MEANING, 1.0) for symbol in symbols)

    @property
    def clocks(self) -> Pairs:
        """The time in units of the duration."""
        return ((clock, 1 / duration),)

    @property
    def rolling_direction(self) -> Vector:
        """The prescribed direction of rolling."""
        return direction

    def definitions(self, mode: Mode) -> Pairs:
        """The direction as a function of the time."""
        return _DIRECTION

    def reaction(self, mode: Mode) -> Reaction:
        """The couple against a rolling of this direction."""
        return self.law.couple_along(direction)


@dataclass(frozen=True)
class PrescribedPower(FrictionLaw):
    """Power-law friction along the prescribed direction of an incipient slip.

    A non-integer power is not a smooth function of an incipient slip, and is therefore also
    replaced by a polynomial in time.

    Parameters
    ----------
    law : FrictionLaw
        The law that is replaced.
    """

    law: FrictionLaw
    description = "friction of a power of the slip, of prescribed direction"

    @property
    def name(self) -> str:
        """Name of the law that is replaced."""
        return self.law.name

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """ν, and the coefficients of the polynomial if the power needs one."""
        symbols = () if self.law.power[1].is_integer() else SIZE_COEFFICIENTS
        return self.law.parameters + tuple(Parameter(symbol, _MEANING, 0.0) for symbol in symbols)

    def reaction(self, mode: Mode) -> Reaction:
        """The force against the direction; the length of the slip is not smooth at its start."""
        (power_viscous,) = (p.symbol for p in self.law.parameters)
        order = self.law.power[1]
        if order.is_integer():
            size = dot(slip, direction) ** int(order)
        else:
            size = _polynomial(sp.S.Zero, SIZE_COEFFICIENTS)
        return Reaction(p=-power_viscous * size * direction)


@dataclass(frozen=True)
class PrescribedForce(FrictionLaw):
    """The part of one law in a prescribed total friction force.

    Parameters
    ----------
    name : str
        Name of the law that is replaced.
    is_dry : bool
        Whether the part is that of dry friction, with the size μ; otherwise it is the rest.
    beside_dry : bool
        Whether there is such a part.
    """

    name: str = "power"
    is_dry: bool = False
    beside_dry: bool = False
    description = "friction of prescribed force"

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The coefficients of the polynomials, and μ; these are set later."""
        of_force = (symbol for row in FORCE_COEFFICIENTS for symbol in row)
        symbols = (mu,) if self.is_dry else (duration, *first_direction.symbols, *of_force)
        return tuple(Parameter(symbol, _MEANING, 1.0) for symbol in symbols)

    @property
    def clocks(self) -> Pairs:
        """The time in units of the duration."""
        return () if self.is_dry else ((clock, 1 / duration),)

    def definitions(self, mode: Mode) -> Pairs:
        """The force as a function of the time."""
        if self.is_dry:
            return ()
        along, aside = (_polynomial(row[0], row[1:]) for row in FORCE_COEFFICIENTS)
        return (*_ACROSS, (_force, along * _across + aside * cross(gamma, _across)))

    def reaction(self, mode: Mode) -> Reaction:
        """The dry part of size μ, or the rest of the total force."""
        if not self.beside_dry:
            return Reaction(p=_force)
        share = mu / sp.sqrt(norm_squared(_force))
        return Reaction(p=(share if self.is_dry else 1 - share) * _force)


@dataclass(frozen=True)
class PrescribedDirection(FrictionLaw):
    """Dry friction with a prescribed direction of slip (and spin).

    Parameters
    ----------
    name : str
        Name of the law that is replaced.
    range : str
        The range of Contensou's law; empty for others.
    law : FrictionLaw, optional
        The law that is replaced, if its force depends on the slip speed.
    """

    name: str = "coulomb"
    range: Range = ""
    law: FrictionLaw | None = None
    description = "friction of prescribed direction"

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The coefficients of the law and of the polynomials; their values are set later."""
        symbols: tuple[sp.Symbol, ...] = (duration, *first_direction.symbols)
        if self.range:
            symbols = (mu, patch, *symbols, first_latitude, *LATITUDE_COEFFICIENTS)
        elif self.law is None:
            symbols = (mu, *symbols)
        own = self.law.parameters if self.law else ()
        return own + tuple(
            Parameter(symbol, _MEANING, 1.0) for symbol in (*symbols, *HEADING_COEFFICIENTS)
        )

    @property
    def clocks(self) -> Pairs:
        """The time in units of the duration."""
        return ((clock, 1 / duration),)

    def definitions(self, mode: Mode) -> Pairs:
        """The direction as a function of the time."""
        if self.range:
            angle = _polynomial(first_latitude, LATITUDE_COEFFICIENTS)
            return ((latitude, angle), *_DIRECTION)
        return _DIRECTION

    def reaction(self, mode: Mode) -> Reaction:
        """The force against the direction, and the couple that belongs to it."""
        if self.law:
            # the length of the slip itself is not smooth where it begins
            return self.law.reaction_along(direction, dot(slip, direction), mode)
        if not self.range:
            return Reaction(p=-mu * direction)
        sine = sp.sin(latitude)
        force, couple = shares(self.range, sine, sine**2, sp.cos(latitude))
        return Reaction(p=-mu * force * sine * direction, q=-mu * patch * couple * gamma)


def prescribed_direction(law: FrictionLaw, span: Range = "") -> PrescribedDirection:
    """The law with prescribed direction that replaces dry friction while sliding begins.

    Parameters
    ----------
    law : FrictionLaw
        A law whose `static_mu` is a number.
    span : str
        The range of Contensou's law.

    Examples
    --------
    >>> from nonholonomic.contact.friction.dry_friction import Coulomb
    >>> from nonholonomic.contact.friction.prescribed_friction import prescribed_direction
    >>> prescribed_direction(Coulomb(0.3)).name
    'coulomb'
    """
    return PrescribedDirection(law.name, span, law if law.depends_on_speed else None)
