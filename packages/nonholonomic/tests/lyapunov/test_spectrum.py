"""Lyapunov spectra against those that are known."""

from __future__ import annotations

import dataclasses
import json
from math import sqrt
from typing import Any

import numpy as np
import pytest
import sympy as sp

from catalogue import built
from flow.motions import carousel, henon_heiles, henon_heiles_start, lorenz, saddle, top
from flowlanes.errors import InputError, RunError
from flowlanes.flow.linearisation.linear_stability import linear_stability
from flowlanes.lyapunov.attractor_dimension import kaplan_yorke
from flowlanes.lyapunov.record import record, remarks
from flowlanes.lyapunov.report import Spectrum
from flowlanes.lyapunov.spectrum import lyapunov_spectrum
from flowlanes.lyapunov.zero_exponents import trivial_directions
from flowlanes.system.laws import Integral, Symmetry
from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol
from nonholonomic.catalogue import CATALOGUE


@pytest.fixture(scope="module")
def butterfly() -> Spectrum:
    return lyapunov_spectrum(lorenz(), [1.0, 1.0, 20.0], t_end=1000.0)


def _start(name: str) -> tuple[System, list[float]]:
    made = built.example(name)
    return made.system, [float(x) for x in made.reduced_start]


def _removed(found: Spectrum) -> list[str]:
    return [item.name for item, _ in found.trivial]


# --- known exponents -------------------------------------------------------------------------


@pytest.mark.slow
def test_lorenz(butterfly: Spectrum) -> None:
    first, second = butterfly.exponents
    assert first.error < 0.03
    assert abs(first.value - 0.9056) < first.error
    assert abs(second.value + 14.5723) < second.error
    assert butterfly.chaotic and butterfly.halves_agree
    assert _removed(butterfly) == ["flow"]


@pytest.mark.slow
def test_volumes_of_lorenz_shrink_evenly(butterfly: Spectrum) -> None:
    even = -(10 + 1 + 8 / 3)
    assert butterfly.volume.divergence.value == pytest.approx(even, rel=1e-12)
    assert abs(butterfly.volume.balance) < 1e-9
    assert abs(butterfly.total.value - even) < butterfly.total.error


def test_dimension_of_lorenz(butterfly: Spectrum) -> None:
    value, error = butterfly.dimension
    assert 0 < error < 0.005
    assert abs(value - 2.0622) < 4 * error


@pytest.mark.slow
def test_henon_heiles() -> None:
    start = henon_heiles_start(1 / 8, -0.25, 1e-3)
    found = lyapunov_spectrum(henon_heiles(), start, t_end=3000.0)
    assert _removed(found) == ["energy", "flow"]
    assert found.chaotic and found.symmetric
    assert found.total.zero
    assert abs(found.volume.measures["volume"]) < 1e-12
    assert found.volume.divergence.value == 0.0


def test_hyperbolic_linear_system() -> None:
    found = lyapunov_spectrum(saddle(), [0.0, 0.0, 0.0], t_end=50.0)
    assert found.values == pytest.approx([0.3, -1.1], abs=1e-3)
    assert _removed(found) == ["z"]
    assert found.dependent == ("flow",)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["chaplygin-ball", "rubber-chaplygin-ball", "veselova", "clebsch"])
def test_integrable_systems_have_only_zeros(name: str) -> None:
    system, start = _start(name)
    found = lyapunov_spectrum(system, start, t_end=500.0, intervals=200)
    assert found.halves_agree
    assert all(item.zero for item in found.exponents)
    assert all(item.error < 0.05 for item in found.exponents)
    assert "flow" in _removed(found)


@pytest.mark.slow
def test_limit_cycle() -> None:
    found = lyapunov_spectrum(carousel(), [0.3, 0.1, 0.0], t_end=60.0)
    # u and v are measured by sizes of their own, equal but for where the cycle was looked at
    assert found.values == pytest.approx([-2.0], abs=1e-4)
    assert set(_removed(found)) == {"s", "flow"} or set(_removed(found)) == {"s", "turning"}


