"""Attitude and path along closed forms of n dimensions."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.stats import special_ortho_group

from catalogue.so_n import unreduced
from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from nonholonomic.catalogue import from_catalogue
from nonholonomic.closed_form import solve
from nonholonomic.closed_form.n_dimensions.linear_motion import LinearMotion
from nonholonomic.closed_form.n_dimensions.motion_in_space import MotionInSpace

MASS, RADIUS = 1.3, 0.8
D = MASS * RADIUS**2


def products(n, rng, ball=False):
    """Moments whose K_ij are products, not all of a body."""
    a = rng.permutation(np.linspace(0.35, 0.75, n) if ball else np.linspace(0.9, 1.9, n)).round(2)
    K = [a[i] * a[j] for i, j in unreduced.planes(n)]
    return {"factors": a.tolist()}, [D * x / (D - x) if ball else x for x in K]


def state(system, p, g, contact=0):
    """A lifted state with the momentum p across the last row of g."""
    gamma = g[-1]
    p = p - (p @ gamma) * gamma
    k = np.outer(p, gamma) - np.outer(gamma, p)
    first = p if str(system.state[0]) == "p" else k[np.triu_indices(len(g), 1)]
    return [*first, *gamma, *g.ravel(), *np.zeros(contact)]


def block(system, states, name):
    places = {str(x): slice(place.start, place.stop) for x, place in system.slices}
    return states[:, places[name]]


@pytest.mark.slow
@pytest.mark.parametrize("n", [4, 5])
@pytest.mark.parametrize(
    "name", ["special-veselova-nd", "special-rubber-ball-nd", "special-chaplygin-ball-nd"]
)
def test_the_motion_in_space_is_that_of_the_body_with_all_reactions(name, n):
    rng = np.random.default_rng(n)
    given, moments = products(n, rng, ball="chaplygin" in name)
    rolls = "ball" in name
    if name == "special-rubber-ball-nd":
        moments = [x - 0.5 for x in moments]
        given |= {"mass": 0.5, "radius": 1.0}
    elif rolls:
        given |= {"mass": MASS, "radius": RADIUS}
    system = from_catalogue(name, dimension=n, **given)
    g = special_ortho_group.rvs(n, random_state=rng)
    start = state(system, rng.normal(size=n), g, n - 1 if rolls else 0)
    times = [0.0, 4.0, 10.0]
    solution = solve(system, start)
    assert isinstance(solution, MotionInSpace)
    motion = solution(times)
    reduced = integrate(system, start, times)
    omega = reduced["omega"][0]
    inertia = unreduced.operator_of_moments(moments, n)
    R = given.get("radius", 0.0)
    body = (
        unreduced.marble_ball(n, inertia, MASS, R)
        if "chaplygin" in name
        else unreduced.rubber_ball(n, inertia, 0.5, R)
        if rolls
        else unreduced.veselova(n, inertia)
    )
    velocity = R * (g @ unreduced.skew(omega, n) @ g[-1])
    attitude, _, centre = body.motion(g, omega, velocity, times)
    assert np.abs(motion["attitude"].reshape(-1, n, n) - attitude).max() < 1e-10
    if rolls:
        assert np.abs(motion["contact"] - centre[:, : n - 1]).max() < 1e-10
        assert np.abs(centre).max() > 0.1


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "given"),
    [
        ("special-rubber-ball-on-sphere-nd", {}),
        ("chaplygin-ball-nd", {"moments": [1, 1.5, 0.8, 3, 1.25, 2]}),
        ("rubber-chaplygin-ball-nd", {"mass_tensor": np.diag([0.5, 0.8, 0.5, 0.8]).tolist()}),
        ("veselova-nd", {"mass_tensor": np.diag([0.5, 0.7, 0.7, 0.7]).tolist()}),
    ],
)
def test_the_motion_in_space_is_the_integrated_one(name, given):
    rng = np.random.default_rng(0)
    system = from_catalogue(name, dimension=4, **given)
    places = len(system.lifted().symbols) - len(system.symbols) - 16
    start = state(system, rng.normal(size=4), special_ortho_group.rvs(4, random_state=rng), places)
    solution = solve(system, start)
    for times in ([0.0, 30.0], [0.0, -7.0]):
        error = np.abs(solution.states(times) - integrate(system, start, times).states).max()
        assert error < 1e-12
    far = solution(1e4)
    attitude = far["attitude"][0].reshape(4, 4)
    assert np.abs(attitude @ attitude.T - np.eye(4)).max() < 1e-11
    if "sphere" not in name:
        assert np.abs(attitude[-1] - far["gamma"][0]).max() < 1e-10


@pytest.mark.slow
def test_beyond_its_steps_the_attitude_is_left_open():
    system = from_catalogue("special-veselova-nd")
    g = special_ortho_group.rvs(4, random_state=1)
    solution = solve(system, state(system, np.ones(4), g))
    far = solution([1.0, 1e7])
    assert np.isfinite(far["gamma"]).all()
    assert np.isfinite(far["attitude"][0]).all()
    assert np.isnan(far["attitude"][1]).all()
    assert "steps" in solution.not_rigorous


def test_bounds_hold_for_momentum_and_direction_alone():
    system = from_catalogue("special-veselova-nd", factors=[0.8, 1.1, 1.4, 1.7])
    g = np.eye(4)[[0, 1, 3, 2]]
    balls = solve(system, state(system, np.array([0.3, 0.2, 0, 0]), g)).rigorous(3, 20)
    assert len(balls) == 24
    assert all(x.rad() < 1e-18 for x in balls[:8])
    assert not any(x.is_finite() for x in balls[8:])


def test_an_attitude_that_is_no_rotation_is_refused():
    system = from_catalogue("special-veselova-nd")
    start = state(system, np.zeros(4), np.eye(4))
    with pytest.raises(InputError, match="orthogonal"):
        solve(system, [*start[:-16], *(1.1 * np.array(start[-16:]))])


def test_a_uniform_turn_and_a_known_path():
    speed, plane = 1.7, np.array([[0, 1.0, 0], [-1, 0, 0], [0, 0, 0]])

    def rates(x):
        return np.tile(speed * plane, (len(x), 1, 1)), np.tile([1.0, 0, 0], (len(x), 1))

    x = np.array([40.0, 0.0, -3.0])
    turns, paths = LinearMotion(rates, 3).at(x)
    cosine, sine = np.cos(speed * x), np.sin(speed * x)
    assert turns[:, 0, 0] == pytest.approx(cosine, abs=1e-13)
    assert turns[:, 0, 1] == pytest.approx(sine, abs=1e-13)
    assert paths[:, 0] == pytest.approx(sine / speed, abs=1e-13)
    assert paths[:, 1] == pytest.approx((cosine - 1) / speed, abs=1e-13)
