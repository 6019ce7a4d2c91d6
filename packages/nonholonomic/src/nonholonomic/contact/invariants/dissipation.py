"""The power that each law of friction takes from a body on a support at rest: never negative.

A body under a force R and a couple K at its contact changes its energy at the rate
(R, u) + (K, ω), as :func:`~nonholonomic.contact.invariants.free_contact.power` states.  The normal
force is perpendicular to the slip u, and for each law the rest is minus a sum of products of
factors that are not negative: coefficients, the normal force, speeds, squares, and the shares 𝓕
and 𝓜 of the coupled law.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.laws import Identity
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import Symmetric, Vector, cross, dot, norm_squared, real_symbol, zero

from ..friction.air_film import AirFilm, film
from ..friction.contensou import couple_share, force_share
from ..friction.dry_friction import (
    ContensouErismann,
    Coulomb,
    SpinFriction,
    mu,
    patch,
    spin_couple_arm,
)
from ..friction.friction_law import FrictionLaw
from ..friction.modes import Mode
from ..friction.rolling_friction import (
    ContourResistance,
    RollingResistance,
    ViscousRolling,
    contour_arm,
    rolling_arm,
    rolling_viscous,
)
from ..friction.symbols import (
    N,
    contour_couple,
    gamma,
    omega,
    rolling,
    rolling_speed,
    slip,
    slip_speed,
    spin,
    spin_sign,
)
from ..friction.viscous_friction import NormalViscous, Viscous, nu, spin_viscous, viscous

wandering, wandering_speed = Vector("wandering"), real_symbol("wandering_speed")
spin_speed = real_symbol("spin_speed")
#: 𝓕 and 𝓜 of the coupled law, from 0 to 1 and from 0 to 3π/16.
F_share, M_share = real_symbol("F_share"), real_symbol("M_share")
_SPREAD = Symmetric("W")


@dataclass(frozen=True)
class Dissipation:
    """A power as a sum of products of factors that are not negative (W).

    Attributes
    ----------
    products : tuple of tuples of sympy.Expr
    """

    products: tuple[tuple[sp.Expr, ...], ...]

    @property
    def power(self) -> sp.Expr:
        """The sum of the products."""
        return sp.Add(*(sp.Mul(*factors) for factors in self.products))


#: Factors that are not negative: coefficients by what is admissible, N while the contact lasts,
#: speeds as square roots, |Ω|, 𝓕 and 𝓜 by the bounds of the law.
NOT_NEGATIVE: frozenset[sp.Expr] = frozenset(
    {
        mu, nu, patch, viscous, spin_viscous, spin_couple_arm, rolling_arm, rolling_viscous,
        contour_arm, film, N, slip_speed, rolling_speed, wandering_speed, spin_speed, F_share,
        M_share, slip_speed**2, spin**2, rolling_speed**2,
    }
)  # fmt: skip


def dissipation(law: FrictionLaw) -> Dissipation:
    """The power that a law takes from a body that slides, spins and rolls on a support at rest.

    Parameters
    ----------
    law : FrictionLaw

    Returns
    -------
    Dissipation

    Raises
    ------
    InputError
        If the law is none of the package's.

    Examples
    --------
    >>> from nonholonomic.contact import Coulomb
    >>> from nonholonomic.contact.invariants.dissipation import dissipation
    >>> dissipation(Coulomb(0.3)).power
    N*mu*slip_speed
    """
    match law:
        case Coulomb():
            products: tuple[tuple[sp.Expr, ...], ...] = ((mu, N, slip_speed),)
        case SpinFriction():
            products = ((spin_couple_arm, N, spin_speed),)
        case ContensouErismann():
            products = ((mu, N, F_share, slip_speed), (mu, N, patch, M_share, spin_speed))
        case Viscous():
            products = ((viscous, slip_speed**2), (spin_viscous, spin**2))
        case NormalViscous():
            products = ((nu, N, slip_speed**2),)
        case RollingResistance():
            products = ((rolling_arm, N, rolling_speed),)
        case ViscousRolling():
            products = ((rolling_viscous, N, rolling_speed**2),)
        case ContourResistance():
            products = ((contour_arm, N, wandering_speed),)
        case AirFilm():
            products = ((film, rolling_speed**2),)
        case _:
            raise InputError(f"law {law.name!r}: the power that it takes is not known")
    return Dissipation(products)


@arguments_checked
def decrease_of_energy(law: FrictionLaw) -> tuple[System, Identity]:
    """The identity between the power of a law's force and couple and its `dissipation`.

    Parameters
    ----------
    law : FrictionLaw

    Returns
    -------
    system : System
        A contact at one moment: any slip in the tangent plane, any ω, any N.
    identity : Identity
        −(R, u) − (K, ω) less the dissipation.

    Raises
    ------
    InputError
        As :func:`dissipation`.

    Examples
    --------
    >>> import lawproof
    >>> from nonholonomic.contact import RollingResistance
    >>> from nonholonomic.contact.invariants.dissipation import decrease_of_energy
    >>> lawproof.prove(*decrease_of_energy(RollingResistance(1e-3))).decision
    'proven'
    """
    reaction = law.reaction(Mode(range="inner"))
    force = N * reaction.p + reaction.force
    couple = N * reaction.q + reaction.couple
    taken = -dot(force, slip) - dot(couple, omega)
    identity = Identity(
        f"{law.name}_power",
        taken - dissipation(law).power,
        "power taken by the law, as a sum of products of factors that are not negative",
        source="§11.1",
    )
    return contact_at_a_moment(law), identity


def contact_at_a_moment(law: FrictionLaw) -> System:
    """Any slip, angular velocity and normal force at a contact, which stay as they are."""
    names = (N, F_share, M_share, spin_sign)
    numbers = {s: (str(s), 0.4 + 0.3 * i, "1") for i, s in enumerate(names)}
    numbers[spin_sign] = ("sign of the spin", 1.0, "1")
    numbers |= {
        s: ("curvature of the body", 1.0 + i / 4, "m") for i, s in enumerate(_SPREAD.symbols)
    }
    parameters = tuple(Parameter(s, *words) for s, words in numbers.items())
    return System(
        name="contact-at-a-moment",
        title="Slip, spin and normal force at a contact",
        field={slip: zero, omega: zero, gamma: zero},
        definitions={
            slip_speed: sp.sqrt(norm_squared(slip)),
            spin: dot(gamma, omega),
            spin_speed: spin_sign * spin,
            rolling: omega - spin * gamma,
            rolling_speed: sp.sqrt(norm_squared(rolling)),
            wandering: -1 * (_SPREAD * cross(gamma, rolling)),
            wandering_speed: sp.sqrt(norm_squared(wandering)),
            contour_couple: cross(gamma, _SPREAD * wandering) / wandering_speed,
            force_share: F_share / slip_speed,
            couple_share: spin_sign * M_share,
        },
        parameters=(*parameters, *law.parameters),
        relations=(norm_squared(gamma) - 1, dot(slip, gamma)),
        source="§11.1",
    )