@pytest.mark.parametrize(("axis", "growth"), [(0, 0.0), (1, sqrt(1 / 12)), (2, 0.0)])
def test_steady_turns_of_a_top(axis: int, growth: float) -> None:
    # about the middle axis: λ² = M²(1/I₂ − 1/I₃)(1/I₁ − 1/I₂), on the level of the integrals
    system = dataclasses.replace(top(), laws=())
    start = [0.0, 0.0, 0.0]
    start[axis] = 1.0
    found = lyapunov_spectrum(system, start, t_end=100.0)
    linear = linear_stability(system, start)
    expected = sorted((float(value.real) for value in linear.eigenvalues), reverse=True)
    assert found.values == pytest.approx(expected, abs=0.02)
    assert found.values[0] == pytest.approx(growth, abs=0.02)


@pytest.mark.slow
def test_separatrix_of_a_top() -> None:
    # M² = 2 E I₂: the motion tends to the turn about the middle axis, where the flow vanishes and
    # both integrals have parallel gradients, like 1/cosh(t/√12)
    start = [sqrt(1 / 4), 0.0, sqrt(3 / 4)]
    found = lyapunov_spectrum(top(), start, t_end=80.0)
    assert set(found.fading) == {"flow", "square"}
    assert _removed(found) == ["energy"]
    assert found.values == pytest.approx([sqrt(1 / 12), -sqrt(1 / 12)], abs=1e-3)


# --- volumes ---------------------------------------------------------------------------------

FEW = ("marble-body", "suslov", "heavy-disk", "ball-bearing", "chaplygin-sleigh-reduced")


@pytest.mark.parametrize(
    "name",
    [pytest.param(name, marks=() if name in FEW else pytest.mark.slow) for name in CATALOGUE],
)
def test_exponents_and_divergence_agree_to_rounding(name: str) -> None:
    system, start = _start(name)
    system = dataclasses.replace(system, guards=())
    # short, since some run into singular points and others vary fast
    found = lyapunov_spectrum(system, start, t_end=CATALOGUE[name].start.until / 40, intervals=100)
    size = 1 + abs(found.volume.divergence.value)
    assert abs(found.volume.balance) < 1e-8 * size
    assert all(abs(defect) < 1e-8 * size for defect in found.volume.measures.values())


# --- what is forced --------------------------------------------------------------------------


def test_forced_zeros_are_named() -> None:
    system, start = _start("chaplygin-ball")
    made = trivial_directions(system, start)
    assert [item.name for item in made.trivial] == [
        "γ² = 1",
        "energy",
        "area",
        "momentum",
        "flow",
    ]
    assert made.space.dimension == 1
    assert made.trivial[0].exponent is None
    assert made.trivial[1].exponent == 0.0


def test_dependent_integrals_force_nothing() -> None:
    system, start = _start("clebsch")
    twice = system.with_laws(Integral("again", 3 * system.integrals[0].value))
    assert "again" in trivial_directions(twice, start).dependent
    assert (
        trivial_directions(twice, start).space.dimension
        == trivial_directions(system, start).space.dimension
    )


def test_levels_of_integrals_are_respected() -> None:
    x, y = real_symbol("x"), real_symbol("y")
    system = System(
        "turn",
        "Turn",
        {x: -y * (1 + x), y: x * (1 + x)},
        laws=(Integral("somewhere", x - y, level=(x**2 + y**2 - 1,)),),
    )
    assert [item.name for item in trivial_directions(system, [1.0, 0.5]).trivial] == ["flow"]


def test_a_motion_at_rest_has_no_direction() -> None:
    assert "flow" in trivial_directions(top(), [0.0, 1.0, 0.0]).dependent


def test_symmetries_are_removed() -> None:
    system, start = _start("heavy-disk")
    assert "rotation" in [item.name for item in trivial_directions(system, start).trivial]


def test_combinations_of_symmetries_within_a_level() -> None:
    # both raise z; once the one and twice less the other keeps it and is the flow
    x, z = real_symbol("x"), real_symbol("z")
    system = System(
        "lift",
        "Lift",
        {x: sp.S.One, z: 0 * x * z},
        laws=(
            Integral("height", z),
            Symmetry("along", {x: sp.Integer(2), z: sp.S.One}),
            Symmetry("up", {z: sp.S.One}),
        ),
    )
    made = trivial_directions(system, [1.0, 2.0])
    assert made.space.dimension == 0


