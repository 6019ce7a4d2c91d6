"""A ball with rotors between supporting balls, in Bruns' field (§12, problems 1 and 2 together).

To the ball in a ball bearing rotors of momentum k are added, and the potential U = ½K(γ, Iγ) of the
direction of the third supporting ball.  Without the field M + k is constant in space.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.laws import Integral, Law, Measure
from flowlanes.system.system import System
from flowlanes.system.vectors import Diagonal, cross, dot, real_symbol, vectors

from ..catalogue_entry import Numbers, entry_with
from ..entry_files import entry_file
from ..parameter_conditions import holding
from ..rotors_and_field import rotors_and_field
from . import ball_bearing
from .ball_bearing import MOMENTUM

M, omega, alpha, beta, gamma, k = vectors("M omega alpha beta gamma k")
I = Diagonal("I")
K, Delta = real_symbol("K"), real_symbol("Delta")
HALF = sp.Rational(1, 2)

FILE = entry_file("ball-bearing-gyrostat-bruns")
SOURCE = "§12, problems 1 and 2"


def laws() -> tuple[Law, ...]:
    """Energy, momentum about γ, measure; without a field the momentum in space."""
    total = M + k
    return (
        Integral(
            "energy",
            HALF * dot(M, omega) + HALF * K * dot(gamma, I * gamma),
            "energy",
            source=SOURCE,
            unit="J",
        ),
        *(
            Integral(
                place,
                dot(total, axis),
                f"momentum about the direction of the {place} ball",
                level=level,
                source=SOURCE,
                unit=MOMENTUM,
            )
            for place, axis, level in (
                ("first", alpha, (K,)),
                ("second", beta, (K,)),
                ("third", gamma, ()),
            )
        ),
        *(replace(law, source=SOURCE) for law in ball_bearing.ANGLES),
        Measure("measure", {Delta: -HALF}, "invariant measure", source=SOURCE),
    )


def build(p: Numbers) -> System:
    """The ball on three supporting balls, with rotors, in the field."""
    ball = ball_bearing.build(p)
    torque = cross(M, omega) + cross(k, omega) + K * cross(gamma, I * gamma)
    return replace(
        ball,
        name="ball-bearing-gyrostat-bruns",
        title=FILE.title,
        summary=FILE.summary,
        source=SOURCE,
        parameters=(*ball.parameters, *rotors_and_field(p)),
        field={**dict(ball.field), M: torque},
        laws=holding(laws(), p),
    )


def general() -> System:
    """With the laws of a ball without a field."""
    return replace(build(FILE.parameters), laws=tuple(law for law in laws() if law.level))


ENTRIES = (
    entry_with(
        name="ball-bearing-gyrostat-bruns",
        build=build,
        general=general,
    ),
)
