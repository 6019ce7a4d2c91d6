"""A balanced ball on a sphere, marble contact (§8): outside, inside, and around it."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.laws import Integral, Law, Measure
from flowlanes.system.system import System
from flowlanes.system.vectors import (
    Diagonal,
    constant,
    dot,
    norm_squared,
    real_symbol,
    vectors,
    zero,
)

from ...mechanics.rolling.body import Body
from ...mechanics.rolling.equations import RollingBody
from ...mechanics.shapes.shapes import Ball
from ...mechanics.shapes.surfaces import Sphere
from ..catalogue_entry import Numbers, entry_with, laws_for
from .ball_on_sphere_equations import equations_on_sphere

M, gamma, k_rotors = vectors("M gamma k")
I, A = Diagonal("I"), Diagonal("A")
k, m, R = real_symbol("k"), real_symbol("m"), real_symbol("R")


def build(p: Numbers) -> RollingBody:
    """A ball of radius R on a sphere of signed radius a: k = a/(a + R)."""
    body = Body(p["m"], (p["I_1"], p["I_2"], p["I_3"]), Ball(p["R"]))
    return RollingBody(body, Sphere.of_signed_radius(p["a"]))


def radius_ratio(rolling: RollingBody) -> float | None:
    """Ratio k = a/(a + R) of a free balanced ball on a sphere; None for anything else."""
    body, surface, field = rolling.body, rolling.surface, rolling.field
    ball, a = body.shape.signed_radius, surface.signed_radius
    if ball is None or a is None:
        return None
    if any(body.shape.centre) or field.gravity or field.potential != 0:
        return None
    return a / (a + ball)


@laws_for("marble", Sphere, Ball)
def laws(rolling: RollingBody, system: System) -> tuple[Law, ...]:
    """M² and an invariant measure for every k, and a linear integral for k = −1."""
    value = radius_ratio(rolling)
    if value is None:
        return ()
    rotors = any(rolling.body.gyrostat)
    total = M + k_rotors if rotors else M + zero
    known: list[Law] = [
        Integral(
            "momentum",
            norm_squared(total),
            "square of the momentum",
            source="(8.2)",
            unit="kg^2 m^4/s^2",
        ),
        Measure(
            "measure",
            {1 - m * R**2 * dot(gamma, A * gamma): -sp.S.Half},
            "invariant measure in M, γ",
            source="§8.1, after (8.2)",
        ),
    ]
    # k is a quotient of two numbers, and −1 only up to rounding
    if abs(value + 1) < 1e-12 and rolling.body.principal and not rotors:
        known.append(
            replace(
                _linear(m * R**2),
                as_printed=_linear(sp.S.Zero),
                misprint="A is made of I instead of J = I + mR²",
            )
        )
    return tuple(known)


def _linear(shift: sp.Expr) -> Integral:
    """(AM, γ) with A_i = ½(ΣI + shift) − I_i."""
    half = (sp.Add(*I.symbols) + shift) / 2
    tensor = constant(sp.diag(*(half - moment for moment in I.symbols)))
    return Integral(
        "linear",
        dot(tensor * M, gamma),
        "linear integral of the case k = −1",
        level=(k + 1,),
        source="(8.3)",
        unit="kg^2 m^4/s",
    )


ENTRIES = (
    entry_with(
        name="ball-on-sphere",
        build=build,
        laws=laws,
        general=equations_on_sphere,
    ),
)
