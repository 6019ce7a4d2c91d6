"""Laws of friction that grow with the slip from zero on, without a threshold."""

from __future__ import annotations

from dataclasses import dataclass

from ..arguments import arguments_checked
from ..core.system import Parameter
from ..core.vectors import real_symbol
from .friction_law import FrictionLaw, Reaction, coefficient, require_coefficient
from .modes import Mode
from .symbols import gamma, slip, spin

nu, viscous, spin_viscous = (real_symbol(name) for name in ("nu_s", "c_v", "c_s"))


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
    >>> from chaplygin.contact import NormalViscous
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

    def reaction(self, mode: Mode) -> Reaction:
        """The force −νN u."""
        return Reaction(p=-nu * slip)
