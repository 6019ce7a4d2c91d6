"""Andoyer variables of a momentum and a unit vector."""

from __future__ import annotations

import numpy as np
import pytest

from flowlanes.errors import InputError
from flowlanes.flow.sampling.counter_rng import uniforms
from nonholonomic.catalogue import from_catalogue
from nonholonomic.mechanics.charts.andoyer import Andoyer, momentum_of


@pytest.fixture(scope="module")
def maps() -> Andoyer:
    return Andoyer(from_catalogue("chaplygin-ball"))


def random_points(count: int) -> np.ndarray:
    l, x, g, y, G = uniforms(1, np.arange(count), np.zeros(count), 5)
    turn = 2 * np.pi
    return np.stack([turn * l, 2 * x - 1, turn * g, (1 + G) * (2 * y - 1), 1 + G])[[0, 1, 2, 4, 3]]


def test_states_have_the_meaning_of_the_variables(maps: Andoyer) -> None:
    l, x, g, G, H = points = random_points(500)
    here, states = maps.states(points)
    M, gamma = states[:3], states[3:]
    assert here.size == 500
    assert np.abs((gamma**2).sum(axis=0) - 1).max() < 1e-14
    assert np.abs((M**2).sum(axis=0) - G**2).max() < 1e-14
    assert np.abs((M * gamma).sum(axis=0) - H).max() < 1e-14
    assert np.abs(M[2] - x * G).max() < 1e-15
    assert np.abs(M[0] * np.cos(l) - M[1] * np.sin(l)).max() < 1e-14
    # g is the angle between the lines in which planes across M meet those of l and gamma
    node = np.cross([0, 0, 1], M.T)
    other = np.cross(M.T, gamma.T)
    cosine = (node * other).sum(axis=1) / np.linalg.norm(node, axis=1)
    assert np.abs(cosine / np.linalg.norm(other, axis=1) - np.cos(g)).max() < 1e-7


def test_both_ways(maps: Andoyer) -> None:
    points = random_points(500)
    again = maps.points(maps.states(points)[1])
    again[[0, 2]] %= 2 * np.pi
    assert np.abs(again - points).max() < 1e-9


def test_outside_there_are_no_states(maps: Andoyer) -> None:
    points = np.array([[0, 0, 0, 1.0, 1.1], [0, 1.2, 0, 1.0, 0], [0, 0, 0, -1.0, 0]]).T
    assert maps.states(points)[0].size == 0


def test_angles_that_turn_about_nothing(maps: Andoyer) -> None:
    up = np.array([[0, 0, 2.0, 0.6, 0, 0.8]]).T
    l, x, g, G, H = maps.points(up)[:, 0]
    assert np.isnan(l) and np.isnan(g)
    assert (x, G, H) == (1.0, 2.0, 1.6)
    along = np.array([[1.2, 0, 1.6, 0.6, 0, 0.8]]).T
    l, x, g, G, H = maps.points(along)[:, 0]
    assert l == pytest.approx(np.pi / 2)
    assert np.isnan(g)


def test_systems_without_a_momentum_are_refused() -> None:
    with pytest.raises(InputError, match="veselova: Andoyer variables need a momentum and a unit"):
        momentum_of(from_catalogue("veselova"))
