"""Closed paths, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

from flowlanes.errors import InputError
from nonholonomic.control import PlanePath, figure_of_eight, path_through


def test_velocities_are_the_slopes_of_places() -> None:
    path = PlanePath("sin(t)**2", "cos(t)*sin(t)", 2 * np.pi)
    times, h = np.array([0.3, 1.1, 4.0]), 1e-5
    slopes = (path.places(times + h) - path.places(times - h)) / (2 * h)
    assert np.abs(slopes - path.velocities(times)).max() < 1e-9


def test_a_figure_of_eight_starts_and_ends_at_rest() -> None:
    path = figure_of_eight(4.0, 2.0, 10.0)
    assert np.abs(path.velocities([0.0, 10.0])).max() < 1e-14
    places = path.places(np.linspace(0, 10, 4001))
    assert np.allclose(places.max(axis=0), [2.0, 1.0], atol=1e-5)
    # x⁴/a⁴ = x²/a² − y²/(4 b²), for half axes a = 2 and b = 1 of (a sin τ, b sin 2τ)
    a, b = places.T / [[2.0], [1.0]]
    assert np.abs(a**4 - a**2 + b**2 / 4).max() < 1e-14


def test_the_path_through_points_of_a_circle_is_the_circle() -> None:
    angles = np.linspace(0, 2 * np.pi, 9)
    path = path_through(np.stack([np.cos(angles), np.sin(angles)], axis=1), 3.0)
    assert np.abs(np.linalg.norm(path.places(np.linspace(0, 3, 50)), axis=1) - 1).max() < 1e-12
    assert path.diameter == pytest.approx(2.0, rel=1e-4)


MISTAKES = {
    "not closed": (lambda: PlanePath("t", "0", 1.0), "not closed"),
    "infinite speed": (lambda: PlanePath("sqrt(t*(1 - t))", "0", 1.0), "speed is not finite"),
    "infinite place": (lambda: PlanePath("1/(t - 1/2)", "0", 1.0), "place is not finite"),
    "point": (lambda: PlanePath("1", "2", 1.0), "single point"),
    "period": (lambda: PlanePath("sin(t)", "0", 0.0), "period 0.0"),
    "unknown name": (lambda: PlanePath("sin(s)", "0", 1.0), "s"),
    "open points": (lambda: path_through([(0, 0), (1, 0), (1, 1), (0, 1)], 1.0), "not closed"),
    "few points": (lambda: path_through([(0, 0), (1, 0), (0, 0)], 1.0), "at least four"),
    "no number": (lambda: path_through([(0, 0), (1, np.nan), (1, 1), (0, 0)], 1.0), "finite"),
    "ragged": (lambda: path_through([(0, 0), (1,), (1, 1), (0, 0)], 1.0), "rows x, y"),
}


@pytest.mark.parametrize("name", MISTAKES)
def test_a_mistake_is_answered_in_one_sentence(name: str) -> None:
    call, part = MISTAKES[name]
    with pytest.raises(InputError) as refused:
        call()
    assert part in str(refused.value)
