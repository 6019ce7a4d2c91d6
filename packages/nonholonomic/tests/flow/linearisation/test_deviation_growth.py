"""Deviations made orthonormal by the loop itself: as it is done with arrays, on every device."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import islice
from typing import Any

import numpy as np
import pytest

from flow.devices.ptx_machine import PtxMachine
from flow.small import OSCILLATOR, TOP, body, starts
from flowlanes.flow.batch import batch_integrator
from flowlanes.flow.devices.graphics import GraphicsLoop, graphics_loop
from flowlanes.flow.kernel.projection_terms import dot
from flowlanes.flow.linearisation import deviation_growth as module
from flowlanes.flow.linearisation.deviation_growth import (
    DeviationGrowth,
    Vector,
    deviation_growth,
    orthonormal_terms,
)
from flowlanes.flow.linearisation.state_scales import state_scales
from flowlanes.flow.linearisation.tangent_space import TangentSpace, orthonormal, propagate
from flowlanes.formulas.array_evaluation import numbers
from flowlanes.formulas.graph import Graph, Term
from flowlanes.lyapunov.indicators import tangent, transverse_space

TIMES = np.linspace(0.0, 5.0, 11)[1:]


def growth_of(space: TangentSpace, deviations: int, device: Any = "cpu") -> DeviationGrowth:
    """The lengths that deviations lose, and no further numbers."""
    return deviation_growth(
        space,
        deviations,
        orthonormal_terms,
        lambda graph, frames: (),
        tolerance=1e-13,
        device=device,
    )


def test_vectors_made_orthonormal() -> None:
    graph, size = Graph(), 5
    values = np.random.default_rng(4).normal(size=(40, 4, size))
    values[10:, 2] = 2 * values[10:, 0] - values[10:, 1]
    values[20:, 1] = 0.0
    basis = [[graph.state(i) for i in range(size)]]
    rest = [[graph.state(size * k + i) for i in range(size)] for k in range(1, 4)]
    normals, _ = orthonormal_terms(graph, basis)
    frames, lengths = orthonormal_terms(graph, rest, normals)
    terms = [*lengths, *(x for frame in frames for x in frame)]
    found = numbers(terms, values.reshape(40, -1), np.empty(0))
    right_frames, right_lengths = orthonormal(values[:, 1:], orthonormal(values[:, :1])[0])
    assert (right_lengths == 0).any()
    np.testing.assert_allclose(found[:, :3], right_lengths, rtol=1e-12)
    np.testing.assert_allclose(found[:, 3:].reshape(40, 3, size), right_frames, atol=1e-11)


@pytest.mark.parametrize("name", ["chaplygin-ball", "unbalanced-ball", "rattleback"])
@pytest.mark.parametrize("measure", [tangent, transverse_space])
def test_as_with_arrays(name: str, measure: Any) -> None:
    system = body(name)
    space = measure(system)
    states = starts(name, 6)
    sizes = state_scales(system, states, TIMES[-1])
    found = growth_of(space, min(space.dimension, 3)).run(states, sizes, TIMES)
    lanes = batch_integrator(system, tolerance=1e-13, deviations=min(space.dimension, 3))
    stretches = islice(propagate(lanes, space, states, TIMES[0], sizes=sizes), len(TIMES))
    right = np.stack([stretch.lengths for stretch in stretches], axis=1)
    np.testing.assert_allclose(np.log(found.lengths), right, atol=1e-9)
    assert found.outcome.tolist() == [0] * 6
    assert found.end_times.tolist() == [TIMES[-1]] * 6
    assert found.records.shape == (6, len(TIMES), 0)


def test_parameters_of_each_motion() -> None:
    states = np.array([[1.0, 0.0]] * 3)
    values, sizes = {"p": np.array([1.0, 2.0, 3.0])}, np.ones((3, 2))
    growth = growth_of(tangent(OSCILLATOR), 2)
    found = growth.run(states, sizes, TIMES, values)
    # an area is preserved whatever the frequency
    np.testing.assert_allclose(np.log(found.lengths).sum(axis=2), 0.0, atol=1e-11)
    alone = growth.run(states[1:2], sizes[1:2], TIMES, {"p": 2.0})
    assert alone.lengths.tolist() == found.lengths[1:2].tolist()


def square_of_direction(graph: Graph, frames: Sequence[Vector]) -> list[Term]:
    """γ² at the end of an interval."""
    gamma = [graph.state(i) for i in (3, 4, 5)]
    return [dot(graph, gamma, gamma)]


def test_states_stay_on_the_phase_space() -> None:
    """With a coarse tolerance γ² drifts, unless it is put back after each interval."""
    state, times = np.array([[0.3, -0.2, 0.9, 0.6, 0.0, 0.8]]), np.linspace(0.0, 200.0, 401)[1:]
    drifts = []
    for relations in (TOP.relations, ()):
        space = tangent(replace(TOP, relations=relations))
        growth = deviation_growth(
            space, 1, orthonormal_terms, square_of_direction, tolerance=1e-5, device="cpu"
        )
        run = growth.run(state, np.ones((1, 6)), times)
        drifts.append(np.abs(run.records[0, :, 0] - 1).max())
    assert drifts[0] < drifts[1] / 20


def test_the_same_bits_on_a_graphics_processor(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "graphics_loop", lambda *task: graphics_loop(*task, PtxMachine))
    space = transverse_space(body("chaplygin-ball"))
    states, sizes = starts("chaplygin-ball", 2), np.full((2, 6), 0.5)
    there = growth_of(space, 1, "gpu")
    assert isinstance(there.loop, GraphicsLoop)
    found, right = (
        growth.run(states, sizes, np.array([0.1, 0.2])) for growth in (there, growth_of(space, 1))
    )
    assert found.lengths.tolist() == right.lengths.tolist()
    assert np.isfinite(right.lengths).all()
