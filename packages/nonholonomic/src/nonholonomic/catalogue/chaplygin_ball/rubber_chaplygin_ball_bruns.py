"""The Chaplygin ball with rubber contact in Bruns' field (§2.4): the Veselova system with I → J."""

from __future__ import annotations

from dataclasses import replace

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Law
from flowlanes.system.system import System

from ...mechanics.rolling.equations import Forces, Rolling
from ...mechanics.shapes.shapes import Ball
from ...mechanics.shapes.surfaces import Plane
from ..catalogue_entry import Entry, Numbers, bruns_factor, laws_for
from ..fixed_point import veselova
from . import chaplygin_ball, rubber_chaplygin_ball


def build(p: Numbers) -> Rolling:
    """The ball in the potential U = ½K(γ, Iγ)."""
    field = Forces(potential=chaplygin_ball.BRUNS, values=((veselova.K, p["K"]),))
    return replace(rubber_chaplygin_ball.build(p), field=field)


@laws_for("rubber", Plane(), Ball)
def laws(rolling: Rolling, system: System) -> tuple[Law, ...]:
    """Laws of the ball in a potential, and the isomorphism to the Veselova system."""
    known = rubber_chaplygin_ball.laws(rolling, system)
    if not known or bruns_factor(rolling.field.potential) != veselova.K:
        return known
    target = veselova.in_bruns_field({**veselova.NUMBERS, "K": 2.0})
    general = rubber_chaplygin_ball.general_system()
    forms = (law for law in general.laws if isinstance(law, Isomorphism))
    return (*known, *(replace(law, target=target) for law in forms))


_FREE = rubber_chaplygin_ball.ENTRIES[0]

ENTRIES = (
    Entry(
        name="rubber-chaplygin-ball-bruns",
        title="Chaplygin ball with rubber contact in Bruns' field",
        summary=(
            "A balanced, dynamically asymmetric ball rolls on a horizontal plane with neither "
            "slipping nor spinning in the potential U = ½K(γ, Iγ); its equations are those of the "
            "Veselova system in that potential."
        ),
        source="§2.4, Remark 15",
        defaults={**_FREE.defaults, "K": 0.7},
        build=build,
        start=_FREE.start,
        laws=laws,
    ),
)
