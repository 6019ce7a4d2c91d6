"""The catalogue in groups: what moves, by which contact, and whether it is integrable."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .catalogue_entry import Entry


@dataclass(frozen=True)
class Group:
    """Systems that belong together.

    Attributes
    ----------
    title : str
    contact : str
        ``"marble"``, ``"rubber"``, or ``"none"`` where nothing rolls.
    names : tuple of str
    """

    title: str
    contact: str
    names: tuple[str, ...]


GROUPS = (
    Group(
        "Bodies that roll without slipping (marble)",
        "marble",
        (
            *("marble-body", "marble-body-on-sphere", "rattleback", "heavy-disk"),
            *("chaplygin-ball", "chaplygin-ball-bruns", "chaplygin-ball-gyrostat"),
            *("chaplygin-ball-gyrostat-bruns", "ball-on-sphere", "ball-around-sphere"),
            *("ball-around-sphere-bruns", "unbalanced-ball", "unbalanced-ball-on-sphere"),
            *("ball-around-sphere-gyrostat-bruns", "ball-bearing-gyrostat-bruns"),
            "ball-on-two-balls",
            *("chaplygin-suslov-ball", "straight-line-ball", "ball-bearing", "chaplygin-ball-4d"),
        ),
    ),
    Group(
        "The same in other variables",
        "marble",
        (
            *("chaplygin-ball-unreduced", "chaplygin-bracket", "chaplygin-ball-angles"),
            *("chaplygin-ball-reduced", "chaplygin-bracket-gyrostat", "chaplygin-ball-fedorov"),
            *("ball-around-sphere-hamiltonian", "straight-line-ball-momenta"),
        ),
    ),
    Group(
        "Bodies that roll with neither slipping nor spinning (rubber)",
        "rubber",
        (
            *("rubber-body", "rubber-body-on-sphere", "unbalanced-rubber-ball-on-sphere"),
            *("rubber-chaplygin-ball", "rubber-chaplygin-ball-bruns", "rubber-body-of-revolution"),
            *("rubber-disk", "rubber-routh-sphere", "rubber-ball-on-sphere"),
            *("rubber-ball-around-sphere", "unbalanced-rubber-ball"),
        ),
    ),
    Group(
        "The same in other variables",
        "rubber",
        (
            *("rubber-ball-of-ratio", "rubber-ball-on-e3", "rubber-ball-sphero-conical"),
            *("rubber-ball-separated", "unbalanced-rubber-ball-centred"),
        ),
    ),
    Group(
        "Homogeneous balls on surfaces (marble)",
        "marble",
        (
            *("marble-ball", "marble-ball-on-surface", "marble-ball-in-basin"),
            *("marble-ball-on-sphere", "marble-ball-on-cone", "marble-ball-on-cylinder"),
            *("marble-ball-on-ellipsoid", "marble-ball-on-paraboloid"),
            *("marble-ball-on-round-paraboloid", "marble-ball-on-torus"),
        ),
    ),
    Group(
        "Homogeneous balls on surfaces (rubber)",
        "rubber",
        (
            *("rubber-ball-in-basin", "rubber-ball-on-cone", "rubber-ball-on-ellipsoid"),
            *("rubber-ball-on-torus", "rubber-ball-on-surface"),
        ),
    ),
    Group("Bodies that slide with friction", "none", ("sliding-ball", "sliding-top")),
    Group(
        "Bodies about a fixed point under a constraint",
        "none",
        (
            *("suslov", "suslov-quadratic", "suslov-bracket", "veselova", "veselova-bruns"),
            *("veselova-spinning", "veselova-geodesic-flow", "veselova-4d"),
            *("veselova-gyrostat-bruns", "veselova-spinning-gyrostat-bruns"),
            "two-veselova-constraints",
        ),
    ),
    Group(
        "Bodies and balls of n dimensions",
        "none",
        (
            *("suslov-nd", "veselova-nd", "special-veselova-nd", "chaplygin-ball-nd"),
            *("special-chaplygin-ball-nd", "rubber-chaplygin-ball-nd", "special-rubber-ball-nd"),
            *("chaplygin-ball-on-level-nd", "chaplygin-ball-on-sphere-nd"),
            *("rubber-ball-on-sphere-nd", "special-rubber-ball-on-sphere-nd"),
        ),
    ),
    Group(
        "Sleighs, vehicles and other mechanisms",
        "none",
        (
            *("roller-racer", "snakeboard", "trailers", "vertical-rolling-disk"),
            *("chaplygin-sleigh", "chaplygin-sleigh-reduced", "generalised-chaplygin"),
            "disk-on-ice",
        ),
    ),
    Group(
        "Holonomic systems for comparison",
        "none",
        (
            *("free-body", "lagrange-top", "lagrange-top-angles", "clebsch", "neumann"),
            *("smooth-disk", "power-potential-on-sphere"),
        ),
    ),
)

NAMES = tuple(name for group in GROUPS for name in group.names)
"""The names of all systems; to know them nothing is imported."""

#: What is proven integrable with the suggested parameters: docs/hierarchy.md has the reasons.
INTEGRABLE = frozenset(
    (
        *("snakeboard", "vertical-rolling-disk", "rubber-ball-in-basin", "marble-ball-on-sphere"),
        *("marble-ball-on-cone", "rubber-ball-on-cone", "marble-ball-on-cylinder"),
        *("rubber-ball-on-ellipsoid", "marble-ball-on-round-paraboloid", "rubber-ball-on-torus"),
        *("marble-ball", "rubber-ball-on-surface", "rubber-chaplygin-ball"),
        *("rubber-chaplygin-ball-bruns", "suslov-quadratic", "suslov-bracket", "heavy-disk"),
        *("free-body", "lagrange-top", "lagrange-top-angles", "chaplygin-sleigh"),
        "chaplygin-sleigh-reduced",
        *("generalised-chaplygin", "rubber-body-of-revolution", "rubber-disk"),
        *("rubber-routh-sphere", "veselova", "veselova-bruns", "veselova-spinning", "clebsch"),
        *("neumann", "veselova-geodesic-flow", "chaplygin-ball", "chaplygin-ball-bruns"),
        *("chaplygin-bracket", "chaplygin-ball-gyrostat", "chaplygin-bracket-gyrostat"),
        *("chaplygin-ball-fedorov", "ball-around-sphere", "ball-around-sphere-hamiltonian"),
        *("rubber-ball-of-ratio", "rubber-ball-around-sphere", "power-potential-on-sphere"),
        *("rubber-ball-separated", "disk-on-ice", "smooth-disk", "ball-around-sphere-bruns"),
        "two-veselova-constraints",
        *("special-veselova-nd", "special-rubber-ball-nd", "special-chaplygin-ball-nd"),
        *("special-rubber-ball-on-sphere-nd", "ball-bearing"),
        "straight-line-ball",
        "straight-line-ball-momenta",
    )
)


def in_section(item: Entry, section: str) -> bool:
    """Whether the paper speaks of a system in a section, such as ``"6"`` or ``"6.1"``."""
    wanted = section.removeprefix("§")
    places = re.findall(r"§(\d+(?:\.\d+)?)", item.source)
    return any(place == wanted or place.startswith(f"{wanted}.") for place in places)


def sections(catalogue: Mapping[str, Entry]) -> list[str]:
    """The sections of the paper from which the catalogue has something, in order."""
    numbers = {p for item in catalogue.values() for p in re.findall(r"§(\d+)", item.source)}
    return sorted(numbers, key=int)
