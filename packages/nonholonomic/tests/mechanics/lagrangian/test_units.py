"""Units of momenta and multipliers, from those of the parameters."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp

from flowlanes import Parameter
from flowlanes.system.laws import Integral
from flowlanes.system.vectors import real_symbol
from nonholonomic import Frame, Mechanism, coordinates, equations_of_motion
from nonholonomic.mechanics.lagrangian.units import momentum_units, multiplier_units

m, J, l, r, phi, x = map(real_symbol, ("m", "J", "l", "r", "phi", "x"))
HALF = sp.Rational(1, 2)
SPIN = "kg m^2/s"


def mechanism(kinetic: sp.Expr, frame: object, **units: str) -> Mechanism:
    parameters = tuple(Parameter(s, str(s), 1.0, units.get(str(s), "")) for s in (m, J, l))
    return Mechanism("trial", frame, kinetic, parameters=parameters)


def units(kinetic: sp.Expr, frame: object, **declared: str) -> list[str]:
    return list(momentum_units(mechanism(kinetic, frame, **declared)).values())


PLANE = coordinates(r, phi)
RDOT, PHIDOT = PLANE.w


@pytest.mark.parametrize(
    ("kinetic", "declared", "expected"),
    [
        (m * RDOT**2 + J * PHIDOT**2, {"m": "kg", "J": "kg m^2"}, ["kg m/s", "kg m^2/s"]),
        (m * RDOT**2 + J * PHIDOT**2, {"m": "kg"}, ["kg m/s", ""]),
        (m * RDOT**2 + J * PHIDOT**2, {}, ["", ""]),
        (m * RDOT**2 + J * PHIDOT**2, {"m": "stone", "J": "N m s^2"}, ["", "kg m^2/s"]),
        # the unit of r follows from that of its rate, and is needed for that of the other
        (m * (RDOT**2 + r**2 * PHIDOT**2), {"m": "kg"}, ["kg m/s", "kg m^2/s"]),
        (
            m * l**2 * (RDOT**2 + sp.cos(r) ** 2 * PHIDOT**2),
            {"m": "kg", "l": "m"},
            ["kg m^2/s"] * 2,
        ),
        # r would be measured in the root of metres
        (m * l * RDOT**2 + J * PHIDOT**2, {"m": "kg", "l": "m", "J": "kg m^2"}, ["", "kg m^2/s"]),
    ],
    ids=str,
)
def test_momenta(kinetic: sp.Expr, declared: dict[str, str], expected: list[str]) -> None:
    assert units(HALF * kinetic, PLANE, **declared) == expected


def test_the_integral_of_a_cyclic_coordinate_has_its_unit() -> None:
    planet = mechanism(HALF * m * (RDOT**2 + r**2 * PHIDOT**2) + J / r, PLANE, m="kg")
    (momentum,) = (
        law
        for law in equations_of_motion(planet).laws
        if isinstance(law, Integral) and law.name == "momentum_phidot"
    )
    assert momentum.unit == "kg m^2/s"


POLAR_ENERGY = HALF * m * (RDOT**2 + r**2 * PHIDOT**2)
UNITS = {"m": "kg", "l": "m"}


@pytest.mark.parametrize(
    ("constraints", "positions", "expected"),
    [
        ((RDOT,), (), ("N",)),
        ((PHIDOT,), (), ("N m",)),
        ((RDOT - l * PHIDOT,), (), ("N",)),
        ((RDOT / l - PHIDOT,), (), ("N m",)),
        # the reaction along s is the multiplier times the derivative by s, also if not linear
        ((RDOT**2 - l**2 * PHIDOT**2,), (), ("kg/s",)),
        ((), (r - l,), ("N",)),
        ((), (phi,), ("N m",)),
        ((PHIDOT,), (r - l,), ("N m", "N")),
        # metres and radians are added
        ((RDOT - PHIDOT,), (), ("",)),
        ((sp.log(2 + r) * RDOT,), (), ("",)),
    ],
    ids=str,
)
def test_multipliers(
    constraints: tuple[sp.Expr, ...], positions: tuple[sp.Expr, ...], expected: tuple[str, ...]
) -> None:
    trial = replace(
        mechanism(POLAR_ENERGY, PLANE, **UNITS), constraints=constraints, positions=positions
    )
    assert multiplier_units(trial) == expected
    bare = replace(mechanism(POLAR_ENERGY, PLANE), constraints=constraints, positions=positions)
    assert multiplier_units(bare) == ("",) * len(expected)


def test_the_reaction_of_a_blade_is_a_force() -> None:
    u, v, omega = map(real_symbol, ("u", "v", "omega"))
    c, s = sp.cos(phi), sp.sin(phi)
    frame = Frame({x: u * c - v * s, r: u * s + v * c, phi: omega}, (u, v, omega))
    energy = HALF * (m * (u**2 + (v + l * omega) ** 2) + J * omega**2)
    sleigh = replace(mechanism(energy, frame, m="kg", J="kg m^2", l="m"), constraints=(v,))
    (reaction,) = (o for o in equations_of_motion(sleigh).observables if o.name == "lambda_1")
    assert reaction.unit == "N"
