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
from ...mechanics.rolling.equations import Rolling
from ...mechanics.shapes.shapes import Ball
from ...mechanics.shapes.surfaces import Sphere
from ..catalogue_entry import Entry, Numbers, Start, laws_for
from .ball_around_sphere_coordinates import coordinates_around_sphere
from .ball_on_sphere_equations import equations_on_sphere

M, gamma, k_rotors = vectors("M gamma k")
I, A = Diagonal("I"), Diagonal("A")
k, m, R = real_symbol("k"), real_symbol("m"), real_symbol("R")


def build(p: Numbers) -> Rolling:
    """A ball of radius R on a sphere of signed radius a: k = a/(a + R)."""
    body = Body(p["m"], (p["I_1"], p["I_2"], p["I_3"]), Ball(p["R"]))
    return Rolling(body, Sphere.of_signed_radius(p["a"]))


def build_around(p: Numbers) -> Rolling:
    """A hollow ball whose inner surface, of radius R, rolls around the sphere: k = a/(a − R)."""
    body = Body(p["m"], (p["I_1"], p["I_2"], p["I_3"]), Ball(p["R"], hollow=True))
    return Rolling(body, Sphere.of_signed_radius(p["a"]))


def ratio(rolling: Rolling) -> float | None:
    """k of a free balanced ball on a sphere; None for anything else."""
    body, surface, field = rolling.body, rolling.surface, rolling.field
    if not isinstance(body.shape, Ball) or not isinstance(surface, Sphere):
        return None
    if any(body.shape.centre) or field.gravity or field.potential != 0:
        return None
    signed = -body.shape.radius if body.shape.hollow else body.shape.radius
    return surface.signed_radius / (surface.signed_radius + signed)


@laws_for("marble", Sphere, Ball)
def laws(rolling: Rolling, system: System) -> tuple[Law, ...]:
    """M² and an invariant measure for every k, and a linear integral for k = −1."""
    value = ratio(rolling)
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
        on=(k + 1,),
        source="(8.3)",
        unit="kg^2 m^4/s",
    )


_INERTIA = {"m": 1.0, "I_1": 1.0, "I_2": 1.5, "I_3": 2.1}

ENTRIES = (
    Entry(
        name="ball-on-sphere",
        title="Ball on a sphere",
        summary="A balanced, dynamically asymmetric ball of radius R rolls without slipping on a "
        "fixed sphere of radius a, outside (a > 0) or inside (a < 0, |a| > R); k = a/(a + R).",
        source="§8.1, (8.1), (8.2)",
        defaults={**_INERTIA, "R": 1.0, "a": 2.0},
        build=build,
        start=Start(omega=(0.7, 0.4, 1.1), gamma=(0.2, -0.3, 0.93), until=60.0),
        laws=laws,
        general=equations_on_sphere,
    ),
    Entry(
        name="ball-around-sphere",
        title="Hollow ball around a sphere",
        summary="A hollow ball, dynamically asymmetric and balanced, rolls without slipping with "
        "its inner surface of radius R around a fixed sphere of radius a < R; k = a/(a − R) is "
        "negative, and k = −1 for R = 2a.",
        source="§8.1, (8.1)–(8.3)",
        defaults={**_INERTIA, "R": 2.0, "a": 1.0},
        build=build_around,
        start=Start(omega=(0.7, 0.4, 1.1), gamma=(0.2, -0.3, 0.93), until=60.0),
        laws=laws,
        general=coordinates_around_sphere,
    ),
)
