"""Suslov's problem of n dimensions in elementary functions, against integrated motions."""

from __future__ import annotations

import numpy as np
import pytest

from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from nonholonomic.catalogue import from_catalogue
from nonholonomic.closed_form import solve
from nonholonomic.closed_form.base.no_closed_form import NoClosedFormError
from nonholonomic.closed_form.n_dimensions.suslov import PlanarTurning, UniformTurning

TIMES = [0.0, 1.0, 10.0, 40.0]
SKEWED = [[0.5, 0, 0, 0.1], [0, 0.7, 0, 0], [0, 0, 0.9, 0], [0.1, 0, 0, 1.1]]
ROUND = [[0.7, 0, 0, 0.1], [0, 0.7, 0, 0.2], [0, 0, 0.7, 0], [0.1, 0.2, 0, 1.1]]


def motion(w, seed=0, **given):
    """The system and a lifted state with a random attitude."""
    system = from_catalogue("suslov-nd", **given)
    n = len(w) + 1
    attitude, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(n, n)))
    return system, [*w, *attitude[-1].tolist(), *attitude.ravel().tolist()]


def distance(system, start):
    solution = solve(system, start)
    states = solution.states(TIMES)
    followed = integrate(system, start, TIMES)
    assert solution.system.symbols == followed.system.symbols
    return solution, np.abs(states - followed.states).max()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("w", "given"),
    [
        ([0.3, 0.5, 0.2], {"moments": [1, 2, 1.5, 2.2, 1.1, 1.7]}),
        ([0.3, 0.5, 0.2, -0.6], {"moments": [1.0] * 10}),
        ([0.3, 0.5, 0.2], {"mass_tensor": np.diag([0.5, 0.7, 0.9, 1.1]).tolist()}),
        ([-0.3, 0.0, 0.0], {"mass_tensor": SKEWED}),
        ([0.0, 0.0, 0.0], {"mass_tensor": SKEWED}),
    ],
)
def test_w_is_constant(w, given):
    solution, error = distance(*motion(w, **given))
    assert isinstance(solution, UniformTurning)
    assert error < 1e-13
    exact = [float(x) for x in solution.rigorous(40, 20)]
    assert solution.states([40.0])[0] == pytest.approx(exact, abs=1e-14)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("w", "tensor"),
    [
        ([0.3, 0.5, 0.0], SKEWED),
        ([-0.3, 0.0, 0.4], SKEWED),
        ([0.3, 0.5, 0.4], ROUND),
        ([0.6, -0.2], [[0.5, 0.1, 0.05], [0.1, 0.7, 0.02], [0.05, 0.02, 0.9]]),
        ([0.3, 0.5], [[0.5, 0, 0.1], [0, 0.7, 0], [0.1, 0, 0.9]]),
    ],
)
def test_w_stays_in_a_plane(w, tensor):
    system, start = motion(w, mass_tensor=tensor)
    solution, error = distance(system, start)
    assert isinstance(solution, PlanarTurning)
    assert error < 3e-12
    # a wrong rate of approach is seen
    wrong = solution._velocity(1.001 * np.array(TIMES))
    assert np.abs(wrong - solution._velocity(np.array(TIMES))).max() > 1e-6
    with pytest.raises(InputError, match="error bounds"):
        solution.rigorous(1)


@pytest.mark.slow
def test_it_ends_in_the_opposite_rotation():
    system, start = motion([0.3, 0.5, 0.0], mass_tensor=SKEWED)
    solution = solve(system, start)
    first, last = solution.states([-1e7, 1e7])
    assert last[0] == pytest.approx(-first[0])
    assert first[0] > 0
    assert last[1:3] == pytest.approx([0, 0], abs=1e-14)
    assert np.linalg.norm(last[3:7]) == pytest.approx(1)


def test_other_planes_are_refused():
    with pytest.raises(NoClosedFormError, match="invariant"):
        solve(*motion([0.3, 0.5, 0.4], mass_tensor=SKEWED))
