"""The Chaplygin ball (§7): a balanced, dynamically asymmetric ball on a plane."""

from __future__ import annotations

from ..mechanics.body import Body
from ..mechanics.rolling import Rolling
from ..mechanics.shapes import Ball
from ..mechanics.surfaces import Plane
from ..statements import Integral
from ..system import System
from ..vectors import Diagonal, dot, normed, vectors, zero
from .entry import Entry, Numbers, Start, bruns_factor

M, gamma, k = vectors("M gamma k")
J, A = Diagonal("J"), Diagonal("A")


def build(p: Numbers) -> Rolling:
    """A ball with its centre of mass at its centre."""
    return Rolling(Body(p["m"], (p["I_1"], p["I_2"], p["I_3"]), Ball(p["R"])))


def laws(rolling: Rolling, system: System) -> tuple[Integral, ...]:
    """Area integral in every potential; the square of the momentum without one or with Bruns'."""
    body = rolling.body
    balanced = isinstance(body.shape, Ball) and not any(body.shape.centre)
    if not (balanced and rolling.surface == Plane() and rolling.contact == "marble"):
        return ()
    total = M + k if any(body.gyrostat) else M + zero
    found = [Integral("area", dot(total, gamma), "area integral", source="(7.2)", unit="kg m^2/s")]
    potential = rolling.field.potential
    if potential == 0:
        found.append(
            Integral(
                "momentum",
                normed(total),
                "square of the momentum",
                source="(7.4)",
                unit="kg^2 m^4/s^2",
            )
        )
    elif body.principal and total == M and (factor := bruns_factor(potential)) is not None:
        J_1, J_2, J_3 = J.symbols
        value = normed(M) - factor * J_1 * J_2 * J_3 * dot(gamma, A * gamma)
        found.append(
            Integral(
                "momentum",
                value,
                "square of the momentum, Bruns field",
                source="Remark 20",
                unit="kg^2 m^4/s^2",
            )
        )
    return tuple(found)


ENTRIES = (
    Entry(
        name="chaplygin-ball",
        title="Chaplygin ball",
        summary="A balanced, dynamically asymmetric ball rolls on a horizontal plane without "
        "slipping; it may spin about the vertical.",
        source="§7.1, (7.1)–(7.4)",
        defaults={"m": 1.0, "I_1": 1.0, "I_2": 1.5, "I_3": 2.1, "R": 1.0},
        build=build,
        start=Start(omega=(0.7, 0.4, 1.1), gamma=(0.2, -0.3, 0.93), until=60.0),
        laws=laws,
    ),
)
