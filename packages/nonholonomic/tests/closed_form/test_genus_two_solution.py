from functools import cache

import numpy as np
import pytest
from flint import arb

from closed_form.followed_states import GAMMA, OMEGA, miss, solution, unit, without
from flowlanes.errors import InputError
from nonholonomic.closed_form.genus_two.curve import DegenerateError
from nonholonomic.closed_form.genus_two_solution import GenusTwo, solve_on_torus
from nonholonomic.closed_form.separations.chaplygin_ball import chaplygin_ball
from nonholonomic.closed_form.separations.veselova import veselova
from nonholonomic.starts import initial_state


@cache
def turning_body() -> GenusTwo:
    return solution(veselova(), without(OMEGA, GAMMA), GAMMA)


@pytest.mark.slow
def test_states_agree_with_thirty_four_digits() -> None:
    assert np.max(miss(turning_body(), [1.0, 10.0, 100.0])) < 2e-14


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
def test_random_bodies_in_any_order_of_the_moments(seed: int) -> None:
    rng = np.random.default_rng(seed)
    moments = rng.permutation(rng.uniform(1, 2, 3))
    gamma = unit(rng.normal(size=3))
    omega = without(rng.normal(size=3), gamma)
    numbers = {f"I_{i}": float(x) for i, x in enumerate(moments, 1)}
    assert np.max(miss(solution(veselova(), omega, gamma, numbers), [3.0, 50.0])) < 1e-13


@pytest.mark.slow
def test_a_path_in_space() -> None:
    moments = np.array([1.0, 1.5, 2.1])
    made = solution(chaplygin_ball(), without(OMEGA, GAMMA, moments), GAMMA)
    assert np.max(miss(made, [1.0, 40.0])) < 5e-14


@pytest.mark.slow
@pytest.mark.parametrize("gamma", [(1, 0, 0), (0.6, 0, 0.8), (0, 0, -1)], ids=str)
def test_components_that_vanish_at_the_start(gamma: tuple[float, ...]) -> None:
    vertical = np.array(gamma)
    made = solution(veselova(), without(OMEGA, vertical), vertical)
    assert np.max(miss(made, [5.0])) < 1e-14


@pytest.mark.slow
@pytest.mark.parametrize("distance", [1e-2, 1e-4, 1e-6])
def test_near_a_separatrix(distance: float) -> None:
    gamma = unit([0.6, distance, 0.8])
    omega = without(np.array([0.3 * distance, 1.0, 0.0]), gamma)
    made = solution(veselova(), omega, gamma)
    # the motion itself loses digits near the unstable rotation
    assert np.max(miss(made, [10.0])) < 1e-13


def test_later_times_cost_no_accuracy() -> None:
    made = turning_body()
    step = 1.0
    late = made.states(np.array([1e9, 1e9 + step]))
    motion = solve_on_torus(made.separable, made.parameters, tuple(late[0]))
    assert motion.states(np.array([step]))[0] == pytest.approx(late[1], abs=1e-13)


def test_figures_have_error_bounds() -> None:
    found = {figure.symbol: figure.value for figure in turning_body().form.constants}
    assert all(isinstance(value, arb) for value in found.values())
    assert found["V_1/V_2"].rad() < arb("1e-60")
    roots = [found[f"e_{i}"] for i in range(1, 6)]
    assert roots == sorted(roots, key=lambda root: root.mid())
    for (low, high), first in zip(turning_body().form.ovals, (1, 3), strict=True):
        assert low < high
        assert first


def test_a_permanent_rotation_is_degenerate() -> None:
    system = veselova().system
    start = initial_state(system, (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    with pytest.raises(DegenerateError):
        solve_on_torus(veselova(), system.defaults, start)


def test_a_start_off_the_level_is_told() -> None:
    of = chaplygin_ball()
    start = initial_state(of.system, (1.0, 0.2, 0.3), (0.0, 0.6, 0.8))
    with pytest.raises(InputError, match="misses the constraints by"):
        solve_on_torus(of, of.system.defaults, start)


def test_a_start_that_is_too_short_is_told() -> None:
    with pytest.raises(InputError, match=r"it has 2 numbers; .* needs 10"):
        solve_on_torus(veselova(), veselova().system.defaults, (0.0, 1.0))


def test_times_that_are_no_numbers_are_refused() -> None:
    with pytest.raises(InputError, match="times: all of them must be finite numbers"):
        turning_body()([0.0, float("nan")])


@pytest.mark.parametrize("time", [1e300, -1e14], ids=str)
def test_times_at_which_doubles_lose_the_phase_are_refused(time: float) -> None:
    with pytest.raises(InputError, match="in double precision they must be within"):
        turning_body()([0.0, time])
