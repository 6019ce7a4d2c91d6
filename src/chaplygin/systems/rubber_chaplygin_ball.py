"""The Chaplygin ball with rubber contact (§2.4), equivalent to the Veselova system."""

from __future__ import annotations

from dataclasses import replace

from ..mechanics.rolling import Rolling
from ..mechanics.shapes import Ball
from ..mechanics.surfaces import Plane
from ..statements import Integral
from ..system import System
from ..vectors import Diagonal, cross, dot, normed, vectors, zero
from . import chaplygin_ball
from .entry import Entry, Numbers, Start, bruns_factor

M, gamma, k = vectors("M gamma k")
J, A = Diagonal("J"), Diagonal("A")


def build(p: Numbers) -> Rolling:
    """The same ball, kept from spinning."""
    return replace(chaplygin_ball.build(p), contact="rubber")


def laws(rolling: Rolling, system: System) -> tuple[Integral, ...]:
    """The square of the horizontal momentum, without a potential or with Bruns'."""
    body = rolling.body
    balanced = isinstance(body.shape, Ball) and not any(body.shape.centre)
    if not (balanced and rolling.surface == Plane() and rolling.contact == "rubber"):
        return ()
    total = M + k if any(body.gyrostat) else M + zero
    value = normed(cross(total, gamma))
    potential = rolling.field.potential
    if potential == 0:
        return (
            Integral(
                "momentum",
                value,
                "square of the horizontal momentum",
                source="(6.4)",
                unit="kg^2 m^4/s^2",
            ),
        )
    if body.principal and total == M and (factor := bruns_factor(potential)) is not None:
        J_1, J_2, J_3 = J.symbols
        value = value - factor * J_1 * J_2 * J_3 * dot(gamma, A * gamma)
        meaning = "square of the horizontal momentum, Bruns field"
        return (Integral("momentum", value, meaning, source="Remark 15", unit="kg^2 m^4/s^2"),)
    return ()


ENTRIES = (
    Entry(
        name="rubber-chaplygin-ball",
        title="Chaplygin ball with rubber contact",
        summary="A balanced, dynamically asymmetric ball rolls on a horizontal plane with neither "
        "slipping nor spinning; its equations are those of the Veselova system with J = I + mR².",
        source="§2.4",
        defaults=chaplygin_ball.ENTRIES[0].defaults,
        build=build,
        start=Start(omega=(0.9, -0.5, -0.35483870967741937), gamma=(0.2, -0.3, 0.93), until=60.0),
        laws=laws,
    ),
)
