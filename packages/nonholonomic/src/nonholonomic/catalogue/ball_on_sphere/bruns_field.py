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
from ..catalogue_entry import bruns_factor, laws_for
from ..chaplygin_ball.chaplygin_ball import MOMENTUM_UNIT
from ..chaplygin_ball.chaplygin_bracket import DET_IQ
from . import ball_on_sphere

M, gamma = vectors("M gamma")
J, A = Diagonal("J"), Diagonal("A")
SOURCE = "§12, problem 1"
HALF = sp.Rational(1, 2)


@laws_for("marble", Sphere, Ball)
def laws(rolling: RollingBody, system: System) -> tuple[Law, ...]:
    """Momentum, measure and, for k = −1, the linear integral of a ball on a sphere."""
    body, field = rolling.body, rolling.field
    # of the ball without the field: k = a/(a ± R), and the linear integral where k = −1
    free = replace(rolling, field=Forces())
    factor = bruns_factor(field.potential) if body.principal else None
    if (
        factor is None
        or field.gravity
        or any(body.gyrostat)
        or ball_on_sphere.radius_ratio(free) is None
    ):
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
