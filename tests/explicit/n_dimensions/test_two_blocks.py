"""Bodies with the symmetry SO(r)×SO(n − r), against integrated motions."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from chaplygin.catalogue import from_catalogue
from chaplygin.errors import InputError
from chaplygin.explicit import solve
from chaplygin.explicit.n_dimensions.two_blocks import TwoBlockSolution
from chaplygin.flow.integrator import integrate

from .motions import random_motion, state_of

TIMES = [0.0, 1.0, 10.0, 100.0]
MOMENTS = [2, 3, 3, 3, 3, 1]


def distance(system, start):
    solution = solve(system, start)
    assert isinstance(solution, TwoBlockSolution)
    return solution, np.abs(solution.states(TIMES) - integrate(system, start, TIMES).states).max()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "dimension", "given"),
    [
        ("veselova-nd", 4, {"mass_tensor": np.diag([0.5, 0.5, 0.8, 0.8]).tolist()}),
        ("veselova-nd", 5, {"mass_tensor": np.diag([0.5, 0.8, 0.5, 0.8, 0.8]).tolist()}),
        (
            "rubber-chaplygin-ball-nd",
            6,
            {"mass_tensor": np.diag([0.5, 0.5, 0.8, 0.8, 0.5, 0.5]).tolist(), "radius": 0.7},
        ),
        ("veselova-nd", 4, {"moments": MOMENTS}),
    ],
)
def test_random_motions(name, dimension, given):
    solution, error = distance(*random_motion(name, 0, dimension=dimension, **given))
    assert error < 1e-12
    assert len(solution.form.constants) == 7
    with pytest.raises(InputError, match="error bounds"):
        solution.rigorous(1)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("p", "gamma"),
    [
        ([0, 1, 1, 0], [0.6, 0, 0, 0.8]),  # three frequencies
        ([0, 0, 1, 0], [0.6, 0.8, 0, 0]),  # on two lines, through a corner of the sphere
        ([-0.8, 0.6, 0, 0], [0.6, 0.8, 0, 0]),  # in the first block alone
        ([0, 1, 0, 1], [0.6, 0, 0.8, 0]),
        ([0.8, 0, -0.6, 0.5], [0.6, 0, 0.8, 0]),  # one line
    ],
)
def test_motions_in_special_positions(p, gamma):
    system = replace(from_catalogue("veselova-nd", moments=MOMENTS), reconstruction=None)
    _, error = distance(system, state_of(system, np.array(p, float), np.array(gamma)))
    assert error < 1e-12


@pytest.mark.slow
def test_a_wrong_moment_is_seen():
    system, start = random_motion("veselova-nd", 0, moments=MOMENTS)
    other, _ = random_motion("veselova-nd", 0, moments=[2, 3, 3, 3, 3, 1.001])
    states = solve(other, start).states(TIMES)
    assert np.abs(states - integrate(system, start, TIMES).states).max() > 1e-5
