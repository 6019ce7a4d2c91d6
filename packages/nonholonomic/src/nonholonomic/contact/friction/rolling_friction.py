"""Laws of friction against rolling: couples along the tangent plane."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.system.system import Guard, Parameter
from flowlanes.system.vectors import dot, norm_squared, real_symbol

from .friction_law import FrictionLaw, Reaction, coefficient, require_coefficient
from .modes import Mode
from .symbols import (
    N,
    contour_couple,
    contour_hold,
    couple,
    gamma,
    rolling,
    rolling_floor,
    rolling_speed,
)

rolling_arm, rolling_viscous, contour_arm = (
    real_symbol(name) for name in ("delta_r", "c_r", "mu_c")
)


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
    >>> from nonholonomic.contact import RollingResistance
    >>> RollingResistance(1e-3).words
    'resistance to rolling, arm 0.001 m'
    """

    arm: float
    name = "rolling"

    def __post_init__(self) -> None:
        require_coefficient("rolling", self.arm)

    @property
    def words(self) -> str:
        """The law in words."""
        return f"resistance to rolling, arm {self.arm:g} m"

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The arm."""
        return (coefficient(rolling_arm, "arm of the resistance to rolling", self.arm, "m"),)

    @property
    def holds_rolling(self) -> bool:
        """Whether there is any resistance."""
        return self.arm > 0

    def reaction(self, mode: Mode) -> Reaction:
        """The couple −N arm ω_t/|ω_t| while the body rolls."""
        return Reaction(q=-rolling_arm * rolling / rolling_speed) if mode.rolling else Reaction()

    def guards(self, mode: Mode) -> tuple[Guard, ...]:
        """The angular velocity of rolling while there is any; what holds it, less its limit."""
        across = norm_squared(couple) - dot(gamma, couple) ** 2
        return _rolling_guards(mode, rolling_arm**2 * N**2 - across)


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
    >>> from nonholonomic.contact import ViscousRolling
    >>> ViscousRolling(1e-4).words
    'viscous resistance to rolling, 0.0001 m s'
    """

    coefficient: float
    name = "viscous_rolling"

    def __post_init__(self) -> None:
        require_coefficient("rolling_viscous", self.coefficient)

    @property
    def words(self) -> str:
        """The law in words."""
        return f"viscous resistance to rolling, {self.coefficient:g} m s"

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The coefficient."""
        meaning = "coefficient of viscous resistance to rolling"
        return (coefficient(rolling_viscous, meaning, self.coefficient, "m s"),)

    def reaction(self, mode: Mode) -> Reaction:
        """The couple −N c ω_t."""
        return Reaction(q=-rolling_viscous * rolling)


@arguments_checked
@dataclass(frozen=True)
class ContourResistance(FrictionLaw):
    """Resistance to the wandering of the contact point over the body.

    On a ball it is resistance to rolling of the arm c R; on a disk it is not.

    Parameters
    ----------
    coefficient : float
        The power lost is c times N times the speed of the contact point over the body (1).

    Raises
    ------
    InputError
        If the coefficient is negative or not finite.

    Examples
    --------
    >>> from nonholonomic.contact import ContourResistance
    >>> ContourResistance(1e-3).words
    'resistance along the contour, 0.001'
    """

    coefficient: float
    name = "contour"

    def __post_init__(self) -> None:
        require_coefficient("contour", self.coefficient)

    @property
    def words(self) -> str:
        """The law in words."""
        return f"resistance along the contour, {self.coefficient:g}"

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The coefficient."""
        meaning = "coefficient of resistance along the contour"
        return (coefficient(contour_arm, meaning, self.coefficient, "1"),)

    @property
    def holds_rolling(self) -> bool:
        """Whether there is any resistance."""
        return self.coefficient > 0

    def reaction(self, mode: Mode) -> Reaction:
        """The couple −N c γ×(W ε), ε the direction in which the contact point wanders."""
        return Reaction(q=-contour_arm * contour_couple) if mode.rolling else Reaction()

    def guards(self, mode: Mode) -> tuple[Guard, ...]:
        """The angular velocity of rolling while there is any; what holds it, less its limit."""
        return _rolling_guards(mode, contour_arm**2 * N**2 - norm_squared(contour_hold))


def _rolling_guards(mode: Mode, holds: sp.Expr) -> tuple[Guard, ...]:
    """The angular velocity of rolling, while there is any, or what stays positive as it is held.

    Its square would touch zero too closely for an event: in the plane rolling passes through zero.
    """
    if not mode.rolling:
        return (Guard("rolling start", holds, "rolling begins"),)
    margin = rolling_speed - rolling_floor
    return (Guard("rolling stop", margin, "rolling ends"),)
