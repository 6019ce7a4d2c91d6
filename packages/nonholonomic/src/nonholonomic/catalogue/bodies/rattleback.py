"""The rattleback, or Celtic stone: an ellipsoid whose axes are turned against its inertia."""

from __future__ import annotations

from ...mechanics.rolling.body import Body
from ...mechanics.rolling.equations import Forces, Rolling
from ...mechanics.shapes.shapes import Ellipsoid
from ..catalogue_entry import Entry, Numbers, Start


def build(p: Numbers) -> Rolling:
    """A heavy ellipsoid, turned by δ about the axis on which its centre of mass lies."""
    shape = Ellipsoid((p["b_1"], p["b_2"], p["b_3"]), turn=p["delta"], centre=(0.0, 0.0, p["c_3"]))
    body = Body(p["m"], (p["I_1"], p["I_2"], p["I_3"]), shape)
    return Rolling(body, field=Forces(p["g"]))


ENTRIES = (
    Entry(
        name="rattleback",
        title="Rattleback",
        summary=(
            "A heavy ellipsoid whose axes of curvature are turned against its principal axes of "
            "inertia rolls on a horizontal plane without slipping; spun one way, it stops, rattles "
            "and turns back. Besides the energy and γ² = 1 no law is known, and the divergence of "
            "the vector field at a steady rotation rules out an invariant measure that is smooth "
            "there."
        ),
        source="§1.3, (1.17) with λ₀ = 0; §3.2",
        # the stone of Kane and Levinson (1982), referred to its principal axes of inertia
        defaults={
            "m": 1.0,
            "I_1": 0.00019971434399953614,
            "I_2": 0.001600285656000464,
            "I_3": 0.0017,
            "b_1": 0.2,
            "b_2": 0.03,
            "b_3": 0.02,
            "delta": -0.01428182891938,
            "c_3": 0.01,
            "g": 9.81,
        },
        build=build,
        start=Start(
            omega=(0.0, 0.0, -5.0),
            gamma=(-0.008726535498373935, 0.008726203218641756, 0.9999238475781955),
            until=8.0,
        ),
    ),
)
