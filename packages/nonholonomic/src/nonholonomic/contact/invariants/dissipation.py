"""The power that each friction law dissipates on a support at rest: it is never negative.

A body under a force R and a couple K at its contact changes its energy at the rate
(R, u) + (K, ω), as :func:`~nonholonomic.contact.invariants.free_contact.power` states.  The normal
force is perpendicular to the slip u, and for each law the remaining power is minus a sum of
products of nonnegative factors: coefficients, the normal force, speeds, squares, and the shares 𝓕
and 𝓜 of the coupled law.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.laws import Identity
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import Symmetric, cross, dot, norm_squared, zero

from ..friction.air_film import TILT
from ..friction.contensou import couple_share, force_share
from ..friction.friction_law import FrictionLaw
from ..friction.modes import Mode
from ..friction.symbols import (
    F_share,
    M_share,
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
    spin_speed,
    wandering,
    wandering_speed,
)

_SPREAD = Symmetric("W")

#: Nonnegative quantities other than coefficients: N while the contact lasts, speeds as square
#: roots, |Ω|, 𝓕 and 𝓜 by the bounds of the law.
NOT_NEGATIVE = frozenset(
    {N, slip_speed, rolling_speed, wandering_speed, spin_speed, F_share, M_share}
)


@dataclass(frozen=True)
class Dissipation:
    """A power as a sum of products of nonnegative factors (W).

    Attributes
    ----------
    products : tuple of tuples of sympy.Expr
    """

    products: tuple[tuple[sp.Expr, ...], ...]

    @property
    def power(self) -> sp.Expr:
        """The sum of the products."""
        return sp.Add(*(sp.Mul(*factors) for factors in self.products))


def dissipation(law: FrictionLaw) -> Dissipation:
    """The power that a law dissipates for a body that slides, spins and rolls on a support at rest.

    Parameters
    ----------
    law : FrictionLaw

    Returns
    -------
    Dissipation

    Raises
    ------
    InputError
        If the dissipation of the law is not known.

    Examples
    --------
    >>> from nonholonomic.contact import Coulomb
    >>> from nonholonomic.contact.invariants.dissipation import dissipation
    >>> dissipation(Coulomb(0.3)).power
    N*mu*slip_speed
    """
    if not law.dissipation:
        raise InputError(f"law {law.name!r}: the power that it takes is not known")
    for factor in {factor for factors in law.dissipation for factor in factors}:
        if not is_not_negative(factor, law):
            raise InputError(f"law {law.name!r}: the factor {factor} may be negative")
    return Dissipation(law.dissipation)


def is_not_negative(factor: sp.Expr, law: FrictionLaw) -> bool:
    """Whether the conditions on the coefficients of a law show that a factor is not negative."""
    known = set(NOT_NEGATIVE)
    known |= {p.symbol for p in law.parameters if (p.symbol >= 0) in p.admissible}
    names = {s: sp.Dummy(nonnegative=True) for s in known}
    # a sum of squares in a denominator is positive where the formula has a value
    tilt = {TILT: sp.Dummy(positive=True)}
    return bool(factor.xreplace(tilt).xreplace(names).is_nonnegative)


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
    """A contact with arbitrary constant slip, angular velocity and normal force."""
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
