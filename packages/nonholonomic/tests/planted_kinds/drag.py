"""A new law of friction: a drag that grows with the square of the slip."""

from __future__ import annotations

from dataclasses import dataclass

from flowlanes.system.vectors import real_symbol
from nonholonomic.contact.friction.friction_law import Coefficient, CoefficientLaw, Reaction
from nonholonomic.contact.friction.symbols import slip, slip_speed

c = real_symbol("c_q")


@dataclass(frozen=True)
class Drag(CoefficientLaw):
    """A force −c |u| u, whatever the normal force."""

    drag: float

    kind = "drag"
    coefficients = (Coefficient("drag", c, "coefficient of drag", "kg/m"),)
    in_words = "drag {drag:g} kg/m times the square of the slip"
    acts_while = "sliding"
    formula = Reaction(force=-c * slip_speed * slip)
    dissipation = ((c, slip_speed, slip_speed**2),)
