"""Laws of friction that grow with the slip from zero on, without a threshold."""

from __future__ import annotations

import math
from dataclasses import dataclass

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.system import Guard, Parameter
from flowlanes.system.vectors import norm_squared, real_symbol

from .friction_law import FrictionLaw, Reaction, coefficient, require_coefficient
from .modes import Mode
from .symbols import gamma, slip, slip_floor, slip_speed, spin

nu, power_viscous, viscous, spin_viscous = (
    real_symbol(name) for name in ("nu_s", "nu_p", "c_v", "c_s")
)


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
    >>> from nonholonomic.contact import Viscous
    >>> Viscous(0.5).words
    'viscous friction 0.5 kg/s'
    """

    coefficient: float
    spin: float = 0.0
    name = "viscous"

    def __post_init__(self) -> None:
        require_coefficient("viscous", self.coefficient)
        require_coefficient("spin_viscous", self.spin)

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
            coefficient(viscous, "coefficient of viscous friction", self.coefficient, "kg/s"),
            coefficient(spin_viscous, "coefficient of viscous spin friction", self.spin, unit),
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
    >>> from nonholonomic.contact import NormalViscous
    >>> NormalViscous(0.3).words
    'friction 0.3 s/m times normal force and slip'
    """

    coefficient: float
    name = "slip"

    def __post_init__(self) -> None:
        require_coefficient("slip", self.coefficient)

    @property
    def words(self) -> str:
        """The law in words."""
        return f"friction {self.coefficient:g} s/m times normal force and slip"

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """ν."""
        meaning = "coefficient of friction in proportion to slip and normal force"
        return (coefficient(nu, meaning, self.coefficient, "s/m"),)

    @property
    def power(self) -> tuple[float, float]:
        """ν and 1."""
        return self.coefficient, 1.0

    def reaction(self, mode: Mode) -> Reaction:
        """The force −νN u."""
        return Reaction(p=-nu * slip)


@arguments_checked
@dataclass(frozen=True)
class PowerFriction(FrictionLaw):
    """Friction in proportion to the normal force and to a power of the slip speed.

    Order 1 is `NormalViscous`; as the order tends to 0 the law tends to Coulomb's.

    Parameters
    ----------
    coefficient : float
        The force is −νN |u|^p u/|u| (ν in (s/m)^p).
    order : float
        p, positive and finite.

    Raises
    ------
    InputError
        If the coefficient is negative or not finite, or the order not positive and finite.

    Notes
    -----
    The law has no threshold: a contact that needs a force f* to be held creeps with the speed
    (|f*|/νN)^{1/p} against it.  Where rolling needs no force (a ball with centred mass on a level
    plane) the slip falls like u̇ = −b u^p.  Below order 1 it is zero after the finite time
    u₀^{1−p}/((1 − p) b), and the body then rolls; above it never is.  Unless p is an odd whole
    number the force is not smooth at zero slip, and a guard ends the equations before that; the
    course of a motion passes it.

    Examples
    --------
    >>> from nonholonomic.contact.friction.viscous_friction import PowerFriction
    >>> PowerFriction(0.3, 0.5).words
    'friction 0.3 (s/m)^0.5 times normal force and slip to the power 0.5'
    """

    coefficient: float
    order: float
    name = "power"

    def __post_init__(self) -> None:
        require_coefficient("slip", self.coefficient)
        if not (math.isfinite(self.order) and self.order > 0):
            raise InputError(f"slip_order {self.order}: it must be a positive finite number")

    @property
    def words(self) -> str:
        """The law in words."""
        power = f"{self.order:g}"
        return (
            f"friction {self.coefficient:g} (s/m)^{power} times normal force and slip to the "
            f"power {power}"
        )

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """ν."""
        meaning = "coefficient of friction in proportion to normal force and a power of slip"
        unit = f"(s/m)^{self.order:g}"
        return (coefficient(power_viscous, meaning, self.coefficient, unit),)

    @property
    def power(self) -> tuple[float, float]:
        """ν and p."""
        return self.coefficient, self.order

    @property
    def is_smooth(self) -> bool:
        """Whether the force is smooth at zero slip: p is 1, 3, 5, …."""
        return self.order % 2 == 1

    def reaction(self, mode: Mode) -> Reaction:
        """The force −νN |u|^{p−1} u."""
        if not mode.sliding:
            return Reaction()
        if self.is_smooth:
            return Reaction(p=-power_viscous * norm_squared(slip) ** (int(self.order) // 2) * slip)
        return Reaction(p=-power_viscous * slip_speed ** sp.Float(self.order - 1) * slip)

    def guards(self, mode: Mode) -> tuple[Guard, ...]:
        """The slip, while there is any, unless the force is smooth where it vanishes."""
        if not mode.sliding or self.is_smooth:
            return ()
        return (creep_guard(f"friction of order {self.order:g}"),)


def creep_guard(law: str) -> Guard:
    """The slip, for a law without threshold that is not smooth where the slip vanishes."""
    margin = slip_speed - slip_floor
    return Guard(
        "creep",
        margin,
        f"the slip is zero, where {law} is not smooth: no motion is followed through it",
    )
