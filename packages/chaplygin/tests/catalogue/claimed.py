"""Every law of the catalogue with its system: the concrete ones, and those for all choices."""

from __future__ import annotations

from dataclasses import dataclass

from catalogue.built import system
from flowlanes.system.laws import Law
from flowlanes.system.system import System
from nonholonomic.catalogue import CATALOGUE


@dataclass(frozen=True)
class Claimed:
    """A law of a system, called ``system law`` or ``system (general) law``."""

    system: System
    law: Law
    label: str

    def __str__(self) -> str:
        return self.label


def _claimed() -> tuple[Claimed, ...]:
    found = []
    for name, entry in CATALOGUE.items():
        systems = {name: system(name)}
        if entry.general is not None:
            systems[f"{name} (general)"] = entry.general()
        found += [
            Claimed(one, law, f"{label} {law.name}")
            for label, one in systems.items()
            for law in one.laws
        ]
    return tuple(found)


CLAIMED = _claimed()
