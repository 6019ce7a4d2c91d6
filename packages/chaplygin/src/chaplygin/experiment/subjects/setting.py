"""A rolling body, its support, the contact and the forces in one line."""

from __future__ import annotations

from flowlanes.printing.numerals import number
from nonholonomic.mechanics.rolling.equations import RollingBody


def rolling_setting(rolling: RollingBody) -> str:
    """The body, its support, the contact and the forces in one line."""
    manner = "without slipping"
    if rolling.contact == "rubber":
        manner = "with neither slipping nor spinning"
    gravity = rolling.field.gravity
    field = f"gravity {number(gravity, 6)} m/s²" if gravity else "no gravity"
    if rolling.field.potential != 0:
        field += ", a potential U(γ)"
    if any(rolling.body.gyrostat):
        field += "; with rotors"
    field += cavity_words(rolling)
    return f"{rolling.body.shape.title} on {rolling.surface.setting}, {manner}; {field}"


def cavity_words(rolling: RollingBody) -> str:
    """The fluids in the cavities of a body, as the end of its setting line.

    Empty if there are none.
    """
    fluids = rolling.body.fluids
    if not fluids:
        return ""
    described = (
        f"{number(fluid.cavity.mass, 6)} kg of ideal fluid in a cavity with the semi-axes "
        f"{', '.join(number(b, 6) for b in fluid.cavity.axes)} m"
        for fluid in fluids
    )
    return f"; {' and '.join(described)}"
