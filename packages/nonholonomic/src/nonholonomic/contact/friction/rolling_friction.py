"""Friction laws against rolling: tangential couples."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.system.system import Guard
from flowlanes.system.vectors import Vector, dot, norm_squared, real_symbol

from .friction_law import Coefficient, CoefficientLaw, Reaction
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
    wandering_speed,
)

rolling_arm, rolling_viscous, contour_arm = (
    real_symbol(name) for name in ("delta_r", "c_r", "mu_c")
)


@arguments_checked
@dataclass(frozen=True)
class RollingResistance(CoefficientLaw):
    """A couple against rolling with a constant arm.

    Parameters
    ----------
    arm : float
        Arm (m) of the couple −N arm ω_t/|ω_t|, with the tangential part ω_t of ω; at rest the
        largest value of the couple is N arm.

    Raises
    ------
    InputError
        If the arm is negative or not finite.

    Examples
    --------
    >>> from nonholonomic.contact import RollingResistance
    >>> RollingResistance(1e-3).description
    'resistance to rolling, arm 0.001 m'
    """

    arm: float

    kind = "rolling"
    coefficients = (
        Coefficient("arm", rolling_arm, "arm of the resistance to rolling", "m", "rolling"),
    )
    in_words = "resistance to rolling, arm {arm:g} m"
    summary = (
        "Resistance to rolling: a couple against rolling, the arm times N, which also holds a "
        "body that does not roll."
    )
    acts_while = "rolling"
    formula = Reaction(q=-rolling_arm * rolling / rolling_speed)
    dissipation = ((rolling_arm, N, rolling_speed),)
    excludes = {  # noqa: RUF012  (never changed)
        "contour": "resistance to rolling excludes resistance along the contour"
    }
    resists_slip, resists_rolling = False, True

    @property
    def holds_rolling(self) -> bool:
        """Whether the resistance is not zero."""
        return self.arm > 0

    def couple_along(self, direction: Vector) -> Reaction:
        """The couple −N arm along the direction."""
        return Reaction(q=-rolling_arm * direction)

    def guards(self, mode: Mode) -> tuple[Guard, ...]:
        """The rolling angular velocity while rolling.

        The limit minus the holding couple while held.
        """
        across = norm_squared(couple) - dot(gamma, couple) ** 2
        return _rolling_guards(mode, rolling_arm**2 * N**2 - across)


@arguments_checked
@dataclass(frozen=True)
class ViscousRolling(CoefficientLaw):
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
    >>> ViscousRolling(1e-4).description
    'viscous resistance to rolling, 0.0001 m s'
    """

    coefficient: float

    kind = "viscous_rolling"
    coefficients = (
        Coefficient(
            "coefficient",
            rolling_viscous,
            "coefficient of viscous resistance to rolling",
            "m s",
            "rolling_viscous",
        ),
    )
    in_words = "viscous resistance to rolling, {coefficient:g} m s"
    summary = (
        "Viscous resistance to rolling: a couple in proportion to the angular velocity of "
        "rolling and the normal force."
    )
    formula = Reaction(q=-rolling_viscous * rolling)
    dissipation = ((rolling_viscous, N, rolling_speed**2),)
    resists_slip, resists_rolling = False, True


@arguments_checked
@dataclass(frozen=True)
class ContourResistance(CoefficientLaw):
    """Resistance to the motion of the contact point over the body.

    For a ball this is rolling resistance with the arm c R; for a disk it is not.

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
    >>> ContourResistance(1e-3).description
    'resistance along the contour, 0.001'
    """

    coefficient: float

    kind = "contour"
    coefficients = (
        Coefficient(
            "coefficient",
            contour_arm,
            "coefficient of resistance along the contour",
            "1",
            "contour",
        ),
    )
    in_words = "resistance along the contour, {coefficient:g}"
    summary = (
        "Resistance along the contour: the power lost is the coefficient times N and the "
        "speed of the contact point over the body."
    )
    acts_while = "rolling"
    formula = Reaction(q=-contour_arm * contour_couple)
    dissipation = ((contour_arm, N, wandering_speed),)
    resists_slip, resists_rolling, is_along_contour = False, True, True

    @property
    def holds_rolling(self) -> bool:
        """Whether the resistance is not zero."""
        return self.coefficient > 0

    def couple_along(self, direction: Vector) -> Reaction:
        """The couple of the law, since the rolling determines the motion of the contact point."""
        return self.formula

    def guards(self, mode: Mode) -> tuple[Guard, ...]:
        """The rolling angular velocity while rolling.

        The limit minus the holding couple while held.
        """
        return _rolling_guards(mode, contour_arm**2 * N**2 - norm_squared(contour_hold))


def _rolling_guards(mode: Mode, holds: sp.Expr) -> tuple[Guard, ...]:
    """The rolling angular velocity while rolling, or the margin of the couple while held.

    In planar motion the rolling passes through zero, where its square would have a double zero that
    event location could miss.
    """
    if not mode.rolling:
        return (Guard("rolling start", holds, "rolling begins"),)
    margin = rolling_speed - rolling_floor
    return (Guard("rolling stop", margin, "rolling ends"),)
