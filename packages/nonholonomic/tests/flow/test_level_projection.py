"""States put on levels of formulas."""

from __future__ import annotations

import numpy as np

from flowlanes.flow.level_projection import project_to_level
from flowlanes.formulas.array_formulas import Formulas
from flowlanes.system.vectors import to_components
from nonholonomic.catalogue.ball_on_sphere.ball_on_sphere_equations import equations_on_sphere

BALL = equations_on_sphere()
ENERGY, MOMENTUM = (to_components(law.value) for law in BALL.integrals[:2])
LEVEL = Formulas(BALL, (to_components(BALL.relations[0]), ENERGY, MOMENTUM))
STATES = np.random.default_rng(1).normal(size=(7, 6))
RATIOS = {"k": np.linspace(-1.0, 1.0, 7)}


def test_states_are_put_on_levels() -> None:
    targets = np.stack([np.zeros(7), np.linspace(0.5, 0.8, 7), np.full(7, 3.0)], axis=1)
    states, met = project_to_level(LEVEL, STATES, targets, RATIOS)
    assert met.all()
    assert np.abs(LEVEL(states, RATIOS) - targets).max() < 2e-15


def test_what_is_held_stays() -> None:
    unit = STATES.copy()
    unit[:, 3:] /= np.linalg.norm(unit[:, 3:], axis=1, keepdims=True)
    level = Formulas(BALL, (ENERGY, MOMENTUM))
    states, met = project_to_level(level, unit, [0.6, 3.0], movable=[True] * 3 + [False] * 3)
    assert met.all()
    assert np.array_equal(states[:, 3:], unit[:, 3:])
    assert np.abs(level(states) - [0.6, 3.0]).max() < 2e-15


def test_a_state_on_its_level_is_left_where_it_is() -> None:
    exact = np.array([[0.5, -0.25, 1.0, 0.0, 0.6, 0.8]])
    there = Formulas(BALL, (MOMENTUM,))
    states, met = project_to_level(there, exact, there(exact))
    assert met.all()
    assert np.array_equal(states, exact)


def test_what_cannot_be_met_is_told_and_disturbs_nobody() -> None:
    targets = np.tile([0.0, 0.6, 3.0], (7, 1))
    alone, _ = project_to_level(LEVEL, STATES, targets)
    targets[3, 1] = 50.0  # far beyond the energy of so small a momentum
    wild = STATES.copy()
    wild[5] = np.nan
    states, met = project_to_level(LEVEL, wild, targets)
    assert met.tolist() == [True, True, True, False, True, False, True]
    assert np.array_equal(states[met], alone[met])


def test_with_nothing_to_move() -> None:
    _, met = project_to_level(LEVEL, STATES, movable=[False] * 6)
    assert not met.any()
