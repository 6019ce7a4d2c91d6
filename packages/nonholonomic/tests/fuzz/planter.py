"""Cases by the thousand, the same ones from the same seed."""

from __future__ import annotations

import random
from collections.abc import Iterator
from functools import partial

from flowlanes.errors import InputError
from flowlanes.system.laws import Law
from flowlanes.system.system import System
from fuzz.branches import BRANCHES
from fuzz.case import Case, Family, Truth
from fuzz.constrained import CONSTRAINED
from fuzz.dress import dressed
from fuzz.kinds import KINDS
from fuzz.levels import LEVELS
from fuzz.malformed import MALFORMED
from fuzz.mechanical import MECHANICAL
from fuzz.powers import POWERS
from fuzz.setting import SettingFamily
from fuzz.unspecified import UNSPECIFIED
from fuzz.volumes import VOLUMES

__all__ = ["FAMILIES", "SETTINGS", "planted", "planted_case"]

SETTINGS: dict[str, SettingFamily] = {**LEVELS, **BRANCHES, **POWERS, **UNSPECIFIED}


def _dressed(name: str, rng: random.Random) -> Case:
    return dressed(name, rng, SETTINGS[name](rng))


FAMILIES: dict[str, Family] = {
    **{name: partial(_dressed, name) for name in SETTINGS},
    **KINDS,
    **VOLUMES,
    **MECHANICAL,
    **CONSTRAINED,
    **MALFORMED,
}

#: How often a family is drawn; 1 for those that are not named.
_OFTEN = {
    "product of factors": 4,
    "conditions with functions": 3,
    "levels that move": 2,
    "volume of a relation": 3,
    "even powers": 2,
    "absolute values": 3,
    "absolute values with signs": 3,
    "energy with constraints": 3,
}
_ROUND = tuple(name for name in FAMILIES for _ in range(_OFTEN.get(name, 1)))


def planted_case(seed: int, number: int) -> Case:
    """The case of a number; each family has its turn."""
    name = _ROUND[number % len(_ROUND)]
    try:
        return FAMILIES[name](random.Random(f"{seed} {name} {number}"))
    except InputError as problem:
        return _refused(name, problem)


def _refused(name: str, problem: InputError) -> Case:
    """A case whose system is refused already: rightly so for a name of something else."""

    def make() -> tuple[System, Law]:
        raise problem

    names = ("stands for two things", "is a number or a function in every formula")
    truth: Truth = "malformed" if any(words in str(problem) for words in names) else "true"
    return Case(name, make, truth, "it could not be put together")


def planted(seed: int, count: int) -> Iterator[Case]:
    """The first cases of a seed."""
    return (planted_case(seed, number) for number in range(count))
