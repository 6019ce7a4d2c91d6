"""The catalogue: one file per system of the paper, each described once.

A file offers its systems as ``ENTRIES``; :data:`CATALOGUE` collects them by name.
"""

from __future__ import annotations

from ..mechanics.rolling import Rolling
from ..statements import Integral
from ..system import System
from . import (
    ball_on_sphere,
    chaplygin_ball,
    heavy_disk,
    rattleback,
    rubber_ball_on_sphere,
    rubber_body_of_revolution,
    rubber_chaplygin_ball,
    unbalanced_ball,
    unbalanced_rubber_ball,
    veselova,
)
from .entry import Entry, Start, known_laws, lookup

__all__ = ["CATALOGUE", "Entry", "Start", "entry", "from_catalogue", "known_laws_of"]

CATALOGUE: dict[str, Entry] = {
    item.name: item
    for module in (
        chaplygin_ball,
        rubber_chaplygin_ball,
        veselova,
        unbalanced_ball,
        unbalanced_rubber_ball,
        rattleback,
        rubber_body_of_revolution,
        heavy_disk,
        ball_on_sphere,
        rubber_ball_on_sphere,
    )
    for item in module.ENTRIES
}
"""Every system of the catalogue by its name."""


def entry(name: str) -> Entry:
    """The catalogue entry of a name; InputError names the nearest one if there is none."""
    return lookup(CATALOGUE, name)


def from_catalogue(name: str, **parameters: float) -> System:
    """A System of the catalogue, with some of its parameters given by symbol name.

    Raises
    ------
    InputError
        If the catalogue has no such system, or the system no such parameter.
    """
    return entry(name).system(parameters)


def known_laws_of(rolling: Rolling, made: System) -> tuple[Integral, ...]:
    """The integrals that the catalogue knows of a body, whether or not it was named."""
    return known_laws(CATALOGUE.values(), rolling, made)
