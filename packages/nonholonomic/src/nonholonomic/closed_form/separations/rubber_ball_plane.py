"""The Chaplygin ball with rubber contact on a plane, without a field: the Veselova system.

The ball moves as the Veselova system with J = I + mR² in place of I (§2.4, proven in the
catalogue), so all formulas of :mod:`.veselova` hold with J in place of I.
"""

from __future__ import annotations

from ...catalogue.chaplygin_ball.chaplygin_bracket import D, I, J
from ..genus_two.separation import SeparatedSystem
from .veselova import veselova_separation


def rubber_ball_plane() -> SeparatedSystem:
    """The rubber Chaplygin ball on a plane, with any three different principal moments."""
    return veselova_separation(
        "rubber-chaplygin-ball",
        "Chaplygin ball with rubber contact",
        J,
        tuple(moment + D for moment in I.symbols),
        "§2.4, Remark 16",
    )
