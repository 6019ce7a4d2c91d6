"""Laws of friction: force and couple of the support on the body that touches it.

Each law is a small immutable value.  Its force and couple are proportional to the normal force N or
independent of it.  A law with a threshold holds the contact until the threshold is reached.  The
guards of a law detect this, and the end of a motion that the law stops.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar, Literal

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.errors import InputError
from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Guard, Parameter
from flowlanes.system.vectors import Vector, dot, zero

from ...mechanics.shapes.kinds import Registered
from .modes import Mode
from .symbols import N, gamma, rolling, slip, spin


@dataclass(frozen=True)
class Reaction:
    """Force and couple of a law on the body, body axes.

    Attributes
    ----------
    p, q : MatrixExpr
        Force (1) and couple (m) for each unit of normal force.
    force, couple : MatrixExpr
        Force (N) and couple (N m) that do not depend on the normal force.

    Examples
    --------
    >>> from nonholonomic.contact.friction.dry_friction import Coulomb
    >>> from nonholonomic.contact.friction.friction_law import Reaction
    >>> from nonholonomic.contact.friction.viscous_friction import Viscous
    >>> from nonholonomic.contact.friction.modes import Mode
    >>> sliding = Mode()
    >>> Viscous(0.5).reaction(sliding) + Reaction() == Viscous(0.5).reaction(sliding)
    True
    >>> Coulomb(0.3).reaction(sliding).power
    N*mu*Dot(slip, slip)/slip_speed
    """

    p: MatrixExpr = zero
    q: MatrixExpr = zero
    force: MatrixExpr = zero
    couple: MatrixExpr = zero

    def __add__(self, other: Reaction) -> Reaction:
        return Reaction(
            self.p + other.p,
            self.q + other.q,
            self.force + other.force,
            self.couple + other.couple,
        )

    @property
    def power(self) -> sp.Expr:
        """Power (W) dissipated by the reaction through the relative motion; not negative."""
        moving = dot(N * self.p + self.force, slip)
        turning = dot(N * self.q + self.couple, spin * gamma + rolling)
        return -(moving + turning)


@dataclass(frozen=True)
class FrictionLaw(Registered, ABC):
    """Base class of the friction laws.

    Notes
    -----
    A class that sets `kind` is known by that word to experiment files as soon as its module is
    imported: its fields are the keys of [contact.laws.KIND]. A law determined by its coefficients
    and one formula derives from `CoefficientLaw`.

    The thresholds of a law are numbers; a law without thresholds has none:
    `static_mu` and `kinetic_mu` (at rest, and as the slip tends to zero), `spin_arm`,
    `patch_radius` and `holds_rolling`.

    Examples
    --------
    >>> import nonholonomic
    >>> isinstance(nonholonomic.contact.Coulomb(0.2), nonholonomic.contact.FrictionLaw)
    True
    """

    excludes: ClassVar[Mapping[str, str]] = {}
    """Kinds of law that it excludes, each with the reason."""
    numbers_are_parameters: ClassVar[bool] = False
    """Whether all members with positive numbers have the same equations."""
    resists_slip: ClassVar[bool] = True
    """Whether its force acts against the slip."""
    resists_rolling: ClassVar[bool] = False
    """Whether its couple acts against rolling."""
    is_along_contour: ClassVar[bool] = False
    """Whether it resists the motion of the contact point over the body."""
    has_constant_force: ClassVar[bool] = False
    """Whether the force of a sliding contact is μN, independent of spin and rolling."""
    depends_on_speed: ClassVar[bool] = False
    """Whether `reaction_along` gives its reaction where sliding begins."""

    @property
    def summary(self) -> str:
        """A sentence or two on the law, for reports."""
        return f"{self.description[:1].upper()}{self.description[1:]}."

    @property
    def is_smooth(self) -> bool:
        """Whether the force is a smooth function of the slip where that vanishes, but for μN."""
        return True

    @property
    def name(self) -> str:
        """The name of the law, and of the work that it dissipates."""
        return self.kind

    @property
    @abstractmethod
    def description(self) -> str:
        """A description of the law."""

    @property
    @abstractmethod
    def parameters(self) -> tuple[Parameter, ...]:
        """The coefficients with their values."""

    @property
    def clocks(self) -> Pairs:
        """Additional state variables with their rates."""
        return ()

    @property
    def static_mu(self) -> float | None:
        """Largest force per normal force that holds a contact without slip.

        None if nothing holds it.

        Any number, including 0, means that the force has a direction for arbitrarily small slips.
        """
        return None

    @property
    def kinetic_mu(self) -> float | None:
        """Limit of the force per normal force as the slip tends to zero, at most `static_mu`."""
        return self.static_mu

    @property
    def power(self) -> tuple[float, float]:
        """ν and p of a force ν|u|ᵖ per unit of normal force that has no threshold."""
        return 0.0, 1.0

    @property
    def slip_viscosity(self) -> float:
        """c of a force −c u that does not depend on the normal force."""
        return 0.0

    @property
    def dissipation(self) -> tuple[tuple[sp.Expr, ...], ...]:
        """The power lost in general motion, as a sum of products of nonnegative factors.

        Each factor is a coefficient, the normal force, a speed or a square; empty if it is not
        known; then no decrease of energy is claimed.
        """
        return ()

    @property
    def force_of_slip(self) -> sp.Expr | None:
        """Force per normal force as a formula in the slip speed; None if `power` gives it."""
        return None

    @property
    def unknown_in_impacts(self) -> str:
        """Names the part of its formulas that is undefined in an impact; empty if there is none."""
        return ""

    @property
    def spin_arm(self) -> float:
        """Largest couple per normal force (m) that holds the spin independently of the slip."""
        return 0.0

    @property
    def patch_radius(self) -> float:
        """Radius (m) of the patch over which slip and spin share the friction; 0 for a point."""
        return 0.0

    @property
    def holds_rolling(self) -> bool:
        """Whether a couple of the law can keep a body from rolling."""
        return False

    @abstractmethod
    def reaction(self, mode: Mode) -> Reaction:
        """Force and couple in a mode, without the forces that hold the contact."""

    @property
    def reaction_at_rest(self) -> Reaction:
        """Force and couple in the limit of zero slip, without terms that have a threshold there."""
        return self.reaction(Mode())

    def reaction_along(self, direction: Vector, speed: sp.Expr, mode: Mode) -> Reaction:
        """Force and couple where a slip of this direction and speed begins, if they depend on it.

        Parameters
        ----------
        direction : Vector
            Unit vector of the slip.
        speed : sympy.Expr
            A smooth function that is the length of the slip.
        """
        return self.reaction(mode)

    def couple_along(self, direction: Vector) -> Reaction:
        """The couple of a law that holds rolling, where a rolling of this direction begins."""
        return Reaction()

    @property
    def rolling_direction(self) -> Vector | None:
        """The symbols for a prescribed direction of rolling."""
        return None

    def guards(self, mode: Mode) -> tuple[Guard, ...]:
        """Quantities that are positive while the mode lasts."""
        return ()

    def definitions(self, mode: Mode) -> Pairs:
        """Named intermediate quantities of the reaction."""
        return ()


@dataclass(frozen=True)
class Coefficient:
    """A coefficient of a law, not negative and finite.

    Attributes
    ----------
    field : str
        The field of the law that has its value.
    symbol : sympy.Symbol
    meaning, unit : str
    key : str
        Its name in messages; by default that of the field.
    """

    field: str
    symbol: sp.Symbol
    meaning: str
    unit: str
    key: str = ""


@dataclass(frozen=True)
class CoefficientLaw(FrictionLaw):
    """A law determined by its coefficients and one formula.

    Examples
    --------
    >>> from dataclasses import dataclass
    >>> from nonholonomic.contact.friction.friction_law import (
    ...     Coefficient,
    ...     CoefficientLaw,
    ...     Reaction,
    ... )
    >>> from nonholonomic.contact.friction.modes import Mode
    >>> from nonholonomic.contact.friction.symbols import slip, slip_speed
    >>> from flowlanes.system.vectors import real_symbol
    >>> c = real_symbol("c_q")
    >>> @dataclass(frozen=True)
    ... class Quadratic(CoefficientLaw):
    ...     drag: float
    ...     coefficients = (Coefficient("drag", c, "coefficient of drag", "kg/m"),)
    ...     in_words = "drag {drag:g} kg/m times the square of the slip"
    ...     acts_while = "sliding"
    ...     formula = Reaction(force=-c * slip_speed * slip)
    >>> Quadratic(0.5).description, Quadratic(0.5).reaction(Mode()).force
    ('drag 0.5 kg/m times the square of the slip', (-c_q*slip_speed)*slip)
    """

    coefficients: ClassVar[tuple[Coefficient, ...]]
    in_words: ClassVar[str]
    """The law in words, with its fields in braces."""
    acts_while: ClassVar[Literal["", "sliding", "spinning", "rolling"]] = ""
    """The motion it opposes; empty if its formula is smooth and needs no distinction."""
    formula: ClassVar[Reaction]
    """Force and couple while it acts."""

    numbers_are_parameters: ClassVar[bool] = True

    def __post_init__(self) -> None:
        for item in self.coefficients:
            require_coefficient(item.key or item.field, getattr(self, item.field))

    @property
    def description(self) -> str:
        """The law in words."""
        return self.in_words.format_map(vars(self))

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The coefficients with their values."""
        return tuple(
            coefficient(item.symbol, item.meaning, getattr(self, item.field), item.unit)
            for item in self.coefficients
        )

    def reaction(self, mode: Mode) -> Reaction:
        """The formula while the opposed motion exists, else zero."""
        acts = not self.acts_while or getattr(mode, self.acts_while)
        return self.formula if acts else Reaction()


def coefficient(symbol: sp.Symbol, meaning: str, value: float, unit: str) -> Parameter:
    """The parameter for a nonnegative coefficient."""
    return Parameter(symbol, meaning, value, unit, (symbol >= 0,))


def require_coefficient(key: str, value: float) -> None:
    """Raise an error if a coefficient is negative or not finite.

    Raises
    ------
    InputError
    """
    if not (math.isfinite(value) and value >= 0):
        raise InputError(f"{key} {value}: it must be a finite number not below zero")
