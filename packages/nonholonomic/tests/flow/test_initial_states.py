"""Many starts at once, by name."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from flowlanes.errors import InputError
from flowlanes.flow.batch import batch_integrator
from flowlanes.flow.gauss import gauss_integrator
from flowlanes.flow.initial_states import flat_starts, reduced_start, whole_start
from flowlanes.flow.integrator import integrate
from flowlanes.lyapunov.spectrum import lyapunov_spectrum
from nonholonomic.catalogue import from_catalogue
from nonholonomic.closed_form.solver import solve
from nonholonomic.mechanics.conventions import BodyConventions
from nonholonomic.mechanics.rotations import upright
from nonholonomic.starts import initial_state

OMEGA = np.array([[0.7, 0.4, 1.1], [-1.0, 2.0, 0.1], [0.0, 0.0, 3.0]])
GAMMA = np.array([[0.2, -0.3, 0.93], [0.0, 0.0, 2.0], [1.0, 1.0, 1.0]])
BALL = from_catalogue("chaplygin-ball")


@pytest.mark.parametrize("name", ["chaplygin-ball", "unbalanced-ball", "rattleback", "veselova"])
def test_as_single_starts_with_fifty_digits(name: str) -> None:
    system = from_catalogue(name)
    omega = OMEGA
    if name == "veselova":
        up = GAMMA / np.linalg.norm(GAMMA, axis=1, keepdims=True)
        omega = OMEGA - np.sum(OMEGA * up, axis=1, keepdims=True) * up
    found = flat_starts(system, {"omega": omega, "gamma": GAMMA})
    for row, spin, up in zip(found, omega, GAMMA, strict=True):
        wanted = initial_state(system, spin.tolist(), up.tolist())[: len(system.symbols)]
        assert np.allclose(row, np.array(wanted, dtype=float), rtol=1e-14, atol=1e-15)


def test_parameters_count() -> None:
    masses = np.array([1.0, 2.0, 3.0])
    found = flat_starts(BALL, {"omega": OMEGA, "gamma": GAMMA}, {"m": masses})
    for i, mass in enumerate(masses):
        alone = flat_starts(
            BALL, {"omega": OMEGA[i : i + 1], "gamma": GAMMA[i : i + 1]}, {"m": mass}
        )
        assert np.array_equal(found[i], alone[0])


def test_numbers_of_numpy_are_decimals_too() -> None:
    """In a list they are NumPy's own scalars, which print themselves with their type."""
    state = flat_starts(BALL, {"omega": OMEGA[:1], "gamma": GAMMA[:1]})[0]
    assert whole_start(BALL, list(state)) == whole_start(BALL, state.tolist())


def test_by_variables_and_by_components() -> None:
    whole = np.arange(12.0).reshape(2, 6)
    named = {"gamma": whole[:, 3:], "M": whole[:, :3]}
    single = {"gamma": whole[:, 3:], **{f"M_{i + 1}": whole[:, i] for i in range(3)}}
    for given in ({"state": whole}, named, single):
        assert np.array_equal(flat_starts(BALL, given), whole)


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        ({"M": OMEGA}, "the start does not tell gamma_1, gamma_2, gamma_3"),
        ({"omega": OMEGA}, "omega is given, but gamma is not"),
        (
            {"M": OMEGA, "gamma": GAMMA, "mass": OMEGA[:, 0]},
            "there is no mass; its state has M",
        ),
        (
            {"M": OMEGA[:, :2], "gamma": GAMMA},
            r"M has 2 numbers for each motion, not 3",
        ),
        ({"state": OMEGA}, r"state has 3 numbers for each motion, not 6"),
        ({"omega": OMEGA, "gamma": 0 * GAMMA}, "gamma is zero"),
    ],
    ids=["missing", "no-gamma", "unknown", "shape", "state", "zero"],
)
def test_mistakes_are_told(given: dict[str, Any], sentence: str) -> None:
    with pytest.raises(InputError, match=f"^chaplygin-ball: {sentence}"):
        flat_starts(BALL, given)


def test_a_state_that_does_not_follow_from_omega() -> None:
    with pytest.raises(InputError, match="its state does not follow from omega; give the state"):
        flat_starts(replace(BALL, conventions=BodyConventions()), {"omega": OMEGA, "gamma": GAMMA})


NAMES = {"omega": (0.7, 0.4, 1.1), "gamma": (0.2, -0.3, 0.93)}


def _ways() -> list[Any]:
    """One start with its motion in space, without it, by names, and by variables."""
    whole = initial_state(BALL, NAMES["omega"], NAMES["gamma"])
    state = [float(x) for x in whole[:6]]
    return [whole, state, NAMES, {"M": state[:3], "gamma": state[3:]}]


def test_a_start_is_the_same_in_every_way() -> None:
    found = [np.array(reduced_start(BALL, way), dtype=float) for way in _ways()]
    for other in found[1:]:
        assert np.abs(other - found[0]).max() < 1e-15
    lifted = [np.array(whole_start(BALL, way), dtype=float) for way in _ways()]
    for other in lifted[1:]:
        assert np.abs(other[:-2] - lifted[0][:-2]).max() < 1e-15


@pytest.mark.slow
def test_every_door_takes_every_start() -> None:
    ends, exponents, solved = [], [], []
    for way in _ways():
        ends.append(integrate(BALL, way, [0.0, 1.0])["M"][-1])
        exponents.append(lyapunov_spectrum(BALL, way, t_end=20.0).values)
        solved.append(solve(BALL, way)(1.0)["M"][0])
    for found in (ends, exponents, solved):
        for other in found[1:]:
            assert np.abs(other - found[0]).max() < 1e-12
    whole = [[float(x) for x in _ways()[0]]]
    machine = batch_integrator(BALL)
    assert np.array_equal(
        machine.propagate(whole, [1.0]).states, machine.propagate([whole[0][:6]], [1.0]).states
    )
    assert (
        np.abs(
            gauss_integrator(BALL, whole[0]).propagate(whole, [1.0]).states[0, 0, :3] - ends[0]
        ).max()
        < 1e-12
    )


def test_a_start_of_another_size() -> None:
    with pytest.raises(
        InputError, match=r"^start has 7 numbers: 6 are needed \(M_1, .*; or 12, wi"
    ):
        integrate(BALL, [1.0] * 7, [0.0, 1.0])
    with pytest.raises(InputError, match="there is no spin; its state has M"):
        integrate(BALL, {"spin": 1.0}, [0.0, 1.0])


def test_upright() -> None:
    assert [float(x) for x in upright([0.0, 0.0, 1.0])] == [1.0, 0.0, 0.0, 0.0]
    assert [float(x) for x in upright([0.0, 0.0, -1.0])] == [0.0, 1.0, 0.0, 0.0]
