"""A heavy disk with a sharp edge, marble contact: the classical rolling coin."""

from __future__ import annotations

from ..mechanics.body import Body
from ..mechanics.rolling import Field, Rolling
from ..mechanics.shapes import Disk
from .entry import Entry, Numbers, Start


def build(p: Numbers) -> Rolling:
    """A disk of radius R with axis of symmetry along body axis 3."""
    body = Body(p["m"], (p["I_1"], p["I_1"], p["I_3"]), Disk(p["R"]))
    return Rolling(body, field=Field(p["g"]))


ENTRIES = (
    Entry(
        name="heavy-disk",
        title="Heavy disk",
        summary="A heavy disk with a sharp edge rolls on a horizontal plane without slipping, as "
        "a coin does; its two integrals linear in ω are not elementary functions.",
        source="§4.1, §11.4",
        # a uniform thin disk
        defaults={"m": 1.0, "I_1": 0.25, "I_3": 0.5, "R": 1.0, "g": 9.81},
        build=build,
        start=Start(omega=(0.3, 0.4, 3.0), gamma=(0.8, 0.2, 0.5656854249492381), until=12.0),
    ),
)
