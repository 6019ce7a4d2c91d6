"""Drag of the air between a disk and the plane on which it whirls."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.system import Parameter
from flowlanes.system.vectors import real_symbol

from .friction_law import FrictionLaw, Reaction, coefficient, require_coefficient
from .modes import Mode
from .symbols import gamma, rolling

air_viscosity, air_radius = real_symbol("eta_air"), real_symbol("air_radius")

#: Couple (N m s) for each unit of the angular velocity of rolling; sin²α = γ₁² + γ₂².
_TILT = gamma.symbols[0] ** 2 + gamma.symbols[1] ** 2
film = sp.pi / 4 * air_viscosity * air_radius**3 * _TILT ** sp.Rational(-3, 2)


@arguments_checked
@dataclass(frozen=True)
class AirFilm(FrictionLaw):
    """Viscous drag of the air that a disk squeezes as it rolls at a small angle to the plane.

    The couple is −(π/4) η a³ ω_t/sin³α, with the angle α between face and plane.  A disk that
    whirls with its centre at rest, |ω|² = 4g sin α/a, loses the power πηga²/tan²α; at small angles
    that is πηga²/α², as H. K. Moffatt (Nature 404 (2000) 833) estimates for the film under it.

    Parameters
    ----------
    viscosity : float
        η of the air (Pa s), 1.8e-5 in a room.
    radius : float
        a, of the disk (m).

    Raises
    ------
    InputError
        If the viscosity is negative or not finite, or the radius not positive.

    Examples
    --------
    >>> from nonholonomic.contact import AirFilm
    >>> AirFilm(1.8e-5, 0.0375).words
    'film of air under the disk, viscosity 1.8e-05 Pa s'
    """

    viscosity: float
    radius: float
    name = "air"

    def __post_init__(self) -> None:
        require_coefficient("air", self.viscosity)
        if not self.radius > 0:
            raise InputError(f"radius {self.radius}: that of the disk must be positive")

    @property
    def words(self) -> str:
        """The law in words."""
        return f"film of air under the disk, viscosity {self.viscosity:g} Pa s"

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """η and a."""
        return (
            coefficient(air_viscosity, "viscosity of the air", self.viscosity, "Pa s"),
            coefficient(air_radius, "radius of the disk over the film of air", self.radius, "m"),
        )

    def reaction(self, mode: Mode) -> Reaction:
        """The couple −(π/4) η a³ ω_t/sin³α."""
        return Reaction(couple=-film * rolling) if mode.rolling else Reaction()
