"""Laws of friction: force and couple of the support on the body that touches it.

Each law is a small value.  Its force and couple are proportional to the normal force N, or do not
depend on it.  Where a law has a threshold, the contact is held until the threshold is reached; the
guards of a law say when that is, and when a motion comes to its end.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.errors import InputError
from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Guard, Parameter
from flowlanes.system.vectors import Vector, dot, zero

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
        """Power (W) lost to the reaction, by the motion relative to the support; not negative."""
        moving = dot(N * self.p + self.force, slip)
        turning = dot(N * self.q + self.couple, spin * gamma + rolling)
        return -(moving + turning)


@dataclass(frozen=True)
class FrictionLaw(ABC):
    """A law of friction; the base of all of them.

    Notes
    -----
    The thresholds of a law are numbers; a law without thresholds has none:
    `static_mu` and `kinetic_mu` (at rest, and as the slip tends to zero), `spin_arm`,
    `patch_radius` and `holds_rolling`.

    Examples
    --------
    >>> import nonholonomic
    >>> isinstance(nonholonomic.contact.Coulomb(0.2), nonholonomic.contact.FrictionLaw)
    True
    """

    @property
    @abstractmethod
    def name(self) -> str:
        """The name of the work that is lost to it."""

    @property
    @abstractmethod
    def words(self) -> str:
        """The law in words."""

    @property
    @abstractmethod
    def parameters(self) -> tuple[Parameter, ...]:
        """Its coefficients with their values."""

    @property
    def clocks(self) -> Pairs:
        """Further variables of the state, with their rates."""
        return ()

    @property
    def static_mu(self) -> float | None:
        """Greatest force per normal force that holds a contact without slip; None: it never does.

        A number, 0 included, means that the force has a direction however small the slip is.
        """
        return None

    @property
    def kinetic_mu(self) -> float | None:
        """Limit of the force per normal force as the slip tends to zero, at most `static_mu`."""
        return self.static_mu

    @property
    def power(self) -> tuple[float, float]:
        """ν and p of a force ν|u|ᵖ for each unit of normal force, with no threshold."""
        return 0.0, 1.0

    @property
    def force_of_slip(self) -> sp.Expr | None:
        """Force per normal force as a formula in the slip speed; None where `power` says it."""
        return None

    @property
    def unknown_in_impacts(self) -> str:
        """The part of its formulas without meaning in an impact, in words; empty if none."""
        return ""

    @property
    def spin_arm(self) -> float:
        """Greatest couple per normal force (m) that holds the spin by itself, whatever the slip."""
        return 0.0

    @property
    def patch_radius(self) -> float:
        """Radius (m) of the patch over which slip and spin share the friction; 0 at a point."""
        return 0.0

    @property
    def holds_rolling(self) -> bool:
        """Whether a couple of the law holds a body that does not roll."""
        return False

    @abstractmethod
    def reaction(self, mode: Mode) -> Reaction:
        """Force and couple in a mode; what holds a contact is no part of it."""

    @property
    def reaction_at_rest(self) -> Reaction:
        """Force and couple as the slip tends to zero, besides what has a threshold there."""
        return self.reaction(Mode())

    @property
    def rolling_direction(self) -> Vector | None:
        """The symbols for the direction of rolling where that is prescribed."""
        return None

    def guards(self, mode: Mode) -> tuple[Guard, ...]:
        """Quantities that are positive as long as the mode lasts."""
        return ()

    def definitions(self, mode: Mode) -> Pairs:
        """Named intermediate quantities of its reaction."""
        return ()


def coefficient(symbol: sp.Symbol, meaning: str, value: float, unit: str) -> Parameter:
    """The parameter of a coefficient that is not negative."""
    return Parameter(symbol, meaning, value, unit, (symbol >= 0,))


def require_coefficient(key: str, value: float) -> None:
    """Refuse a coefficient that is negative or not finite.

    Raises
    ------
    InputError
    """
    if not (math.isfinite(value) and value >= 0):
        raise InputError(f"{key} {value}: it must be a finite number not below zero")
