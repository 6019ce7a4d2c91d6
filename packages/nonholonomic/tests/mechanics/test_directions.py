"""Angles of the normal and of the vector beside it, with the energy."""

from __future__ import annotations

import numpy as np
import pytest

from flowlanes.errors import InputError
from flowlanes.flow.sampling.level_sampler import sample_level
from nonholonomic.catalogue import from_catalogue
from nonholonomic.mechanics.charts.directions import Directions, frame


def test_the_frame_is_orthonormal_and_right_handed() -> None:
    e = np.array(frame(np.array([0.3, 2.0]), np.array([5.0, -1.0])))
    gram = np.einsum("aik,bik->kab", e, e)
    assert np.abs(gram - np.eye(3)).max() < 1e-15
    assert np.abs(np.cross(e[0].T, e[1].T) - e[2].T).max() < 1e-15


@pytest.mark.parametrize(
    ("name", "level", "drawn"),
    [
        ("veselova", {}, {"energy": 1.0}),
        ("unbalanced-rubber-ball", {}, {"energy": 1.0}),
        ("chaplygin-ball", {"area": 0.3}, {"energy": 1.0, "area": 0.3}),
        ("lagrange-top", {"area": 0.3}, {"energy": 1.0, "area": 0.3}),
    ],
)
def test_both_ways(name: str, level: dict[str, float], drawn: dict[str, float]) -> None:
    system = from_catalogue(name)
    maps = Directions(system, level, None)
    states = sample_level(system, 200, drawn, seed=1).T
    points = maps.points(states)
    assert np.abs(points[3] - 1).max() < 1e-13
    here, again = maps.states(points)
    assert here.size == 200
    assert np.abs(again - states).max() < 1e-12


def test_psi_is_the_direction_of_omega() -> None:
    maps = Directions(from_catalogue("veselova"), {}, None)
    theta, phi, psi = np.array([1.1]), np.array([2.0]), np.array([0.7])
    _, states = maps.states(np.stack([theta, phi, psi, np.array([1.0])]))
    gamma, rising, turning = frame(theta, phi)
    assert np.allclose(states[3:], gamma, atol=1e-15)
    omega = states[:3] / np.linalg.norm(states[:3])
    assert np.allclose(omega, np.cos(psi) * rising + np.sin(psi) * turning, atol=1e-15)


def test_too_little_energy_has_no_state() -> None:
    maps = Directions(from_catalogue("lagrange-top"), {"area": 0.0}, None)
    points = np.array([[0.2, 0.0, 0.0, -100.0]]).T
    assert maps.states(points)[0].size == 0


def test_at_the_pole_angles_are_undefined() -> None:
    maps = Directions(from_catalogue("veselova"), {}, None)
    theta, phi, psi, energy = maps.points(np.array([[1.0, 0, 0, 0, 0, 1.0]]).T)[:, 0]
    assert theta == 0
    assert np.isnan(phi) and np.isnan(psi)
    assert energy == pytest.approx(0.5)


def test_refusals() -> None:
    with pytest.raises(InputError, match="hold the area integral, or take a system"):
        Directions(from_catalogue("chaplygin-ball"), {}, None)
    with pytest.raises(InputError, match="component along gamma, which spin is not"):
        Directions(from_catalogue("lagrange-top"), {"spin": 0.2}, None)
    with pytest.raises(InputError, match="energy is a coordinate here"):
        Directions.span("energy", {})
