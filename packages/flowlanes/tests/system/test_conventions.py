"""Conventions: how a start is given, and what variables mean."""

from __future__ import annotations

import pickle
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
import sympy as sp

import flowlanes
from flowlanes.arguments import Parameters
from flowlanes.errors import InputError
from flowlanes.flow.initial_states import whole_start
from flowlanes.formulas.digest import digest
from flowlanes.system.arrays import FloatArray
from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import (
    Conventions,
    Metadata,
    Name,
    Reconstruction,
    System,
    VariablesByName,
)

x, y, r, phi, s = sp.symbols("x y r phi s", real=True)
FOCUS = System("focus", "Focus", {x: -x / 4 - y, y: x - y / 4})
TIMES = np.linspace(0.0, 2.0, 5)
BY_NAME = VariablesByName()


@dataclass(frozen=True)
class Polar(Conventions):
    """A point of the plane may be given by its polar coordinates."""

    unit: str = "m"

    @property
    def start_formulas(self) -> Pairs:
        return ((x, r * sp.cos(phi)), (y, r * sp.sin(phi)))

    def start_variables(self, system: System) -> tuple[Name, ...]:
        return (r, phi)

    def states(
        self, system: System, given: Mapping[str, FloatArray], parameters: Parameters
    ) -> Mapping[str, FloatArray]:
        if given.keys() != {"r", "phi"}:
            return given
        return {
            "x": given["r"] * np.cos(given["phi"]),
            "y": given["r"] * np.sin(given["phi"]),
        }

    def split_motion(
        self, system: System, start: Mapping[str, npt.ArrayLike]
    ) -> tuple[dict[str, npt.ArrayLike], dict[str, list[Any]]]:
        return BY_NAME.split_motion(system, start)

    def first_values(self, system: System, name: Name, state: Mapping[str, Any]) -> Sequence[Any]:
        return [state["x"] + 1]

    def metadata(
        self, system: System, name: str, size: int, description: tuple[str, str] | None
    ) -> Metadata:
        return f"coordinate {name}", self.unit, "", ""

    @property
    def frames(self) -> Mapping[str, tuple[str, tuple[int | str, ...]]]:
        return BY_NAME.frames

    @property
    def axis_meanings(self) -> Mapping[str, str]:
        return BY_NAME.axis_meanings

    def dimensions(self, variable: Any) -> tuple[str, ...]:
        return BY_NAME.dimensions(variable)

    @property
    def unrecorded(self) -> frozenset[str]:
        return frozenset({"y"})


POLAR = replace(FOCUS, conventions=Polar())


def test_a_start_by_other_variables() -> None:
    wanted = flowlanes.integrate(FOCUS, {"x": 2 * np.cos(0.3), "y": 2 * np.sin(0.3)}, TIMES)
    for start in ({"r": 2.0, "phi": 0.3}, {"x": 2 * np.cos(0.3), "y": 2 * np.sin(0.3)}):
        assert np.array_equal(flowlanes.integrate(POLAR, start, TIMES).states, wanted.states)
    found = flowlanes.ensemble(POLAR, flowlanes.flow.ensembles.single(r=2.0, phi=0.3), times=TIMES)
    assert np.allclose(found.x[0], wanted["x"], rtol=0, atol=1e-12)


def test_a_system_takes_its_own_variables_alone_by_default() -> None:
    with pytest.raises(InputError, match="focus: there is no phi; its state has x, y"):
        flowlanes.integrate(FOCUS, {"phi": 0.3, "r": 2.0}, TIMES)


def test_variables_mean_what_the_conventions_say() -> None:
    motion = flowlanes.integrate(POLAR, {"r": 2.0, "phi": 0.3}, TIMES).to_dataset()
    assert motion.x.attrs["long_name"] == "coordinate x"
    assert motion.x.attrs["units"] == "m"
    assert "y" not in motion
    bare = flowlanes.integrate(FOCUS, {"x": 1.0, "y": 0.0}, TIMES).to_dataset()
    assert (bare.x.attrs["long_name"], bare.x.attrs["units"]) == ("x", "unknown")
    assert "y" in bare


def test_a_reconstruction_begins_where_the_conventions_say() -> None:
    lift = Reconstruction(field={s: x}, relations=(), observables=())
    for system, first in ((FOCUS, 0.0), (POLAR, 3.0)):
        start = whole_start(replace(system, reconstruction=lift), {"x": 2.0, "y": 1.0})
        assert start == (2.0, 1.0, first)


def test_conventions_are_part_of_a_system() -> None:
    assert pickle.loads(pickle.dumps(POLAR)) == POLAR != FOCUS
    assert len({digest(FOCUS), digest(POLAR), digest(replace(POLAR, conventions=Polar("km")))}) == 3
