"""Systems of the catalogue, each built once for all tests."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import numpy as np

from evaluation import numeric
from flowlanes.flow.initial_states import whole_start
from flowlanes.system.system import System
from nonholonomic.catalogue import CATALOGUE, Entry
from nonholonomic.mechanics.rolling.equations import RollingBody
from nonholonomic.starts import initial_state

NAMES = tuple(CATALOGUE)


@cache
def made(name: str) -> RollingBody | System:
    """What an entry builds with its defaults."""
    item = CATALOGUE[name]
    return item.build(item.numbers())


@cache
def system(name: str) -> System:
    """The System, with the laws that the paper names."""
    found = made(name)
    return found if isinstance(found, System) else CATALOGUE[name].system()


@dataclass(frozen=True)
class Example:
    """A system with a start in flat order, its motion in space with it."""

    system: System
    start: Sequence[Any]

    @property
    def reduced_start(self) -> Sequence[Any]:
        """The start without the motion in space."""
        return self.start[: len(self.system.symbols)]

    @property
    def system_on_level(self) -> System:
        """The system with only those integrals whose level contains the start."""
        state = np.array(self.reduced_start, dtype=float)
        allowed = 1e-12 * (1 + np.abs(state).max()) ** 2
        holding = [
            law
            for law in self.system.integrals
            if (np.abs(numeric(self.system, law.level)(state)) <= allowed).all()
        ]
        return replace(self.system, laws=tuple(holding))


def example_of(entry: Entry, system: System, values: Mapping[str, Any]) -> Example:
    """A system of an entry with a start as the entry has it, by ω and γ or by the state."""
    if entry.start.state is None:
        return Example(system, initial_state(system, **values))
    return Example(system, whole_start(system, values))


@cache
def example(name: str) -> Example:
    """The example of the catalogue, ready to be followed."""
    return example_of(CATALOGUE[name], system(name), CATALOGUE[name].start.values)


#: Bodies on a surface, which ``test_catalogue`` compares with the catalogue.
ROLLING = tuple(
    [
        "marble-body",
        "marble-body-on-sphere",
        "rattleback",
        "rubber-body",
        "rubber-body-on-sphere",
        "unbalanced-rubber-ball-on-sphere",
        "rubber-chaplygin-ball",
        "rubber-chaplygin-ball-bruns",
        "heavy-disk",
        "rubber-body-of-revolution",
        "rubber-disk",
        "rubber-routh-sphere",
        "chaplygin-ball",
        "chaplygin-ball-bruns",
        "chaplygin-ball-gyrostat",
        "ball-on-sphere",
        "ball-around-sphere",
        "rubber-ball-on-sphere",
        "rubber-ball-around-sphere",
        "unbalanced-ball",
        "unbalanced-ball-on-sphere",
        "unbalanced-rubber-ball",
        "ball-around-sphere-gyrostat-bruns",
        "chaplygin-ball-gyrostat-bruns",
        "ball-around-sphere-bruns",
    ]
)
