"""A heavy body of revolution with rubber contact on a plane (§5)."""

from __future__ import annotations

import sympy as sp

from ..mechanics.body import Body
from ..mechanics.rolling import Field, Rolling
from ..mechanics.shapes import Ball, Disk, Ellipsoid, Implicit, Revolution, Torus
from ..mechanics.surfaces import Plane
from ..statements import Integral
from ..system import System
from ..vectors import dot, scalar, vectors
from .entry import Entry, Numbers, Start

omega, gamma, r, c = vectors("omega gamma r c")
m, R, I_1, I_3 = (scalar(name) for name in ("m", "R", "I_1", "I_3"))


def build(p: Numbers) -> Rolling:
    """An ellipsoid of revolution with its centre of mass on the axis."""
    shape = Ellipsoid((p["b_1"], p["b_1"], p["b_3"]), centre=(0.0, 0.0, p["c_3"]))
    body = Body(p["m"], (p["I_1"], p["I_1"], p["I_3"]), shape)
    return Rolling(body, contact="rubber", field=Field(p["g"]))


def _symmetric(body: Body) -> bool:
    """Whether shape and inertia are those of a body of revolution about body axis 3."""
    shape = body.shape
    if isinstance(shape, Implicit) or not body.principal or any(shape.centre[:2]):
        return False
    round_shape = isinstance(shape, (Ball, Disk, Torus, Revolution)) or (
        isinstance(shape, Ellipsoid) and shape.axes[0] == shape.axes[1]
    )
    return round_shape and body.inertia[0] == body.inertia[1]


def laws(rolling: Rolling, system: System) -> tuple[Integral, ...]:
    """(5.1), linear in ω, for every profile and every potential U(γ₃)."""
    body, (g_1, g_2, g_3) = rolling.body, gamma.symbols
    depends = rolling.field.potential.free_symbols & {g_1, g_2}
    if (
        rolling.contact != "rubber"
        or rolling.surface != Plane()
        or depends
        or any(body.gyrostat)
        or not _symmetric(body)
    ):
        return ()
    height = dot(r, gamma)
    if isinstance(body.shape, Ball):
        height = dot(body.shape.offset, gamma) - R
    factor = sp.sqrt(I_1 * g_3**2 + I_3 * (1 - g_3**2) + m * height**2)
    return (
        Integral(
            "spin",
            factor * omega.symbols[2],
            "integral linear in ω",
            source="(5.1)",
            unit="kg^0.5 m/s",
        ),
    )


ENTRIES = (
    Entry(
        name="rubber-body-of-revolution",
        title="Heavy rubber body of revolution",
        summary="A heavy body of revolution, here an ellipsoid with its centre of mass on the "
        "axis, rolls on a horizontal plane with neither slipping nor spinning.",
        source="§5, (1.18), (5.1)",
        defaults={
            "m": 1.0,
            "I_1": 0.3,
            "I_3": 0.2,
            "b_1": 0.8,
            "b_3": 1.1,
            "c_3": 0.15,
            "g": 9.81,
        },
        build=build,
        start=Start(omega=(1.0, 0.8, -1.0), gamma=(0.4, 0.5, 0.8), until=12.0),
        laws=laws,
    ),
)
