"""Every law of the catalogue with its system: the concrete ones, and those for all choices."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path

from catalogue.built import system
from flowlanes.system.laws import Law
from flowlanes.system.system import System
from nonholonomic.catalogue import CATALOGUE

#: The list that tests are named after, so that nothing is built before it is tested: a label a
#: line, then a tab and ``misprint`` where the law is misprinted; ``test_laws`` compares it.
LIST = Path(__file__).with_name("laws.txt")
_MISPRINT = "\tmisprint"
LINES = tuple(LIST.read_text(encoding="utf-8").splitlines())
LABELS = tuple(line.removesuffix(_MISPRINT) for line in LINES)
MISPRINTED = tuple(line.removesuffix(_MISPRINT) for line in LINES if line.endswith(_MISPRINT))


@dataclass(frozen=True)
class Claimed:
    """A law of a system, called ``system law`` or ``system (general) law``."""

    system: System
    law: Law
    label: str

    @property
    def line(self) -> str:
        """What the list says of it."""
        return self.label + (_MISPRINT if self.law.as_printed is not None else "")


@cache
def _laws_of(name: str) -> dict[str, Claimed]:
    """The laws of an entry by their labels; of ``entry (general)``, those for all choices."""
    entry = CATALOGUE[name.removesuffix(" (general)")]
    if name.endswith(" (general)"):
        if entry.general is None:
            return {}
        one = entry.general()
    else:
        one = system(name)
    return {f"{name} {law.name}": Claimed(one, law, f"{name} {law.name}") for law in one.laws}


def claimed(label: str) -> Claimed:
    """The law of a label."""
    return _laws_of(label.rpartition(" ")[0])[label]


def all_claimed() -> tuple[Claimed, ...]:
    """Every law of the catalogue: builds every system."""
    return tuple(
        law
        for name in CATALOGUE
        for group in (name, f"{name} (general)")
        for law in _laws_of(group).values()
    )
