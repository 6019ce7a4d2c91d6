import numpy as np
import pytest
import sympy as sp

from closed_form.followed_states import GAMMA, OMEGA, miss, solution, without
from flowlanes.system.vectors import to_components
from nonholonomic.closed_form.separations import ball_sphere, bruns, bruns_ball, rubber_sphere
from nonholonomic.starts import initial_state


@pytest.mark.slow
def test_one_fixed_direction() -> None:
    made = solution(bruns.veselova_in_bruns_field(), without(OMEGA, GAMMA), GAMMA)
    assert np.max(miss(made, [1.0, 40.0])) < 2e-14


@pytest.mark.slow
def test_a_path_with_a_third_frequency() -> None:
    moments = np.array([1.0, 1.5, 2.1])
    made = solution(
        bruns_ball.chaplygin_ball_in_bruns_field(), without(OMEGA, GAMMA, moments), GAMMA
    )
    assert np.max(miss(made, [1.0, 40.0])) < 1e-13


@pytest.mark.slow
def test_no_fixed_direction() -> None:
    made = solution(rubber_sphere.hollow_ball(), without(OMEGA, GAMMA), GAMMA)
    assert np.max(miss(made, [1.0, 40.0])) < 1e-13


@pytest.mark.slow
def test_a_ball_around_a_sphere_turns_about_its_momentum() -> None:
    of = ball_sphere.hollow_ball()

    def area(spin: float) -> float:
        """(AM, n), linear in ω."""
        start = initial_state(of.system, (spin, OMEGA[1], OMEGA[2]), tuple(GAMMA))
        known = {**of.system.defaults, **dict(zip(of.system.symbols, start, strict=False))}
        (level,) = (
            to_components(f) for f in of.level if to_components(f).has(of.system.symbols[0])
        )
        return float(level.xreplace({s: sp.Float(str(x), 30) for s, x in known.items()}))

    at_zero, at_one = area(0.0), area(1.0)
    omega = (at_zero / (at_zero - at_one), OMEGA[1], OMEGA[2])
    assert np.max(miss(solution(of, omega, GAMMA), [1.0, 40.0])) < 5e-14
