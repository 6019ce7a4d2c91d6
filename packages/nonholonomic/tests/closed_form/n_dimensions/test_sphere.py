"""Closed forms with special operators of n dimensions, against integrated motions."""

from __future__ import annotations

import numpy as np
import pytest
from flint import ctx

from closed_form.n_dimensions.motions import random_motion
from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.formulas.relative_zero import RESOLUTION
from nonholonomic.closed_form import solve
from nonholonomic.closed_form.base.no_closed_form import NoClosedFormError
from nonholonomic.closed_form.base.problem import Problem
from nonholonomic.closed_form.n_dimensions.few_axes import FewAxesSolution, RestSolution
from nonholonomic.closed_form.n_dimensions.operators import momentum_and_vector, operator_of
from nonholonomic.closed_form.n_dimensions.solution import SphereSolution
from nonholonomic.closed_form.n_dimensions.sphere import BITS, _on_torus, moving_axes

SPECIAL = (
    "special-veselova-nd",
    "special-rubber-ball-nd",
    "special-chaplygin-ball-nd",
    "special-rubber-ball-on-sphere-nd",
)
TIMES = [0.0, 1.0, 10.0, 30.0]


def distance(system, start):
    """The solution, and its largest distance from the integrated motion."""
    solution = solve(system, start)
    motion = integrate(system, start, TIMES)
    states = solution.states(TIMES)
    assert np.abs(states[-1] - states[0]).max() > 0.05
    return solution, np.abs(states - motion.states).max()


@pytest.mark.slow
@pytest.mark.parametrize("name", SPECIAL)
@pytest.mark.parametrize("seed", [1, 2])
def test_four_dimensions(name, seed):
    solution, error = distance(*random_motion(name, seed))
    assert isinstance(solution, SphereSolution)
    assert error < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize("name", ["special-veselova-nd", "special-chaplygin-ball-nd"])
def test_five_dimensions(name):
    solution, error = distance(*random_motion(name, 5, dimension=5))
    assert isinstance(solution, SphereSolution)
    assert error < 4e-12


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "given"),
    [
        ("veselova-nd", {"moments": [2, 3, 5, 6, 10, 15]}),
        ("rubber-chaplygin-ball-nd", {"moments": [1, 2, 4, 5, 9, 14]}),
        ("chaplygin-ball-nd", {"moments": [1, 1.5, 0.8, 3, 1.25, 2]}),
        ("chaplygin-ball-on-level-nd", {"moments": [1, 1.5, 0.8, 3, 1.25, 2]}),
    ],
)
def test_moments_that_are_products(name, given):
    solution, error = distance(*random_motion(name, 3, **given))
    assert isinstance(solution, SphereSolution)
    assert error < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "still", "given"),
    [
        ("special-veselova-nd", (1,), {}),
        ("special-rubber-ball-on-sphere-nd", (0,), {}),
        ("special-chaplygin-ball-nd", (1, 2), {}),
        ("special-veselova-nd", (1, 2), {}),
        ("veselova-nd", (), {"mass_tensor": np.diag([0.5, 0.7, 0.7, 0.7]).tolist()}),
        ("chaplygin-ball-on-level-nd", (), {"mass_tensor": np.diag([0.7] * 4).tolist()}),
        ("rubber-chaplygin-ball-nd", (), {"mass_tensor": np.diag([0.7] * 4).tolist()}),
    ],
)
def test_motions_on_few_axes(name, still, given):
    _, error = distance(*random_motion(name, 4, still=still, **given))
    assert error < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize("name", [*SPECIAL[:2], SPECIAL[3]])
def test_in_three_dimensions_it_is_the_closed_form_of_the_paper(name):
    system, start = random_motion(name, 6, dimension=3)
    problem = Problem(system, system.defaults, tuple(start))
    with ctx.workprec(BITS):
        operator = operator_of(problem)
        axes = moving_axes(operator, *momentum_and_vector(problem), RESOLUTION)
        general = _on_torus(problem, operator, axes)
    paper = solve(system, start)
    assert isinstance(paper, FewAxesSolution)
    times = [0.0, 3.0, 1e3, 1e5]
    assert np.abs(general.states(times) - paper.states(times)).max() < 1e-10
    assert np.abs(general.states(times[:2]) - paper.states(times[:2])).max() < 1e-13


def test_rest_stays():
    system, start = random_motion("veselova-nd", 0, moments=[2, 3, 5, 6, 10, 15])
    start[:4] = [0.0] * 4
    solution = solve(system, start)
    assert isinstance(solution, RestSolution)
    assert solution.states([0.0, 1e6]) == pytest.approx(np.array([start, start]))


def test_what_is_not_special_is_refused():
    with pytest.raises(NoClosedFormError, match="products"):
        solve(*random_motion("veselova-nd", 0))


def test_two_equal_factors_with_momentum_between_are_refused():
    system, start = random_motion("veselova-nd", 0, moments=[1, 2, 3, 2, 3, 6])
    with pytest.raises(
        NoClosedFormError, match="parallel in the axes 1 and 2, whose a_i are equal"
    ):
        solve(system, start)


@pytest.mark.slow
def test_a_ball_off_the_level_is_refused():
    system, start = random_motion("chaplygin-ball-nd", 0, moments=[0.25] * 6)
    start[0] += 0.1
    with pytest.raises(NoClosedFormError, match="p∧γ"):
        solve(system, start)


@pytest.mark.slow
def test_it_has_no_error_bounds():
    solution = solve(*random_motion("special-veselova-nd", 1))
    with pytest.raises(InputError, match="error bounds"):
        solution.rigorous(1)
    assert solution.form["Omega_3"].unit == "turns/s"
    assert len(solution.form.ovals) == 3
