"""Laws of friction: the force and the couple of a support on the body that touches it.

Each law is a small value.  Its force and couple are proportional to the normal force N, except those
of the viscous law.  Where a law has a threshold, the contact is held until the threshold is
reached; the guards of a law say when that is, and when a motion comes to its end.
"""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from ..arguments import arguments_checked
from ..core.named_formulas import Pairs
from ..core.system import Guard, Parameter
from ..core.vectors import dot, norm_squared, real_symbol, zero
from ..errors import InputError
from . import contensou
from .modes import Mode
from .symbols import (
    N,
    contour_couple,
    friction,
    gamma,
    holding_couple,
    rolling,
    rolling_floor,
    rolling_speed,
    slip,
    slip_floor,
    slip_speed,
    spin,
    spin_sign,
)

mu, nu, spin_arm, patch, viscous, spin_viscous, rolling_arm, rolling_viscous, contour_arm = (
    real_symbol(name)
    for name in (
        "mu",
        "nu_s",
        "spin_arm",
        "patch",
        "c_v",
        "c_s",
        "delta_r",
        "c_r",
        "mu_c",
    )
)


@dataclass(frozen=True)
class Reaction:
    """Force and couple of a law, body axes.

    Attributes
    ----------
    p, q : MatrixExpr
        Force and couple for each unit of normal force.
    force, couple : MatrixExpr
        Force (N) and couple (N m) that do not depend on the normal force.
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
        """Power that the reaction takes from the body on a support at rest, not negative."""
        moving = dot(N * self.p + self.force, slip)
        turning = dot(N * self.q + self.couple, spin * gamma + rolling)
        return -(moving + turning)


@dataclass(frozen=True)
class FrictionLaw:
    """A law of friction; the base of all of them."""

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

    @abstractmethod
    def reaction(self, mode: Mode) -> Reaction:
        """Force and couple in a mode; what holds a contact is no part of it."""

    def guards(self, mode: Mode) -> tuple[Guard, ...]:
        """Quantities that are positive as long as the mode lasts."""
        return ()

    def definitions(self, mode: Mode) -> Pairs:
        """Named intermediate quantities of its reaction."""
        return ()


def _coefficient(symbol: sp.Symbol, meaning: str, value: float, unit: str) -> Parameter:
    return Parameter(symbol, meaning, value, unit, (symbol >= 0,))


def _require_coefficient(name: str, value: float) -> None:
    if not (math.isfinite(value) and value >= 0):
        raise InputError(f"{name} {value}: it must be a finite number not below zero")


@arguments_checked
@dataclass(frozen=True)
class Coulomb(FrictionLaw):
    """Dry friction at a point: a force μN against the slip; at rest at most μN.

    Parameters
    ----------
    mu : float
        Coefficient μ ≥ 0; ``inf`` for a contact that never slips.

    Raises
    ------
    InputError
        If μ is negative or not a number.

    Examples
    --------
    >>> from chaplygin.contact import Coulomb
    >>> Coulomb(0.3).words
    'dry friction, mu = 0.3'
    """

    mu: float
    name = "coulomb"

    def __post_init__(self) -> None:
        if not self.mu >= 0:
            raise InputError(f"mu {self.mu}: it must be a number not below zero, or inf")

    @property
    def words(self) -> str:
        """The law in words."""
        return f"dry friction, mu = {self.mu:g}"

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """μ, where it is finite."""
        if math.isinf(self.mu):
            return ()
        return (_coefficient(mu, "coefficient of sliding friction", self.mu, "1"),)

    def reaction(self, mode: Mode) -> Reaction:
        """The force −μN u/|u| while the contact slides."""
        return Reaction(p=-mu * slip / slip_speed) if mode.sliding else Reaction()

    def guards(self, mode: Mode) -> tuple[Guard, ...]:
        """The slip while there is any; μ²N² − f² while it is held."""
        if mode.sliding:
            return (Guard("stick", norm_squared(slip) - slip_floor**2, "sliding ends"),)
        if math.isinf(self.mu):
            return ()
        return (Guard("slip", mu**2 * N**2 - norm_squared(friction), "sliding begins"),)


@arguments_checked
@dataclass(frozen=True)
class SpinFriction(FrictionLaw):
    """A couple of constant arm against the spin, independent of the slip.

    Parameters
    ----------
    arm : float
        The couple is `arm` times the normal force (m), at most so at rest.

    Raises
    ------
    InputError
        If the arm is negative or not finite.

    Examples
    --------
    >>> from chaplygin.contact import SpinFriction
    >>> SpinFriction(1e-4).words
    'friction against spin, arm 0.0001 m'
    """

    arm: float
    name = "spin"

    def __post_init__(self) -> None:
        _require_coefficient("spin_arm", self.arm)

    @property
    def words(self) -> str:
        """The law in words."""
        return f"friction against spin, arm {self.arm:g} m"

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The arm."""
        return (_coefficient(spin_arm, "arm of the friction couple against spin", self.arm, "m"),)

    def reaction(self, mode: Mode) -> Reaction:
        """The couple −N arm sgn Ω γ while the body spins."""
        return Reaction(q=-spin_arm * spin_sign * gamma) if mode.spinning else Reaction()

    def guards(self, mode: Mode) -> tuple[Guard, ...]:
        """The spin while there is any; what the couple lacks of its limit while it is held."""
        if mode.spinning:
            return (Guard("spin stop", spin_sign * spin, "spinning ends"),)
        margin = spin_arm**2 * N**2 - holding_couple**2
        return (Guard("spin start", margin, "spinning begins"),)


