"""Power of the laws of friction: exact identities, and factors that are not negative."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import pytest
import sympy as sp

import lawproof
from flowlanes.errors import InputError
from flowlanes.system.system import Parameter
from nonholonomic.contact import (
    AirFilm,
    ContensouErismann,
    ContourResistance,
    Coulomb,
    FrictionLaw,
    NormalViscous,
    RollingResistance,
    SpinFriction,
    Viscous,
    ViscousRolling,
)
from nonholonomic.contact.friction.dry_friction import mu
from nonholonomic.contact.friction.friction_law import Reaction
from nonholonomic.contact.friction.modes import Mode
from nonholonomic.contact.friction.symbols import slip, slip_speed
from nonholonomic.contact.invariants.dissipation import (
    decrease_of_energy,
    dissipation,
    is_not_negative,
)
from nonholonomic.contact.pressure.pressure_ranges import hertz_ranges, k

LAWS = (
    Coulomb(0.3),
    SpinFriction(0.01),
    ContensouErismann(0.3, 0.01),
    Viscous(0.3, 0.2),
    NormalViscous(0.3),
    RollingResistance(0.01),
    ViscousRolling(0.01),
    ContourResistance(0.01),
    AirFilm(1.8e-5, 0.04),
)
EACH = pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)


@EACH
def test_a_law_takes_power(law: FrictionLaw) -> None:
    assert lawproof.prove(*decrease_of_energy(law)).decision == "proven"
    factors = {factor for product in dissipation(law).products for factor in product}
    assert all(is_not_negative(factor, law) for factor in factors)


@EACH
def test_another_power_is_refuted(law: FrictionLaw) -> None:
    system, identity = decrease_of_energy(law)
    doubled = replace(identity, value=identity.value - dissipation(law).power)
    assert lawproof.prove(system, doubled).decision == "refuted"


@dataclass(frozen=True)
class Driving(Coulomb):
    """Dry friction that drives, by mistake."""

    def reaction(self, mode: Mode) -> Reaction:
        return Reaction(p=mu * slip / slip_speed)


@dataclass(frozen=True)
class Boasting(Coulomb):
    """Dry friction that takes a product of which one factor may be negative."""

    dissipation = ((mu, sum(slip.symbols)),)


def test_a_factor_that_may_be_negative_is_refused() -> None:
    with pytest.raises(InputError, match=r"law 'coulomb': the factor .* may be negative"):
        dissipation(Boasting(0.3))


def test_a_force_along_the_slip_is_refuted() -> None:
    assert lawproof.prove(*decrease_of_energy(Driving(0.3))).decision == "refuted"


def test_the_power_of_a_foreign_law_is_not_known() -> None:
    class Foreign(FrictionLaw):
        name = "foreign"
        description = "a law of another package"
        parameters: tuple[Parameter, ...] = ()

        def reaction(self, mode: Mode) -> Reaction:
            return Reaction()

    with pytest.raises(InputError, match="law 'foreign': the power that it takes is not known"):
        dissipation(Foreign())


def test_the_shares_of_the_coupled_law_stay_in_their_ranges() -> None:
    factors = hertz_ranges()[1].factors()
    force, couple = sp.lambdify(k, factors, "numpy")(np.linspace(1.0, 20.0, 400))
    assert np.all((9 * np.pi / 32 - 1e-12 <= force) & (force <= 1))
    assert np.all((couple > 0) & (couple <= 3 * np.pi / 16 * 3 / 8 + 1e-12))
