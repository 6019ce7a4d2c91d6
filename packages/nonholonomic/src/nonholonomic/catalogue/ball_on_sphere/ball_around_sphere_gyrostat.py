"""The hollow ball with rotors around a sphere, in Bruns' field (§12, problem 1)."""

from __future__ import annotations

from dataclasses import replace

from flowlanes.system.laws import Integral, Law, Measure
from flowlanes.system.system import System
from flowlanes.system.vectors import norm_squared, vectors

from ...mechanics.rolling.equations import Forces, RollingBody
from ...mechanics.shapes.shapes import Ball
from ...mechanics.shapes.surfaces import Sphere
from ..body_entries import catalogue_body
from ..catalogue_entry import bruns_factor, laws_for
from ..chaplygin_ball.chaplygin_ball import MOMENTUM_UNIT, K
from ..chaplygin_ball.chaplygin_bracket import DET_IQ
from . import ball_on_sphere
from .bruns_field import HALF, SOURCE

M, k = vectors("M k")


@laws_for("marble", Sphere, Ball)
def laws(rolling: RollingBody, system: System) -> tuple[Law, ...]:
    """The measure in every potential U(γ); |M + k|² where Bruns' field is switched off."""
    body, field = rolling.body, rolling.field
    balanced = ball_on_sphere.radius_ratio(replace(rolling, field=Forces())) is not None
    if field.potential == 0 or field.gravity or not balanced:
        return ()
    if not (body.principal and any(body.gyrostat)):
        return ()
    measure = Measure("measure", {DET_IQ: -HALF}, "invariant measure ρ d³M d³γ", source=SOURCE)
    values = {p.symbol: p.default for p in field.parameters}
    if bruns_factor(field.potential) == K and not values[K]:
        return (MOMENTUM, measure)
    return (measure,)


MOMENTUM = Integral(
    "momentum",
    norm_squared(M + k),
    "square of the momentum",
    level=(K,),
    source=SOURCE,
    unit=MOMENTUM_UNIT,
)


def general() -> System:
    """With the integral of a ball without a field."""
    name = "ball-around-sphere-gyrostat-bruns"
    system = catalogue_body(name).system(name)
    return replace(system, laws=(MOMENTUM,))
