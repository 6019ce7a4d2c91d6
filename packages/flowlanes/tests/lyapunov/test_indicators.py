"""How fast neighbours part, where it is known in closed form."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.lyapunov.indicators import (
    exponent_sum,
    fast_lyapunov_indicator,
    maximal_exponent,
    megno,
    smaller_alignment_index,
)
from flowlanes.system.laws import Integral
from flowlanes.system.system import Parameter, System

x, y, z, s, r = sp.symbols("x y z s r", real=True)

#: Neighbours part like exp(s t) in x and exp(−r t) in y; z is the time.
SADDLE = System(
    name="saddle",
    title="Saddle",
    field={x: s * sp.sin(x), y: -r * y, z: sp.S.One},
    parameters=(Parameter(s, "growth", 0.5), Parameter(r, "decay", 0.5)),
)
PENDULUM = System(name="pendulum", title="Pendulum", field={x: y, y: -sp.sin(x)})
ORIGIN = np.zeros((4, 3))
RATES = {s: np.array([0.1, 0.2, 0.4, 0.8]), r: np.array([0.1, 0.3, 0.5, 0.5])}
SWINGS = np.array([[0.5, 0.0], [1.0, 0.0], [2.0, 0.0], [0.0, 2.5]])


def test_the_largest_exponent() -> None:
    found = maximal_exponent(SADDLE, 200.0)(ORIGIN, RATES)
    assert np.all(np.abs(found["value"] - RATES[s]) <= 1e-7)
    assert np.all(found["error"] < 0.05)
    assert not found["outcome"].any()
    assert np.array_equal(found["ended"], np.full(4, 200.0))


def test_the_sum_of_exponents() -> None:
    found = exponent_sum(SADDLE, 100.0)(ORIGIN, RATES)
    assert np.all(np.abs(found["value"] - (RATES[s] - RATES[r])) <= 1e-9)


@pytest.mark.slow
def test_indicators_of_an_exponential() -> None:
    growth = RATES[s] * 100.0
    assert np.all(
        np.abs(fast_lyapunov_indicator(SADDLE, 100.0)(ORIGIN, RATES)["value"] - growth) < 3.0
    )
    mean = megno(SADDLE, 100.0, samples=400)(ORIGIN, RATES)["value"]
    assert np.all(np.abs(mean - growth / 2) < 1.0)
    sali = smaller_alignment_index(SADDLE, 20.0)(ORIGIN, RATES)["value"]
    assert np.all(np.diff(sali) < -0.5)


def test_regular_motions_part_evenly() -> None:
    assert np.all(np.abs(megno(PENDULUM, 2000.0)(SWINGS, {})["value"] - 2.0) < 0.2)
    found = maximal_exponent(PENDULUM, 2000.0)(SWINGS, {})
    assert np.all(np.abs(found["value"]) <= found["error"])
    assert np.all(fast_lyapunov_indicator(PENDULUM, 2000.0)(SWINGS, {})["value"] < 10.0)


def test_no_neighbour_matters_and_the_end_of_one_is_told() -> None:
    blowing = System(name="blowing", title="Blowing", field={x: x**2 + y**2, y: -y, z: sp.S.One})
    starts = np.array([[-1.0, 0.0, 0.0], [0.5, 0.0, 0.0], [-2.0, 0.0, 0.0]])
    found = maximal_exponent(blowing, 10.0)(starts, {})
    assert found["outcome"][1] != 0
    assert 1.9 < found["ended"][1] < 2.0 + 1e-9
    assert np.isnan(found["value"][1])
    alone = maximal_exponent(blowing, 10.0)(starts[[0, 2]], {})
    assert np.array_equal(found["value"][[0, 2]], alone["value"])


def test_nothing_can_part() -> None:
    energy = Integral("energy", y**2 / 2 - sp.cos(x), "energy")
    with pytest.raises(InputError, match="neighbours cannot part"):
        maximal_exponent(PENDULUM.with_laws(energy), 10.0)(SWINGS, {})


def test_too_few_intervals() -> None:
    with pytest.raises(InputError, match="samples = 10: at least 32 are needed"):
        maximal_exponent(SADDLE, 10.0, samples=10)


@pytest.mark.slow
def test_intervals_are_parted_where_neighbours_part_fast() -> None:
    # within an interval of 1, one deviation shrinks by exp(−100) beside the other
    found = exponent_sum(SADDLE, 32.0, samples=32)(ORIGIN[:1], {s: 0.5, r: 100.0})
    assert found["value"] == pytest.approx([0.5 - 100.0], rel=1e-6)


@pytest.mark.slow
def test_no_number_is_told_where_they_part_too_fast() -> None:
    found = exponent_sum(SADDLE, 32.0, samples=32)(ORIGIN[:2], {s: 0.5, r: np.array([3000.0, 0.5])})
    assert np.isnan(found["value"][0])
    assert found["value"][1] == pytest.approx(0.0, abs=1e-9)
