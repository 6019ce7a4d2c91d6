"""A balanced ball on a sphere, rubber contact (§9)."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Integral, Law, Measure
from flowlanes.system.system import System
from flowlanes.system.vectors import Diagonal, Symmetric, dot, norm_squared, real_symbol, vectors

from ...mechanics.rolling.body import Body
from ...mechanics.rolling.equations import Forces, RollingBody
from ...mechanics.shapes.shapes import Ball
from ...mechanics.shapes.surfaces import Sphere
from ..catalogue_entry import Numbers, entry_with, laws_for
from . import ball_on_sphere, rubber_ball_ratio

omega, gamma = vectors("omega gamma")
J, A = Diagonal("J"), Diagonal("A")
k = real_symbol("k")


def build(p: Numbers) -> RollingBody:
    """The ball of §8, kept from spinning."""
    return replace(ball_on_sphere.build(p), contact="rubber")


#: (γ, J⁻¹γ), the square of ρ in (9.9).
RHO_SQUARED = dot(gamma, A * gamma)


@laws_for("rubber", Sphere, Ball)
def measure(rolling: RollingBody, system: System) -> tuple[Measure, ...]:
    """(9.3), with rotors, under gravity and in every potential."""
    if any(rolling.body.shape.centre):
        return ()
    # the tensor of a body that is not given in its principal axes has six components
    tensor = A if rolling.body.principal else Symmetric("A")
    density = {dot(gamma, tensor * gamma): 1 / (2 * k)}
    return (Measure("measure", density, "invariant measure", source="(9.3)"),)


def as_family() -> Isomorphism:
    """(9.2): the ball of a free motion depends on its radii and masses through J and k alone."""
    return Isomorphism(
        "ratio",
        rubber_ball_ratio.rolling(),
        {omega: omega, rubber_ball_ratio.n: gamma},
        constants={**dict(zip(J.symbols, J.symbols, strict=True)), k: k},
        meaning="the family in J and k",
        source="(9.2)",
    )


@laws_for("rubber", Sphere, Ball)
def laws(rolling: RollingBody, system: System) -> tuple[Law, ...]:
    """The measure (9.3); for a free ball the family (9.2), and (9.4) for k = −1."""
    known: tuple[Law, ...] = measure(rolling, system)
    value = ball_on_sphere.radius_ratio(rolling)
    body = rolling.body
    if value is None or any(body.gyrostat) or not body.principal:
        return known
    known = (*known, as_family())
    # k is a quotient of two numbers, and −1 only up to rounding
    if abs(value + 1) > 1e-12:
        return known
    J_1, J_2, J_3 = J.symbols
    spread = J_1 * J_2 * J_3 * dot(omega, J * omega) * norm_squared(A * gamma)
    integral = (norm_squared(J * omega) + spread) / RHO_SQUARED
    meaning = "quadratic integral of the case k = −1"
    return (
        *known,
        Integral(
            "quadratic", integral, meaning, level=(k + 1,), source="(9.4)", unit="kg^2 m^4/s^2"
        ),
    )


def general_system() -> System:
    """The ball on the outside, with rotors, in an arbitrary potential U(γ)."""
    potential = sp.Function("U")(*gamma.symbols)
    body = Body(1.0, (1.0, 1.5, 2.1), Ball(1.0), gyrostat=(0.3, -0.2, 0.5))
    rolling = RollingBody(body, Sphere(2.0), "rubber", Forces(0.0, potential))
    system = rolling.system("rubber-ball-on-sphere", "Rubber ball on a sphere")
    return system.with_laws(*measure(rolling, system))


ENTRIES = (
    entry_with(
        name="rubber-ball-on-sphere",
        build=build,
        laws=laws,
        general=general_system,
    ),
)
