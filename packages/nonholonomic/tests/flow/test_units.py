"""The same motion in other units has the same exponents, indicators and names of zeros."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

from flowlanes.flow.linearisation.state_scales import state_scales_at
from flowlanes.lyapunov.indicators import (
    exponent_sum,
    fast_lyapunov_indicator,
    megno,
    smaller_alignment_index,
)
from flowlanes.lyapunov.report import Spectrum
from flowlanes.lyapunov.spectrum import lyapunov_spectrum
from flowlanes.lyapunov.zero_exponents import vanishes_to_rounding
from nonholonomic.catalogue import from_catalogue

#: Lengths are multiplied by these numbers, masses by their cubes: centimetres, millimetres.
SCALES = (1e-2, 1e3)
RULES = (exponent_sum, fast_lyapunov_indicator, megno, smaller_alignment_index)
FORCED = {
    "unbalanced-ball": ["γ² = 1", "energy", "quadratic", "flow"],
    "chaplygin-ball": ["γ² = 1", "energy", "area", "momentum", "flow"],
}


def _ball(name: str, scale: float) -> tuple[Any, Any, dict[str, float]]:
    """A ball, a start, and parameters in other units; times are the same."""
    system = from_catalogue(name)
    powers = {"m": 3, "R": 1, "c": 1, "I": 5}
    given = {str(symbol): value for symbol, value in system.defaults.items()}
    parameters = {key: value * scale ** powers[key[0]] for key, value in given.items()}
    # M = (2, 5, 7) and γ: it turns about all its axes
    momentum = np.array([2.0, 5.0, 7.0]) * scale**5
    return system, np.append(momentum, [0.36, 0.48, 0.8]), parameters


@cache
def _spectrum(name: str, scale: float) -> Spectrum:
    system, start, parameters = _ball(name, scale)
    return lyapunov_spectrum(system, start, parameters, t_end=100.0, samples=100)


@pytest.mark.slow
@pytest.mark.parametrize("scale", SCALES)
@pytest.mark.parametrize("name", FORCED)
def test_spectra_are_the_same(name: str, scale: float) -> None:
    plain, scaled = _spectrum(name, 1.0), _spectrum(name, scale)
    assert [item.name for item, _ in scaled.trivial] == FORCED[name]
    assert [item.name for item, _ in plain.trivial] == FORCED[name]
    assert scaled.dependent == plain.dependent == ()
    assert scaled.values == pytest.approx(plain.values, abs=1e-7)
    assert scaled.errors == pytest.approx(plain.errors, abs=1e-7)
    assert scaled.volume.measures.keys() == plain.volume.measures.keys()
    assert abs(scaled.volume.balance) < 1e-10


@pytest.mark.slow
@pytest.mark.parametrize("scale", SCALES)
@pytest.mark.parametrize("rule", RULES)
def test_numbers_of_charts_are_the_same(rule: Any, scale: float) -> None:
    found = []
    for each in (1.0, scale):
        system, start, parameters = _ball("unbalanced-ball", each)
        found.append(rule(system, 100.0)(start[None], parameters))
    assert not found[1]["outcome"].any()
    for name in ("value", *rule.extra_columns):
        assert found[1][name] == pytest.approx(found[0][name], rel=1e-6)


@pytest.mark.slow
def test_a_batch_has_a_size_for_each_motion() -> None:
    system, start, parameters = _ball("unbalanced-ball", 1.0)
    _, other, changed = _ball("unbalanced-ball", 1e-2)
    both = {name: np.array([parameters[name], changed[name]]) for name in parameters}
    found = megno(system, 100.0)(np.array([start, other]), both)
    assert found["value"][1] == pytest.approx(found["value"][0], rel=1e-6)
    alone = megno(system, 100.0)(other[None], changed)
    assert alone["value"][0] == found["value"][1]


@pytest.mark.parametrize("scale", SCALES)
def test_a_vector_at_rest_has_the_size_that_acts_as_much_as_the_others(scale: float) -> None:
    system = from_catalogue("marble-body")
    given = {str(symbol): value for symbol, value in system.defaults.items()}
    powers = {"m": 3, "b": 1, "c": 1, "I": 5, "g": 1}
    parameters = {key: value * scale ** powers[key[0]] for key, value in given.items()}
    rest = np.array([[[0.0, 0.0, 0.0, 0.6, 0.0, 0.8]]])
    plain, scaled = state_scales_at(system, rest)[0], state_scales_at(system, rest, parameters)[0]
    assert 0.1 < plain[0] < 10.0
    assert scaled[:3] == pytest.approx(plain[:3] * scale**5, rel=1e-12)
    assert np.array_equal(scaled[3:], np.ones(3))


def test_rounding_couples_no_vectors() -> None:
    # M along γ along an axis: what changes M vanishes with the deviation of γ, up to rounding
    system = from_catalogue("chaplygin-ball")
    state = np.array([[[1e-45, 0.0, 0.7, 0.0, 1e-33, 1.0]]])
    assert state_scales_at(system, state)[0] == pytest.approx([0.7] * 3 + [1.0] * 3, rel=1e-12)


def test_conditions_on_parameters_are_not_met_because_these_are_small() -> None:
    system, start, parameters = _ball("chaplygin-ball", 1e-3)
    first, second = (p.symbol for p in system.parameters if str(p.symbol) in ("I_1", "I_2"))
    sizes = state_scales_at(system, start[None, None], parameters)[0]
    assert not vanishes_to_rounding(system, [first - second], start, parameters, sizes)
    nearly = {**parameters, "I_1": parameters["I_2"] * (1 + 1e-15)}
    assert vanishes_to_rounding(system, [first - second], start, nearly, sizes)
