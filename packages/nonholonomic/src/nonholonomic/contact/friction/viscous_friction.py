"""Friction laws that grow with the slip from zero, without a threshold."""

from __future__ import annotations

import math
from dataclasses import dataclass

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.system import Guard, Parameter
from flowlanes.system.vectors import norm_squared, real_symbol

from .friction_law import (
    Coefficient,
    CoefficientLaw,
    FrictionLaw,
    Reaction,
    coefficient,
    require_coefficient,
)
from .modes import Mode
from .symbols import N, gamma, slip, slip_floor, slip_speed, spin

nu, power_viscous, viscous, spin_viscous = (
    real_symbol(name) for name in ("nu_s", "nu_p", "c_v", "c_s")
)


#: An alias of the spin, whose name is also that of a field, and the linear reaction.
_SPIN = spin
_VISCOUS = Reaction(force=-viscous * slip, couple=-spin_viscous * spin * gamma)


@arguments_checked
@dataclass(frozen=True)
class Viscous(CoefficientLaw):
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
    >>> Viscous(0.5).description
    'viscous friction 0.5 kg/s'
    """

    coefficient: float
    spin: float = 0.0

    kind = "viscous"
    coefficients = (
        Coefficient("coefficient", viscous, "coefficient of viscous friction", "kg/s", "viscous"),
        Coefficient(
            "spin", spin_viscous, "coefficient of viscous spin friction", "kg m^2/s", "spin_viscous"
        ),
    )
    in_words = "viscous friction {coefficient:g} kg/s"
    summary = (
        "Viscous friction: a force in proportion to the slip and a couple in proportion to "
        "the spin, whatever the normal force. It holds nothing at rest."
    )
    formula = _VISCOUS
    dissipation = ((viscous, slip_speed**2), (spin_viscous, _SPIN**2))

    @property
    def description(self) -> str:
        """A description of the law, with the spin coefficient if it is not zero."""
        text = super().description
        return f"{text}, against spin {self.spin:g} kg m^2/s" if self.spin else text

    @property
    def slip_viscosity(self) -> float:
        """The coefficient."""
        return self.coefficient


@arguments_checked
@dataclass(frozen=True)
class NormalViscous(CoefficientLaw):
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
    >>> NormalViscous(0.3).description
    'friction 0.3 s/m times normal force and slip'
    """

    coefficient: float

    kind = "slip"
    coefficients = (
        Coefficient(
            "coefficient",
            nu,
            "coefficient of friction in proportion to slip and normal force",
            "s/m",
            "slip",
        ),
    )
    in_words = "friction {coefficient:g} s/m times normal force and slip"
    summary = "Friction in proportion to slip and normal force. It holds nothing at rest."
    formula = Reaction(p=-nu * slip)
    dissipation = ((nu, N, slip_speed**2),)
    excludes = {  # noqa: RUF012  (never changed)
        "power": "two laws in proportion to the normal force and a power of slip"
    }

    @property
    def power(self) -> tuple[float, float]:
        """ν and 1."""
        return self.coefficient, 1.0


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
    plane) the slip falls like u̇ = −b u^p. For p < 1 it reaches zero after the finite time
    u₀^{1−p}/((1 − p) b), and the body then rolls; for p ≥ 1 it never does. Unless p is an odd
    integer the force is not smooth at zero slip, and a guard ends the equations before it; the
    simulation continues through it.

    Examples
    --------
    >>> from nonholonomic.contact.friction.viscous_friction import PowerFriction
    >>> PowerFriction(0.3, 0.5).description
    'friction 0.3 (s/m)^0.5 times normal force and slip to the power 0.5'
    """

    coefficient: float
    order: float

    kind = "power"
    summary = (
        "Friction in proportion to the normal force and a power of the slip. It holds nothing "
        "at rest."
    )

    def __post_init__(self) -> None:
        require_coefficient("slip", self.coefficient)
        if not (math.isfinite(self.order) and self.order > 0):
            raise InputError(f"slip_order {self.order}: it must be a positive finite number")

    @property
    def description(self) -> str:
        """A description of the law."""
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
        """The slip, unless the force is smooth where the slip vanishes."""
        if not mode.sliding or self.is_smooth:
            return ()
        return (creep_guard(f"friction of order {self.order:g}"),)


def creep_guard(law: str) -> Guard:
    """The slip, for a thresholdless law that is not smooth at zero slip."""
    margin = slip_speed - slip_floor
    return Guard(
        "creep",
        margin,
        f"the slip is zero, where {law} is not smooth: no motion is followed through it",
    )
