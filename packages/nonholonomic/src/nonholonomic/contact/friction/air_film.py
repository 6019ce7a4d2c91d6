"""Drag of the air between a disk and the plane on which it whirls."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.vectors import real_symbol

from .friction_law import Coefficient, CoefficientLaw, Reaction
from .symbols import gamma, rolling, rolling_speed

air_viscosity, air_radius = real_symbol("eta_air"), real_symbol("air_radius")

#: Couple (N m s) per unit of rolling angular velocity; sin²α = γ₁² + γ₂².
TILT = gamma.symbols[0] ** 2 + gamma.symbols[1] ** 2
film = sp.pi / 4 * air_viscosity * air_radius**3 * TILT ** sp.Rational(-3, 2)


@arguments_checked
@dataclass(frozen=True)
class AirFilm(CoefficientLaw):
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
    >>> AirFilm(1.8e-5, 0.0375).description
    'film of air under the disk, viscosity 1.8e-05 Pa s'
    """

    viscosity: float
    radius: float

    kind = "air"
    coefficients = (
        Coefficient("viscosity", air_viscosity, "viscosity of the air", "Pa s", "air"),
        Coefficient("radius", air_radius, "radius of the disk over the film of air", "m"),
    )
    in_words = "film of air under the disk, viscosity {viscosity:g} Pa s"
    summary = (
        "Drag of the film of air under the disk: a couple against rolling in proportion to "
        "its angular velocity, whatever the normal force. It holds nothing at rest."
    )
    acts_while = "rolling"
    formula = Reaction(couple=-film * rolling)
    dissipation = ((film, rolling_speed**2),)
    resists_slip = False

    def __post_init__(self) -> None:
        if not self.radius > 0:
            raise InputError(f"radius {self.radius}: that of the disk must be positive")
        super().__post_init__()
