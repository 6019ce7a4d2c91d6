"""A dynamically asymmetric ball with displaced centre of mass (§10): marble and rubber contact."""

from __future__ import annotations

from functools import partial

from flowlanes.system.laws import Integral
from flowlanes.system.system import System
from flowlanes.system.vectors import cross, dot, norm_squared, real_symbol, vectors

from ...mechanics.rolling.body import Body
from ...mechanics.rolling.equations import ContactModel, Rolling
from ...mechanics.shapes.shapes import Ball
from ...mechanics.shapes.surfaces import Plane, Sphere
from ..catalogue_entry import Entry, Numbers, Start, laws_for

M, omega, gamma, r, c = vectors("M omega gamma r c")
m, R = real_symbol("m"), real_symbol("R")


def build(p: Numbers, contact: ContactModel = "marble") -> Rolling:
    """A ball whose geometric centre is at c from its centre of mass; on a sphere if a is given."""
    centre = (p["c_1"], p["c_2"], p["c_3"])
    body = Body(p["m"], (p["I_1"], p["I_2"], p["I_3"]), Ball(p["R"], centre=centre))
    surface = Sphere.of_signed_radius(p["a"]) if "a" in p else Plane()
    return Rolling(body, surface, contact)


@laws_for(None, None, Ball)
def laws(rolling: Rolling, system: System) -> tuple[Integral, ...]:
    """The quadratic integral of a free ball: marble on a plane or a sphere, or rubber on a plane.

    M² − m r²(M, ω) of a marble ball, since ṙ is orthogonal to ω; (10.5) of a rubber ball, with
    c = −a from the centre of mass to the geometric centre.
    """
    body, field = rolling.body, rolling.field
    if (
        not any(body.shape.centre)
        or field.gravity != 0
        or field.potential != 0
        or any(body.gyrostat)
    ):
        return ()
    if rolling.contact == "marble":
        source, value = "(10.3)", norm_squared(M) - m * norm_squared(r) * dot(M, omega)
    elif rolling.surface == Plane():
        turning = 2 * m * R * dot(gamma, c) * dot(M, omega)
        source, value = "(10.5)", norm_squared(cross(M, gamma)) + turning
    else:
        return ()
    return (Integral("quadratic", value, "quadratic integral", source=source, unit="kg^2 m^4/s^2"),)


_DEFAULTS = {
    "m": 1.0,
    "I_1": 1.0,
    "I_2": 1.5,
    "I_3": 2.1,
    "R": 1.0,
    "c_1": -0.1,
    "c_2": 0.05,
    "c_3": 0.2,
}
_GAMMA = (0.2, -0.3, 0.93)
_MARBLE = Start(omega=(0.7, 0.4, 1.1), gamma=_GAMMA, until=100.0)
_RUBBER = Start(omega=(0.9, -0.5, -0.35483870967741937), gamma=_GAMMA, until=100.0)

_BALL = "A dynamically asymmetric ball whose centre of mass is not at its geometric centre rolls"

ENTRIES = (
    Entry(
        name="unbalanced-ball",
        title="Unbalanced ball",
        summary=f"{_BALL} on a horizontal plane without slipping, in the absence of gravity.",
        source="§10.1, (10.1)–(10.3)",
        defaults=_DEFAULTS,
        build=build,
        start=_MARBLE,
        laws=laws,
    ),
    Entry(
        name="unbalanced-ball-on-sphere",
        title="Unbalanced ball on a sphere",
        summary=f"{_BALL} without slipping on a fixed sphere of radius a, outside (a > 0) or "
        "inside (a < 0, |a| > R).",
        source="§10.1, after (10.3)",
        defaults={**_DEFAULTS, "a": 2.0},
        build=build,
        start=_MARBLE,
        laws=laws,
    ),
    Entry(
        name="unbalanced-rubber-ball",
        title="Unbalanced ball with rubber contact",
        summary=f"{_BALL} on a horizontal plane with neither slipping nor spinning, in the absence "
        "of gravity.",
        source="§10.2, (10.4), (10.5)",
        defaults=_DEFAULTS,
        build=partial(build, contact="rubber"),
        start=_RUBBER,
        laws=laws,
    ),
    Entry(
        name="unbalanced-rubber-ball-on-sphere",
        title="Unbalanced rubber ball on a sphere",
        summary=f"{_BALL} with neither slipping nor spinning on a fixed sphere of radius a; the "
        "energy is the only integral known.",
        source="§1.4, (1.23); §10.2",
        defaults={**_DEFAULTS, "a": 2.0},
        build=partial(build, contact="rubber"),
        start=_RUBBER,
        laws=laws,
    ),
)
