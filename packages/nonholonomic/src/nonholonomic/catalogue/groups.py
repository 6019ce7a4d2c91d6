"""The groups of the catalogue, by the kind of system, the contact and integrability."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass

from .entry_files import EntryFile, entry_files, paths


@dataclass(frozen=True)
class Group:
    """Systems that belong together.

    Attributes
    ----------
    key : str
        What files of the catalogue call it.
    title : str
    contact : str
        ``"marble"``, ``"rubber"``, or ``"none"`` where nothing rolls.
    """

    key: str
    title: str
    contact: str

    @property
    def files(self) -> tuple[EntryFile, ...]:
        """The files of its systems, in the order of the paper."""
        return tuple(file for file in entry_files() if file.group == self.key)

    @property
    def names(self) -> tuple[str, ...]:
        """The names of its systems."""
        return tuple(file.name for file in self.files)


GROUPS = (
    Group("marble", "Bodies that roll without slipping (marble)", "marble"),
    Group("marble-other", "The same in other variables", "marble"),
    Group("rubber", "Bodies that roll with neither slipping nor spinning (rubber)", "rubber"),
    Group("rubber-other", "The same in other variables", "rubber"),
    Group("marble-balls", "Homogeneous balls on surfaces (marble)", "marble"),
    Group("rubber-balls", "Homogeneous balls on surfaces (rubber)", "rubber"),
    Group("sliding", "Bodies that slide with friction", "none"),
    Group("fixed-point", "Bodies about a fixed point under a constraint", "none"),
    Group("n-dimensions", "Bodies and balls of n dimensions", "none"),
    Group("mechanisms", "Sleighs, vehicles and other mechanisms", "none"),
    Group("holonomic", "Holonomic systems for comparison", "none"),
)

NAMES = tuple(paths())
"""The names of all systems; to know them nothing is imported."""


def in_section(item: EntryFile, section: str) -> bool:
    """Whether the paper treats a system in a section, such as ``"6"`` or ``"6.1"``."""
    wanted = section.removeprefix("§")
    places = re.findall(r"§(\d+(?:\.\d+)?)", item.source)
    return any(place == wanted or place.startswith(f"{wanted}.") for place in places)


def sections(files: Iterable[EntryFile]) -> list[str]:
    """The sections of the paper from which the catalogue has something, in order."""
    numbers = {p for item in files for p in re.findall(r"§(\d+)", item.source)}
    return sorted(numbers, key=int)
