"""A dynamically asymmetric ball with displaced centre of mass (§10): marble and rubber contact."""

from __future__ import annotations

from functools import partial

from flowlanes.system.laws import Integral
from flowlanes.system.system import System
from flowlanes.system.vectors import cross, dot, norm_squared, real_symbol, vectors

from ...mechanics.rolling.body import Body
from ...mechanics.rolling.equations import ContactModel, RollingBody
from ...mechanics.shapes.shapes import Ball
from ...mechanics.shapes.surfaces import Plane, Sphere
from ..catalogue_entry import Numbers, entry_with, laws_for

M, omega, gamma, r, c = vectors("M omega gamma r c")
m, R = real_symbol("m"), real_symbol("R")


def build(p: Numbers, contact: ContactModel = "marble") -> RollingBody:
    """A ball on a sphere, with its geometric centre at c from its centre of mass."""
    centre = (p["c_1"], p["c_2"], p["c_3"])
    body = Body(p["m"], (p["I_1"], p["I_2"], p["I_3"]), Ball(p["R"], centre=centre))
    # a negative radius stands for the inside of the sphere
    return RollingBody(body, Sphere.of_signed_radius(p["a"]), contact)


@laws_for(None, None, Ball)
def laws(rolling: RollingBody, system: System) -> tuple[Integral, ...]:
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


ENTRIES = (
    entry_with(
        name="unbalanced-ball-on-sphere",
        build=build,
        laws=laws,
    ),
    entry_with(
        name="unbalanced-rubber-ball-on-sphere",
        build=partial(build, contact="rubber"),
        laws=laws,
    ),
)
