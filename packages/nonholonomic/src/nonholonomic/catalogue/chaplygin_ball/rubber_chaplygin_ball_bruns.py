"""The Chaplygin ball with rubber contact in Bruns' field (§2.4): the Veselova system with I → J."""

from __future__ import annotations

from dataclasses import replace

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Law
from flowlanes.system.system import System

from ...mechanics.rolling.equations import Forces, RollingBody
from ...mechanics.shapes.shapes import Ball
from ...mechanics.shapes.surfaces import Plane
from ..catalogue_entry import Numbers, bruns_factor, laws_for
from ..file_systems import file_system, python_entry
from ..fixed_point import veselova
from . import chaplygin_ball, rubber_chaplygin_ball


def build(p: Numbers) -> RollingBody:
    """The ball in the potential U = ½K(γ, Iγ)."""
    field = Forces(potential=chaplygin_ball.BRUNS, parameters={veselova.K: p["K"]})
    return replace(rubber_chaplygin_ball.build(p), field=field)


@laws_for("rubber", Plane(), Ball)
def laws(rolling: RollingBody, system: System) -> tuple[Law, ...]:
    """Laws of the ball in a potential, and the isomorphism to the Veselova system."""
    known = rubber_chaplygin_ball.laws(rolling, system)
    if not known or bruns_factor(rolling.field.potential) != veselova.K:
        return known
    target = file_system("veselova-bruns", {})
    general = rubber_chaplygin_ball.general_system()
    forms = general.laws_of(Isomorphism)
    return (*known, *(replace(law, target=target) for law in forms))


ENTRIES = (
    python_entry(
        name="rubber-chaplygin-ball-bruns",
        build=build,
        laws=laws,
    ),
)
