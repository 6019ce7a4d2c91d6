"""Closed forms of the systems of n dimensions for n = 3, against integrated motions."""

from __future__ import annotations

import numpy as np
import pytest

from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from lawproof.proof.prover import prove
from nonholonomic.catalogue import from_catalogue
from nonholonomic.closed_form import solve
from nonholonomic.closed_form.base.no_closed_form import NoClosedFormError

GAMMA = np.array([0.2, -0.3, 0.9]) / np.linalg.norm([0.2, -0.3, 0.9])
TIMES = [0.0, 1.0, 20.0]


def start(twists):
    """γ and an admissible ω."""
    omega = np.array([[0, 0.3, -0.2], [-0.3, 0, 0.7], [0.2, -0.7, 0]])
    if not twists:
        u = omega @ GAMMA
        omega = np.outer(u, GAMMA) - np.outer(GAMMA, u)
    return {"gamma": GAMMA.tolist(), "omega": omega[np.triu_indices(3, 1)].tolist()}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "given"),
    [
        ("veselova-nd", {}),
        ("veselova-nd", {"moments": [1.0, 1.0, 2.0]}),
        ("chaplygin-ball-nd", {"mass": 1.3, "radius": 0.7}),
        ("rubber-chaplygin-ball-nd", {"mass": 1.3, "radius": 0.7}),
        ("rubber-ball-on-sphere-nd", {"a": -0.5}),
    ],
)
def test_the_closed_form_is_the_motion_with_attitude_and_contact(name, given):
    system = from_catalogue(name, dimension=3, **given)
    begin = start(twists=name == "chaplygin-ball-nd")
    solution = solve(system, begin)
    motion = integrate(system, begin, TIMES)
    states = solution.states(TIMES)
    assert solution.system.symbols == motion.system.symbols
    assert np.abs(states - motion.states).max() < 1e-12
    assert np.abs(states[-1] - states[0]).max() > 0.1


@pytest.mark.slow
def test_balls_of_a_rigorous_state_contain_the_one_in_doubles():
    system = from_catalogue("chaplygin-ball-nd", dimension=3)
    solution = solve(system, start(twists=True))
    exact = [float(x) for x in solution.rigorous("1.5", 20)]
    assert solution.states([1.5])[0] == pytest.approx(exact, abs=1e-14)


#: Of a body whose axes are not principal.
TENSOR = [[0.5, 0.1, -0.05], [0.1, 0.7, 0.02], [-0.05, 0.02, 0.9]]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "tensor"),
    [
        ("veselova-nd", TENSOR),
        ("chaplygin-ball-nd", TENSOR),
        ("rubber-chaplygin-ball-nd", TENSOR),
        ("veselova-nd", np.diag([0.5, 0.7, 0.9]).tolist()),
        ("veselova-nd", np.eye(3).tolist()),
        ("chaplygin-ball-nd", np.diag([0.5, 0.5, 0.9]).tolist()),
    ],
)
def test_a_mass_tensor_is_turned_to_its_principal_axes(name, tensor):
    system = from_catalogue(name, mass_tensor=tensor)
    begin = start(twists=name == "chaplygin-ball-nd")
    solution = solve(system, begin)
    motion = integrate(system, begin, TIMES)
    states = solution.states(TIMES)
    assert solution.system.symbols == motion.system.symbols
    assert np.abs(states - motion.states).max() < 1e-12
    if name == "veselova-nd":
        exact = [float(x) for x in solution.rigorous(20, 20)]
        assert states[-1] == pytest.approx(exact, abs=1e-13)


def test_a_mass_tensor_with_equal_eigenvalues_off_its_axes_is_refused():
    tensor = [[0.75, 0.25, 0], [0.25, 0.75, 0], [0, 0, 1]]
    with pytest.raises(InputError, match="coincide"):
        solve(from_catalogue("veselova-nd", mass_tensor=tensor), start(twists=False))


@pytest.mark.parametrize("given", [{"dimension": 4}])
def test_what_is_not_solved_is_refused(given):
    system = from_catalogue("veselova-nd", **given)
    state = {
        "p": [0.0] * len(system.state[0].symbols),
        "gamma": [1.0, *[0.0] * 9][: given.get("dimension", 3)],
    }
    with pytest.raises(NoClosedFormError):
        solve(system, state)


@pytest.mark.slow
@pytest.mark.parametrize(
    "name", ["veselova-nd", "chaplygin-ball-nd", "chaplygin-ball-on-sphere-nd"]
)
def test_they_are_the_systems_of_the_paper(name):
    assert prove(from_catalogue(name, dimension=3), "three_dimensions").decision == "proven"
