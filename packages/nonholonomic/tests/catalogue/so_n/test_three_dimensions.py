"""In three dimensions the systems of n dimensions are the ones of the paper."""

from __future__ import annotations

import numpy as np
import pytest

from flowlanes.flow.integrator import integrate
from nonholonomic.catalogue import from_catalogue
from nonholonomic.starts import initial_state

TIMES = np.linspace(0.0, 10.0, 6)
GAMMA = np.array([2.0, -3.0, 6.0]) / 7.0
SPIN = np.array([0.9, -0.5, 0.4])
#: ω_12 = −ω_3, ω_13 = ω_2, ω_23 = −ω_1.
SIGNS = np.array([-1.0, 1.0, -1.0])


def pairs_of(omega):
    """The entries 12, 13, 23 of the skew matrix of ω×."""
    return SIGNS * omega[..., ::-1]


def rotations(quaternions):
    """Matrices from body to space of unit quaternions w, x, y, z."""
    from scipy.spatial.transform import Rotation

    return Rotation.from_quat(np.roll(quaternions, -1, axis=1)).as_matrix()


@pytest.mark.parametrize(
    ("name", "old", "omega", "parameters", "given"),
    [
        (
            "chaplygin-ball-nd",
            "chaplygin-ball",
            SPIN,
            {"I_1": 1.0, "I_2": 1.5, "I_3": 2.1, "m": 1.2, "R": 0.8},
            {"moments": [2.1, 1.5, 1.0], "mass": 1.2, "radius": 0.8},
        ),
        (
            "rubber-chaplygin-ball-nd",
            "rubber-chaplygin-ball",
            SPIN - (SPIN @ GAMMA) * GAMMA,
            {"I_1": 1.0, "I_2": 1.5, "I_3": 2.1, "m": 1.2, "R": 0.8},
            # J = diag(1.3, 0.8, 0.2)
            {
                "mass_tensor": [[1.3, 0.0, 0.0], [0.0, 0.8, 0.0], [0.0, 0.0, 0.2]],
                "mass": 1.2,
                "radius": 0.8,
            },
        ),
        (
            "veselova-nd",
            "veselova",
            SPIN - (SPIN @ GAMMA) * GAMMA,
            {"I_1": 1.0, "I_2": 1.5, "I_3": 2.1},
            {"moments": [2.1, 1.5, 1.0]},
        ),
        (
            # products of inertia I_13, I_23 are −J_13, −J_23
            "suslov-nd",
            "suslov",
            np.array([0.9, -0.5, 0.0]),
            {"I_1": 1.0, "I_2": 1.5, "I_3": 2.1, "I_13": 0.2, "I_23": -0.3},
            {"mass_tensor": [[1.3, 0.0, -0.2], [0.0, 0.8, 0.3], [-0.2, 0.3, 0.2]]},
        ),
    ],
)
def test_three_dimensions_are_the_system_of_the_paper(name, old, omega, parameters, given):
    before = from_catalogue(old, **parameters)
    motion = integrate(before, initial_state(before, omega, GAMMA), TIMES)
    system = from_catalogue(name, dimension=3, **given)
    start = {"gamma": GAMMA, "omega": pairs_of(omega)}
    found = integrate(system, start, TIMES).to_dataset()
    assert np.abs(found["gamma"].values - motion["gamma"]).max() < 2e-14
    assert np.abs(found["omega"].values - pairs_of(motion["omega"])).max() < 4e-14
    assert np.abs(found["attitude"].values - rotations(motion["attitude"])).max() < 4e-14
    assert found["energy"].values[0] == pytest.approx(motion["law_energy"][0], rel=1e-14)
    if "contact" in found:
        assert np.abs(found["contact"].values - motion["contact"][:, :2]).max() < 4e-14
