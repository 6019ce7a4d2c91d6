"""Balls in Bruns' field for which §12, problem 1, asks for a solution in quadratures.

A Chaplygin ball with rotors as well; and the hollow ball around a sphere of Borisov and Fedorov,
where the field leaves the linear integral of k = −1 and changes the momentum integral as it does
on a plane.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.laws import Integral, Law, Measure
from flowlanes.system.system import System
from flowlanes.system.vectors import Diagonal, dot, norm_squared, vectors

from ...mechanics.rolling.equations import Forces, RollingBody
from ...mechanics.shapes.shapes import Ball
from ...mechanics.shapes.surfaces import Sphere
from ..catalogue_entry import Numbers, bruns_factor, laws_for
from ..chaplygin_ball import chaplygin_ball
from ..chaplygin_ball.chaplygin_ball import BRUNS, MOMENTUM_UNIT, K
from ..chaplygin_ball.chaplygin_bracket import DET_IQ
from ..file_systems import python_entry
from . import ball_on_sphere

M, gamma = vectors("M gamma")
J, A = Diagonal("J"), Diagonal("A")
SOURCE = "§12, problem 1"
HALF = sp.Rational(1, 2)


def with_rotors(p: Numbers) -> RollingBody:
    """The Chaplygin ball with rotors, in Bruns' field."""
    return replace(
        chaplygin_ball.with_rotors(p), field=Forces(potential=BRUNS, parameters={K: p["K"]})
    )


def ball_around_sphere(p: Numbers) -> RollingBody:
    """The hollow ball around a sphere, in Bruns' field."""
    return replace(
        ball_on_sphere.build_around(p), field=Forces(potential=BRUNS, parameters={K: p["K"]})
    )


@laws_for("marble", Sphere, Ball)
def laws(rolling: RollingBody, system: System) -> tuple[Law, ...]:
    """Momentum, measure and, for k = −1, the linear integral of a ball on a sphere."""
    body, field = rolling.body, rolling.field
    free = replace(rolling, field=Forces())
    factor = bruns_factor(field.potential) if body.principal else None
    if factor is None or field.gravity or any(body.gyrostat) or ball_on_sphere.ratio(free) is None:
        return ()
    J_1, J_2, J_3 = J.symbols
    momentum = Integral(
        "momentum",
        norm_squared(M) - factor * J_1 * J_2 * J_3 * dot(gamma, A * gamma),
        "square of the momentum, Bruns field",
        source=SOURCE,
        unit=MOMENTUM_UNIT,
    )
    linear = [law for law in ball_on_sphere.laws(free, system) if law.name == "linear"]
    measure = Measure("measure", {DET_IQ: -HALF}, "invariant measure ρ d³M d³γ", source=SOURCE)
    return (momentum, *linear, measure)


ENTRIES = (
    python_entry(
        name="chaplygin-ball-gyrostat-bruns",
        build=with_rotors,
        laws=chaplygin_ball.laws,
    ),
    python_entry(
        name="ball-around-sphere-bruns",
        build=ball_around_sphere,
        laws=laws,
    ),
)
