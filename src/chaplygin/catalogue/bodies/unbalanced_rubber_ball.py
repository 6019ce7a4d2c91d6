"""A dynamically asymmetric ball with displaced centre of mass, rubber contact (§10.2)."""

from __future__ import annotations

from dataclasses import replace

from ...core.laws import Integral
from ...core.system import System
from ...core.vectors import cross, dot, norm_squared, real_symbol, vectors
from ...mechanics.rolling.equations import Rolling
from ...mechanics.rolling.shapes import Ball
from ...mechanics.rolling.surfaces import Plane
from ..entry import Entry, Numbers, Start
from . import unbalanced_ball

M, omega, gamma, c = vectors("M omega gamma c")
m, R = real_symbol("m"), real_symbol("R")


def build(p: Numbers) -> Rolling:
    """The ball of §10.1, kept from spinning."""
    return replace(unbalanced_ball.build(p), contact="rubber")


def build_on_sphere(p: Numbers) -> Rolling:
    """The ball on a sphere, kept from spinning."""
    return replace(unbalanced_ball.build_on_sphere(p), contact="rubber")


def laws(rolling: Rolling, system: System) -> tuple[Integral, ...]:
    """(10.5), with c = −a from the centre of mass to the geometric centre."""
    body, field = rolling.body, rolling.field
    ball = isinstance(body.shape, Ball) and any(body.shape.centre)
    free = field.gravity == 0 and field.potential == 0 and not any(body.gyrostat)
    if not (ball and free and rolling.surface == Plane() and rolling.contact == "rubber"):
        return ()
    value = norm_squared(cross(M, gamma)) + 2 * m * R * dot(gamma, c) * dot(M, omega)
    return (
        Integral("quadratic", value, "quadratic integral", source="(10.5)", unit="kg^2 m^4/s^2"),
    )


_START = Start(omega=(0.9, -0.5, -0.35483870967741937), gamma=(0.2, -0.3, 0.93), until=100.0)
_ON_PLANE, _ON_SPHERE = unbalanced_ball.ENTRIES

ENTRIES = (
    Entry(
        name="unbalanced-rubber-ball",
        title="Unbalanced ball with rubber contact",
        summary=(
            "A dynamically asymmetric ball whose centre of mass is not at its geometric centre "
            "rolls on a horizontal plane with neither slipping nor spinning, in the absence of "
            "gravity."
        ),
        source="§10.2, (10.4), (10.5)",
        defaults=_ON_PLANE.defaults,
        build=build,
        start=_START,
        laws=laws,
    ),
    Entry(
        name="unbalanced-rubber-ball-on-sphere",
        title="Unbalanced rubber ball on a sphere",
        summary=(
            "A dynamically asymmetric ball whose centre of mass is not at its geometric centre "
            "rolls with neither slipping nor spinning on a fixed sphere of radius a; the energy is "
            "the only integral known."
        ),
        source="§1.4, (1.23); §10.2",
        defaults=_ON_SPHERE.defaults,
        build=build_on_sphere,
        start=_START,
        laws=laws,
    ),
)
