"""The rattleback, or Celtic stone: an ellipsoid whose axes are turned against its inertia."""

from __future__ import annotations

from ...mechanics.rolling.body import Body
from ...mechanics.rolling.equations import Forces, RollingBody
from ...mechanics.shapes.shapes import Ellipsoid
from ..catalogue_entry import Numbers
from ..file_systems import python_entry


def build(p: Numbers) -> RollingBody:
    """A heavy ellipsoid, turned by δ about the axis on which its centre of mass lies."""
    shape = Ellipsoid((p["b_1"], p["b_2"], p["b_3"]), turn=p["delta"], centre=(0.0, 0.0, p["c_3"]))
    body = Body(p["m"], (p["I_1"], p["I_2"], p["I_3"]), shape)
    return RollingBody(body, field=Forces(p["g"]))


ENTRIES = (
    python_entry(
        name="rattleback",
        build=build,
    ),
)