@arguments_checked
@dataclass(frozen=True)
class ContensouErismann(FrictionLaw):
    """Dry friction over a round patch of contact with Hertz' pressure.

    Slip and spin share the friction: the force falls with the spin, the couple with the slip.

    Parameters
    ----------
    mu : float
        Coefficient μ > 0, finite.
    patch : float
        Radius of the patch of contact (m), positive.

    Raises
    ------
    InputError
        If a number is not positive and finite.

    Examples
    --------
    >>> from chaplygin.contact import ContensouErismann
    >>> ContensouErismann(0.3, 5e-4).words
    'dry friction over a patch of radius 0.0005 m, mu = 0.3'
    """

    mu: float
    patch: float
    name = "contensou"

    def __post_init__(self) -> None:
        for key, value in (("mu", self.mu), ("patch", self.patch)):
            if not (math.isfinite(value) and value > 0):
                raise InputError(
                    f"{key} {value}: with a patch of contact it must be a positive finite number"
                )

    @property
    def words(self) -> str:
        """The law in words."""
        return f"dry friction over a patch of radius {self.patch:g} m, mu = {self.mu:g}"

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """μ and the radius of the patch."""
        return (
            _coefficient(mu, "coefficient of sliding friction", self.mu, "1"),
            _coefficient(patch, "radius of the patch of contact", self.patch, "m"),
        )

    def definitions(self, mode: Mode) -> Pairs:
        """The force and the couple for each unit of μN, in the range of the mode."""
        return contensou.shares(patch, mode) if mode.sliding else ()

    def reaction(self, mode: Mode) -> Reaction:
        """The force −μN𝓕 u/|u| and the couple −μNa𝓜 sgn Ω γ."""
        if not mode.sliding:
            return Reaction()
        return Reaction(
            p=-mu * contensou.force_share * slip,
            q=-mu * patch * contensou.couple_share * gamma,
        )

    def guards(self, mode: Mode) -> tuple[Guard, ...]:
        """The motion while there is any, the limit set while it is held, and the range."""
        return contensou.guards(patch, mode, mu)


@arguments_checked
@dataclass(frozen=True)
class Viscous(FrictionLaw):
    """Viscous friction that does not depend on the normal force.

    Parameters
    ----------
    coefficient : float
        The force is −c u (c in kg/s).
    spin : float
        The couple is −c_s Ω γ (c_s in kg m²/s).

    Raises
    ------
    InputError
        If a coefficient is negative or not finite.

    Examples
    --------
    >>> from chaplygin.contact import Viscous
    >>> Viscous(0.5).words
    'viscous friction 0.5 kg/s'
    """

    coefficient: float
    spin: float = 0.0
    name = "viscous"

    def __post_init__(self) -> None:
        _require_coefficient("viscous", self.coefficient)
        _require_coefficient("spin_viscous", self.spin)

    @property
    def words(self) -> str:
        """The law in words."""
        text = f"viscous friction {self.coefficient:g} kg/s"
        return f"{text}, against spin {self.spin:g} kg m^2/s" if self.spin else text

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """Both coefficients."""
        unit = "kg m^2/s"
        return (
            _coefficient(viscous, "coefficient of viscous friction", self.coefficient, "kg/s"),
            _coefficient(spin_viscous, "coefficient of viscous spin friction", self.spin, unit),
        )

    def reaction(self, mode: Mode) -> Reaction:
        """The force −c u and the couple −c_s Ω γ."""
        return Reaction(force=-viscous * slip, couple=-spin_viscous * spin * gamma)


