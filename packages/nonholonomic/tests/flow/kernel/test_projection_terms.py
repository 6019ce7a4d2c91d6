"""Moving a state so that functions keep their values: shortest, relative, and never by much."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import sympy as sp

from flow.small import KEPLER, OSCILLATOR, TOP, body, starts, u, v, x, y
from flowlanes.flow.kernel.equations import equations_of
from flowlanes.flow.kernel.projection_terms import ProjectionTerms, projection_terms
from flowlanes.formulas.array_evaluation import numbers, read_formulas, values
from flowlanes.system.system import System


def kept_of(system: System, names: list[Any], vanishing: tuple[Any, ...] = ()) -> ProjectionTerms:
    """The correction that keeps some formulas and makes others vanish."""
    reader, _ = read_formulas(system)
    laws = {law.name: law.value for law in system.integrals}
    groups = equations_of(system, 0, None, False).groups
    return projection_terms(
        reader.graph,
        [reader(laws.get(name, name)) for name in names],
        [reader(formula) for formula in vanishing],
        groups,
        [reader.graph.state(len(system.symbols) + k) for k in range(len(names) + len(vanishing))],
    )


def moved(system: System, kept: ProjectionTerms, state: Any, targets: Any) -> tuple[Any, Any]:
    """A state after the correction, and its residuals before it."""
    parameters = np.array([float(q.default) for q in system.parameters])
    filled = np.append(state, targets)[None]
    residuals = numbers(kept.residuals, filled, parameters)[0]
    change = numbers(kept.correction, np.append(state, residuals)[None], parameters)[0]
    return state + change, residuals


def test_a_state_returns_to_its_level() -> None:
    """What is left falls with the square of what there was."""
    kept = kept_of(KEPLER, ["energy", "area"])
    state = np.array([0.4, 0.1, 0.2, 1.7])
    targets = values(KEPLER, ["energy", "area"], state)
    away = np.array([0.3, -1.0, 0.5, 0.7])
    left = []
    for distance in (1e-3, 1e-4):
        found, residuals = moved(KEPLER, kept, state + distance * away, targets)
        assert np.abs(residuals).max() > distance / 10
        left.append(np.abs(values(KEPLER, ["energy", "area"], found) - targets).max())
    assert left[0] < 1e-4
    assert left[1] == pytest.approx(left[0] / 100, rel=0.2)


def test_the_change_is_the_shortest() -> None:
    """−D Gᵀ(G D Gᵀ)⁻¹ c with lengths of vectors in D, computed otherwise."""
    ball = body("chaplygin-ball")
    relation = ball.relations[0]
    kept = kept_of(ball, ["energy", "area"], (relation,))
    state = starts("chaplygin-ball", 1, seed=7)[0]
    laws = [law.value for law in ball.integrals if law.name in ("energy", "area")]
    targets = values(ball, laws, state)
    near = state + 1e-6 * np.arange(1, 7)
    found, residuals = moved(ball, kept, near, targets)
    step = 1e-6
    slopes = np.array(
        [
            (values(ball, [*laws, relation], near + d) - values(ball, [*laws, relation], near - d))
            / (2 * step)
            for d in step * np.eye(6)
        ]
    ).T
    squares = np.repeat([near[:3] @ near[:3], near[3:] @ near[3:]], 3)
    matrix = slopes * squares @ slopes.T
    right = -squares * (slopes.T @ np.linalg.solve(matrix, residuals))
    np.testing.assert_allclose(found - near, right, rtol=1e-6, atol=1e-13)
    assert np.abs(values(ball, [*laws, relation], found)[:2] - targets).max() < 1e-9
    assert abs(values(ball, [relation], found)[0]) < 1e-9


def test_what_vanishes_has_no_target() -> None:
    kept = kept_of(TOP, [], (TOP.relations[0],))
    assert len(kept.residuals) == 1
    state = np.array([0.3, -1.0, 0.7, 0.0, 0.6, 0.801])
    found, _ = moved(TOP, kept, state, [])
    np.testing.assert_array_equal(found[:3], state[:3])
    assert abs(found[3:] @ found[3:] - 1) < 1e-6
    np.testing.assert_allclose(np.cross(found[3:], state[3:]), 0, atol=1e-15)


def test_dependent_gradients_are_corrected_once() -> None:
    """The same function twice moves the state as far as once."""
    once = kept_of(OSCILLATOR, ["energy"])
    twice = kept_of(OSCILLATOR, ["energy", "energy"])
    state, target = np.array([0.6, 0.81]), 1.0
    first, _ = moved(OSCILLATOR, once, state, [target])
    second, _ = moved(OSCILLATOR, twice, state, [target, target])
    np.testing.assert_allclose(second, first, rtol=1e-14)
    assert np.isfinite(second).all()


def test_where_a_gradient_vanishes_nothing_moves() -> None:
    kept = kept_of(OSCILLATOR, ["energy"])
    found, _ = moved(OSCILLATOR, kept, np.zeros(2), [1e-17])
    assert np.abs(found).max() < 1e-15
    steady = kept_of(KEPLER, ["energy", "area"])
    circle = np.array([1.0, 0.0, 0.0, 1.0])
    found, _ = moved(KEPLER, steady, circle, [-0.5 + 1e-12, 1.0])
    assert np.abs(found - circle).max() < 1e-11


def test_on_the_level_nothing_moves() -> None:
    kept = kept_of(KEPLER, [u * x + v * y, sp.atan2(y, x)])
    state = np.array([0.5, 0.25, 1.0, 0.125])
    targets = values(KEPLER, [u * x + v * y, sp.atan2(y, x)], state)
    found, residuals = moved(KEPLER, kept, state, targets)
    assert not residuals.any()
    assert found.tolist() == state.tolist()
