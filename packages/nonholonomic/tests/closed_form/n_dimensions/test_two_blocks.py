"""Bodies with the symmetry SO(r)×SO(n − r), against integrated motions."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from closed_form.n_dimensions.motions import random_motion, state_of
from flowlanes.flow.integrator import integrate
from nonholonomic.catalogue import from_catalogue
from nonholonomic.closed_form import solve
from nonholonomic.closed_form.base.no_closed_form import NoClosedFormError
from nonholonomic.closed_form.n_dimensions.two_blocks_solution import Planes, SteadyTurning
from nonholonomic.closed_form.one_degree.solution import QuadratureSolution

TIMES = [0.0, 1.0, 10.0, 30.0]
MOMENTS = [2, 3, 3, 3, 3, 1]
HALF = {"mass_tensor": np.diag([0.5, 0.5, 0.8, 0.8]).tolist()}
NO_BODY = [0.5, 0.5, 1.1, 1.1, 1.1, 0.5, 1.1, 1.1, 1.1, 1.1, 1.1, 1.1, 1.9, 1.9, 1.9]


def distance(system, start):
    """The solution, and its largest distance from the integrated motion."""
    solution = solve(system, start)
    motion = integrate(system, start, TIMES).states
    error = np.abs(solution.states(TIMES) - motion).max()
    balls = solution.rigorous(TIMES[-1], 20)
    assert all(x.rad() < 1e-25 for x in balls)
    exact = np.array([float(x.mid()) for x in balls])
    return solution, max(error, np.abs(exact - motion[-1]).max())


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "dimension", "given"),
    [
        ("veselova-nd", 4, HALF),
        ("veselova-nd", 5, {"mass_tensor": np.diag([0.5, 0.8, 0.5, 0.8, 0.8]).tolist()}),
        (
            "rubber-chaplygin-ball-nd",
            6,
            {"mass_tensor": np.diag([0.5, 0.5, 0.8, 0.8, 0.5, 0.5]).tolist(), "radius": 0.7},
        ),
        ("veselova-nd", 4, {"moments": MOMENTS}),
        # 1/2ε = 3/2: a half power; −1/2; a power that is no half one; a body with three equal axes
        ("rubber-ball-on-sphere-nd", 4, {**HALF, "a": 0.5}),
        ("rubber-ball-on-sphere-nd", 4, {**HALF, "a": -0.5}),
        ("rubber-ball-on-sphere-nd", 4, {**HALF, "a": 0.37}),
        ("rubber-ball-on-sphere-nd", 4, {**HALF, "a": -1.7}),
        (
            "rubber-ball-on-sphere-nd",
            5,
            {"mass_tensor": np.diag([0.5, 0.5, 0.5, 0.8, 0.5]).tolist(), "a": 0.6},
        ),
        (
            "rubber-ball-on-sphere-nd",
            6,
            {"moments": NO_BODY, "a": 0.6, "mass": 1.3, "radius": 0.8},
        ),
    ],
)
def test_random_motions(name, dimension, given):
    solution, error = distance(*random_motion(name, 0, dimension=dimension, **given))
    assert isinstance(solution, QuadratureSolution)
    assert isinstance(solution.frame, Planes)
    assert error < 1e-12
    assert solution.form["Omega"].unit == "turns/s"


@pytest.mark.slow
@pytest.mark.parametrize("a", [None, 0.6, -0.5, -1.7])
@pytest.mark.parametrize(
    ("p", "gamma", "kind"),
    [
        ([0, 1, 1, 0], [0.6, 0, 0, 0.8], QuadratureSolution),  # three frequencies
        ([0, 0, 1, 0], [0.6, 0.8, 0, 0], QuadratureSolution),  # on two lines, through a corner
        ([-0.8, 0.6, 0, 0], [0.6, 0.8, 0, 0], SteadyTurning),  # in the first block alone
        ([0, 0, 0.3, 0.4], [0, 0, 0.8, -0.6], SteadyTurning),  # in the second alone
        ([0, 1, 0, 1], [0.6, 0, 0.8, 0], QuadratureSolution),
        ([0.8, 0, -0.6, 0.5], [0.6, 0, 0.8, 0], QuadratureSolution),  # one line
        ([0, 0, 1, 0], [1, 0, 0, 0], QuadratureSolution),  # from a corner
    ],
)
def test_motions_in_special_positions(p, gamma, kind, a):
    name = "veselova-nd" if a is None else "rubber-ball-on-sphere-nd"
    given = {} if a is None else {"a": a}
    system = replace(from_catalogue(name, moments=MOMENTS, **given), reconstruction=None)
    solution, error = distance(system, state_of(system, np.array(p, float), np.array(gamma)))
    assert isinstance(solution, kind)
    assert error < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "given"), [("veselova-nd", {}), ("rubber-ball-on-sphere-nd", {"a": 0.6})]
)
def test_a_wrong_moment_is_seen(name, given):
    system, start = random_motion(name, 0, moments=MOMENTS, **given)
    other, _ = random_motion(name, 0, moments=[2, 3, 3, 3, 3, 1.001], **given)
    states = solve(other, start).states(TIMES)
    assert np.abs(states - integrate(system, start, TIMES).states).max() > 1e-6


def test_bounds_at_a_far_time_contain_the_double():
    solution = solve(*random_motion("rubber-ball-on-sphere-nd", 0, **HALF, a=0.37))
    balls = solution.rigorous("1e9", 25)
    assert all(x.rad() < 1e-20 for x in balls)
    assert solution.states([1e9])[0] == pytest.approx([float(x.mid()) for x in balls], abs=1e-6)


def test_other_moments_on_a_sphere_are_refused_with_what_is_solvable():
    moments = [0.5, 1.1, 1.6, 2.3, 0.9, 1.4]
    with pytest.raises(NoClosedFormError, match=r"SO\(r\)×SO\(n − r\)"):
        solve(*random_motion("rubber-ball-on-sphere-nd", 0, moments=moments, a=0.6))