@arguments_checked
@dataclass(frozen=True)
class NormalViscous(FrictionLaw):
    """Viscous friction in proportion to the normal force.

    Parameters
    ----------
    coefficient : float
        The force is −νN u (ν in s/m).

    Raises
    ------
    InputError
        If the coefficient is negative or not finite.

    Examples
    --------
    >>> from chaplygin.contact import NormalViscous
    >>> NormalViscous(0.3).words
    'friction 0.3 s/m times normal force and slip'
    """

    coefficient: float
    name = "slip"

    def __post_init__(self) -> None:
        _require_coefficient("slip", self.coefficient)

    @property
    def words(self) -> str:
        """The law in words."""
        return f"friction {self.coefficient:g} s/m times normal force and slip"

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """ν."""
        meaning = "coefficient of friction in proportion to slip and normal force"
        return (_coefficient(nu, meaning, self.coefficient, "s/m"),)

    def reaction(self, mode: Mode) -> Reaction:
        """The force −νN u."""
        return Reaction(p=-nu * slip)


@arguments_checked
@dataclass(frozen=True)
class RollingResistance(FrictionLaw):
    """A couple of constant arm against rolling.

    Parameters
    ----------
    arm : float
        The couple is −N arm ω_t/|ω_t|, ω_t along the tangent plane (m); at most so at rest.

    Raises
    ------
    InputError
        If the arm is negative or not finite.

    Examples
    --------
    >>> from chaplygin.contact import RollingResistance
    >>> RollingResistance(1e-3).words
    'resistance to rolling, arm 0.001 m'
    """

    arm: float
    name = "rolling"

    def __post_init__(self) -> None:
        _require_coefficient("rolling", self.arm)

    @property
    def words(self) -> str:
        """The law in words."""
        return f"resistance to rolling, arm {self.arm:g} m"

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The arm."""
        return (_coefficient(rolling_arm, "arm of the resistance to rolling", self.arm, "m"),)

    def reaction(self, mode: Mode) -> Reaction:
        """The couple −N arm ω_t/|ω_t| while the body rolls."""
        return Reaction(q=-rolling_arm * rolling / rolling_speed) if mode.rolling else Reaction()

    def guards(self, mode: Mode) -> tuple[Guard, ...]:
        """The angular velocity of rolling while there is any."""
        if not mode.rolling:
            return ()
        margin = norm_squared(rolling) - rolling_floor**2
        return (Guard("rolling stop", margin, "rolling ends"),)


@arguments_checked
@dataclass(frozen=True)
class ViscousRolling(FrictionLaw):
    """A couple against rolling in proportion to its angular velocity and the normal force.

    Parameters
    ----------
    coefficient : float
        The couple is −N c ω_t (c in m s).

    Raises
    ------
    InputError
        If the coefficient is negative or not finite.

    Examples
    --------
    >>> from chaplygin.contact import ViscousRolling
    >>> ViscousRolling(1e-4).words
    'viscous resistance to rolling, 0.0001 m s'
    """

    coefficient: float
    name = "viscous_rolling"

    def __post_init__(self) -> None:
        _require_coefficient("rolling_viscous", self.coefficient)

    @property
    def words(self) -> str:
        """The law in words."""
        return f"viscous resistance to rolling, {self.coefficient:g} m s"

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The coefficient."""
        meaning = "coefficient of viscous resistance to rolling"
        return (_coefficient(rolling_viscous, meaning, self.coefficient, "m s"),)

    def reaction(self, mode: Mode) -> Reaction:
        """The couple −N c ω_t."""
        return Reaction(q=-rolling_viscous * rolling)


@arguments_checked
@dataclass(frozen=True)
class ContourResistance(FrictionLaw):
    """Resistance to the wandering of the contact point over the body.

    On a ball it is resistance to rolling of the arm `arm` R; on a disk it is not.

    Parameters
    ----------
    arm : float
        The power lost is `arm` times N times the speed of the contact point over the body (1).

    Raises
    ------
    InputError
        If the coefficient is negative or not finite.

    Examples
    --------
    >>> from chaplygin.contact import ContourResistance
    >>> ContourResistance(1e-3).words
    'resistance along the contour, 0.001'
    """

    arm: float
    name = "contour"

    def __post_init__(self) -> None:
        _require_coefficient("contour", self.arm)

    @property
    def words(self) -> str:
        """The law in words."""
        return f"resistance along the contour, {self.arm:g}"

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The coefficient."""
        meaning = "coefficient of resistance along the contour"
        return (_coefficient(contour_arm, meaning, self.arm, "1"),)

    def reaction(self, mode: Mode) -> Reaction:
        """The couple −N c γ×(W ε), ε the direction in which the contact point wanders."""
        return Reaction(q=-contour_arm * contour_couple) if mode.rolling else Reaction()

    def guards(self, mode: Mode) -> tuple[Guard, ...]:
        """The speed of the contact point over the body while there is any."""
        if not mode.rolling:
            return ()
        margin = norm_squared(rolling) - rolling_floor**2
        return (Guard("rolling stop", margin, "rolling ends"),)


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