# --- errors and words ------------------------------------------------------------------------


@pytest.mark.slow
def test_a_short_motion_is_said_not_to_have_settled() -> None:
    # the first part of the motion leaves a saddle, the rest falls onto a cycle
    found = lyapunov_spectrum(carousel(), [1e-30, 0.0, 0.0], t_end=110.0)
    assert not found.halves_agree
    assert any("has not converged" in text for text in remarks(found))


def test_exponents_are_numbered_with_the_zeros(butterfly: Spectrum) -> None:
    # tables call the negative exponent of Lorenz's equations the third
    assert butterfly.numbers == (1, 3)
    assert butterfly.trivial_numbers == (2,)
    plain: Any = record(butterfly)
    assert [item["number"] for item in plain["exponents"]] == [1, 3]
    assert [item["number"] for item in plain["removed"]] == [2]
    assert butterfly.dataset()["exponent"].values.tolist() == [1, 3]
    rows = dict(butterfly.overview().rows)
    assert rows["λ_2"] == "0, flow"
    assert rows["λ_3"].startswith("-14.")


def test_what_a_spectrum_tells(butterfly: Spectrum) -> None:
    sentence = " ".join(remarks(butterfly))
    assert "chaotic (observed)" in sentence
    assert "no invariant measure with a smooth positive density" in sentence
    assert "observed, not proven" in sentence
    assert "Kaplan–Yorke dimension 2.06" in sentence


def test_plain_values(butterfly: Spectrum) -> None:
    plain = record(butterfly)
    assert json.loads(json.dumps(plain)) == plain
    assert plain["exponents"][0]["value"] == butterfly.values[0]
    assert plain["removed"] == [
        {"number": 2, "name": "flow", "kind": "flow", "seen": plain["removed"][0]["seen"]}
    ]


def test_dataset(butterfly: Spectrum) -> None:
    data = butterfly.dataset()
    assert dict(data.sizes) == {"exponent": 2, "removed": 1, "time": len(butterfly.growth)}
    assert data.running.values[-1] == pytest.approx(butterfly.values, rel=1e-12)
    assert np.isnan(data.running.values[0]).all()
    assert all({"long_name", "units", "source"} <= set(v.attrs) for v in data.variables.values())


def test_the_same_bits_again() -> None:
    runs = [
        lyapunov_spectrum(saddle(), [0.1, 0.2, 0.0], t_end=20.0, intervals=100) for _ in range(2)
    ]
    assert np.array_equal(runs[0].growth, runs[1].growth)


@pytest.mark.parametrize(
    ("exponents", "dimension"),
    [
        ([0.9056, 0.0, -14.5723], 2.06214),
        ([0.0, -1.0], 1.0),
        ([-1.0, -2.0], 0.0),
        ([1.0, 0.0, -1.0], 3.0),
        ([-3.0, 0.5, 0.0, 0.5], 3 + 1 / 3),
    ],
)
def test_kaplan_yorke(exponents: list[float], dimension: float) -> None:
    assert kaplan_yorke(exponents) == pytest.approx(dimension, abs=1e-5)


# --- mistakes --------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("start", "until", "intervals", "message"),
    [
        ([1.0, 1.0], 1.0, 100, "has 2 numbers"),
        ([1.0, 1.0, 1.0], -1.0, 100, "must be positive"),
        ([1.0, 1.0, 1.0], 1.0, 3, "from 100 to"),
    ],
)
def test_mistakes(start: list[float], until: float, intervals: int, message: str) -> None:
    with pytest.raises(InputError, match=message):
        lyapunov_spectrum(lorenz(), start, t_end=until, intervals=intervals)


def test_a_start_off_the_phase_space() -> None:
    system, start = _start("chaplygin-ball")
    start[3] += 1e-3
    with pytest.raises(InputError, match="misses the phase space"):
        lyapunov_spectrum(system, start, t_end=10.0)


def test_a_motion_that_ends() -> None:
    x = real_symbol("x")
    with pytest.raises(RunError):
        lyapunov_spectrum(System("burst", "Burst", {x: x**2}), [1.0], t_end=10.0)
