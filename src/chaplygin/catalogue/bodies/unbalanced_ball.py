"""A dynamically asymmetric ball with displaced centre of mass, marble contact (§10.1)."""

from __future__ import annotations

from dataclasses import replace

from ...core.laws import Integral
from ...core.system import System
from ...core.vectors import dot, norm_squared, real_symbol, vectors
from ...mechanics.rolling.body import Body
from ...mechanics.rolling.equations import Rolling
from ...mechanics.rolling.shapes import Ball
from ...mechanics.rolling.surfaces import Sphere
from ..entry import Entry, Numbers, Start

M, omega, r = vectors("M omega r")
m = real_symbol("m")


def build(p: Numbers) -> Rolling:
    """A ball whose geometric centre is c away from its centre of mass."""
    centre = (p["c_1"], p["c_2"], p["c_3"])
    return Rolling(Body(p["m"], (p["I_1"], p["I_2"], p["I_3"]), Ball(p["R"], centre=centre)))


def build_on_sphere(p: Numbers) -> Rolling:
    """The ball on a sphere of signed radius a."""
    return replace(build(p), surface=Sphere.of_signed_radius(p["a"]))


def is_free_unbalanced_ball(rolling: Rolling) -> bool:
    """Whether a ball with a displaced centre of mass rolls without forces and rotors."""
    body, field = rolling.body, rolling.field
    ball = isinstance(body.shape, Ball) and any(body.shape.centre)
    return bool(ball and field.gravity == 0 and field.potential == 0 and not any(body.gyrostat))


def laws(rolling: Rolling, system: System) -> tuple[Integral, ...]:
    """M² − m r²(M, ω) of a free ball, on a plane or a sphere: ṙ is orthogonal to ω on both."""
    if not (is_free_unbalanced_ball(rolling) and rolling.contact == "marble"):
        return ()
    value = norm_squared(M) - m * norm_squared(r) * dot(M, omega)
    return (
        Integral("quadratic", value, "quadratic integral", source="(10.3)", unit="kg^2 m^4/s^2"),
    )


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
_START = Start(omega=(0.7, 0.4, 1.1), gamma=(0.2, -0.3, 0.93), until=100.0)

BALL = "A dynamically asymmetric ball whose centre of mass is not at its geometric centre rolls"

ENTRIES = (
    Entry(
        name="unbalanced-ball",
        title="Unbalanced ball",
        summary=f"{BALL} on a horizontal plane without slipping, in the absence of gravity.",
        source="§10.1, (10.1)–(10.3)",
        defaults=_DEFAULTS,
        build=build,
        start=_START,
        laws=laws,
    ),
    Entry(
        name="unbalanced-ball-on-sphere",
        title="Unbalanced ball on a sphere",
        summary=f"{BALL} without slipping on a fixed sphere of radius a, outside (a > 0) or inside "
        "(a < 0, |a| > R).",
        source="§10.1, after (10.3)",
        defaults={**_DEFAULTS, "a": 2.0},
        build=build_on_sphere,
        start=_START,
        laws=laws,
    ),
)
