"""Frames of deviations, and what they exclude."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings, strategies as st

from flowlanes.flow.batch import batch_integrator
from flowlanes.flow.linearisation.tangent_space import TangentSpace, orthonormal, propagate
from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol, to_components
from nonholonomic.catalogue import from_catalogue

x, y, z = map(real_symbol, "xyz")
LINEAR = System("linear", "Linear", {x: x / 5 + y, y: -y, z: -3 * z / 10})
WHOLE = TangentSpace(LINEAR, (), (), np.zeros((0, 0)))


def _ball() -> tuple[TangentSpace, np.ndarray]:
    system = from_catalogue("chaplygin-ball")
    laws = {law.name: to_components(law.value) for law in system.integrals}
    conditions = (to_components(system.relations[0]), laws["energy"], laws["area"])
    states = np.random.default_rng(5).standard_normal((7, 6))
    states[:, 3:] /= np.linalg.norm(states[:, 3:], axis=1)[:, None]
    return TangentSpace(system, conditions, (system.rates,), np.eye(1)), states


@settings(max_examples=40)
@given(st.integers(1, 5), st.floats(-12, 12), st.integers(0, 10**6))
def test_frames_are_orthonormal_to_rounding(count: int, power: float, seed: int) -> None:
    vectors = np.random.default_rng(seed).standard_normal((3, count, 6))
    vectors[:, 0] *= 10**power
    vectors[:, -1] += 1e6 * vectors[:, 0] / 10**power
    frames, lengths = orthonormal(vectors)
    products = np.einsum("nik,njk->nij", frames, frames)
    assert np.abs(products - np.eye(count)).max() < 1e-14
    assert (lengths > 0).all()


def test_lengths_are_the_diagonal_of_a_qr_decomposition() -> None:
    vectors = np.random.default_rng(1).standard_normal((4, 3, 5))
    _, lengths = orthonormal(vectors)
    for vector, length in zip(vectors, lengths, strict=True):
        triangle = np.linalg.qr(vector.T, mode="r")
        assert length == pytest.approx(np.abs(np.diag(triangle)), rel=1e-12)


def test_dependent_vectors_become_zero() -> None:
    one = np.array([1.0, 2.0, 3.0])
    frames, lengths = orthonormal(np.array([[one, 2 * one, [0.0, 1.0, 0.0]]]))
    assert (frames[0, 1] == 0).all()
    assert lengths[0, 1] == 0
    assert np.linalg.norm(frames[0, 2]) == pytest.approx(1)


def test_a_failed_motion_stays_alone() -> None:
    vectors = np.random.default_rng(2).standard_normal((2, 2, 4))
    alone, _ = orthonormal(vectors[1:])
    vectors[0] = np.nan
    frames, lengths = orthonormal(vectors)
    assert np.isnan(frames[0]).all()
    assert np.isnan(lengths[0]).all()
    assert np.array_equal(frames[1], alone[0])


def test_frames_keep_to_what_counts() -> None:
    space, states = _ball()
    frames = space.frames(states)
    assert frames.shape == (7, 2, 6) == (7, space.dimension, 6)
    for vectors in (space.normals(states), space.fields(states)):
        across = np.einsum("nik,njk->nij", frames, vectors)
        assert np.abs(across).max() < 1e-13 * np.abs(vectors).max()


def test_frames_of_a_state_do_not_depend_on_others() -> None:
    space, states = _ball()
    together = space.frames(states)
    assert all(
        np.array_equal(space.frames(states[i : i + 1])[0], together[i]) for i in range(len(states))
    )


def test_divergence_on_the_phase_space() -> None:
    # ẋ = −x off the circle is no divergence of the motion on it
    r = sp.sqrt(x**2 + y**2)
    system = System("circle", "Circle", {x: -y - x * (r - 1), y: x - y * (r - 1), z: z * x})
    space = TangentSpace(system, (), (), np.zeros((0, 0)))
    states = np.array([[0.6, 0.8, 0.3], [-0.8, 0.6, 1.0]])
    on_circle = space.divergence(states, None, [x**2 + y**2 - 1])
    assert on_circle == pytest.approx(states[:, 0], abs=1e-12)
    assert space.divergence(states) == pytest.approx(states[:, 0] - 1, abs=1e-12)


def test_deviations_grow_as_the_equations_say() -> None:
    flow = batch_integrator(LINEAR, deviations=3)
    stretches = propagate(flow, WHOLE, np.array([[1.0, 0.5, 0.2]]), 0.5)
    lengths = np.array([next(stretches).lengths[0] for _ in range(48)])
    assert lengths.sum(axis=1) == pytest.approx(np.full(48, 0.5 * (0.2 - 1 - 0.3)), rel=1e-9)
    assert lengths[-1] / 0.5 == pytest.approx([0.2, -0.3, -1.0], abs=1e-4)


def test_inner_times_are_those_asked_for() -> None:
    flow = batch_integrator(LINEAR, deviations=1)
    nodes = np.array([0.25, 0.5])
    stretch = next(propagate(flow, WHOLE, np.array([[1.0, 0.0, 1.0]]), 1.0, nodes=nodes))
    assert stretch.states[0, :, 0] == pytest.approx(np.exp(0.2 * nodes), rel=1e-12)
    assert stretch.ends[0, 2] == pytest.approx(np.exp(-0.3), rel=1e-12)
