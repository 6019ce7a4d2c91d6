"""Putting a state back where its relations hold."""

from __future__ import annotations

import numpy as np
import pytest

from flowlanes.flow.taylor.projection import Block, Projector
from needs import optional

hy = optional("heyoka")
HeyokaFormulas = optional("flowlanes.flow.taylor.heyoka_series").HeyokaFormulas

x, y, z = hy.make_vars("x", "y", "z")
NONE = np.array([])


def block(*residuals: object, columns: slice = slice(0, 3), kind: type = float) -> Block:
    variables = [x, y, z]
    slopes = [hy.diff(residual, v) for residual in residuals for v in variables[columns]]
    return Block(
        HeyokaFormulas(hy.cfunc([*residuals, x], variables, fp_type=kind)),
        HeyokaFormulas(hy.cfunc([*slopes, x], variables)),
        len(residuals),
    )


SPHERE = x**2 + y**2 + z**2 - 1.0


def projector(*blocks: Block, columns: slice = slice(0, 3), **options: object) -> Projector:
    settings = {"parameters": NONE, "threshold": 1e-15, **options}
    return Projector(blocks, columns, **settings)


def test_a_state_goes_the_shortest_way_to_the_sphere():
    state = 1.001 * np.array([0.36, -0.48, 0.8])
    assert projector(block(SPHERE))(state)
    assert state == pytest.approx([0.36, -0.48, 0.8], abs=2e-16)


def test_a_state_at_rounding_level_is_left_alone():
    state = np.array([0.6, 0.8, 4e-16])
    before = state.copy()
    assert not projector(block(SPHERE))(state)
    assert state.tolist() == before.tolist()


def test_without_relations_nothing_moves():
    state = np.array([3.0, 4.0, 5.0])
    assert not projector()(state)
    assert state.tolist() == [3.0, 4.0, 5.0]


def test_only_the_chosen_columns_move():
    columns = slice(1, 3)
    state = np.array([0.6, 0.81, 0.0])
    assert projector(block(SPHERE, columns=columns), columns=columns)(state)
    assert state.tolist() == pytest.approx([0.6, 0.8, 0.0], abs=2e-16)
    assert state[0] == 0.6


def test_several_relations_in_several_blocks():
    plane = x + 2 * y - 3 * z
    state = np.array([0.839, 0.2805, 0.4665])
    assert projector(block(SPHERE), block(plane))(state)
    assert abs(state @ state - 1) < 1e-15
    assert abs(state @ [1, 2, -3]) < 1e-15


def test_relations_may_repeat_each_other():
    state = 1.001 * np.array([0.36, -0.48, 0.8])
    assert projector(block(SPHERE, -2.0 * SPHERE))(state)
    assert state == pytest.approx([0.36, -0.48, 0.8], abs=4e-16)


def test_residuals_may_have_other_values_than_zero():
    state = np.array([0.5002, 0.8655, 0.0301])
    target = np.array([0.0, 0.5])
    assert projector(block(SPHERE, x), target=target)(state)
    assert abs(state @ state - 1) < 1e-15
    assert abs(state[0] - 0.5) < 1e-15


def test_thirty_digits():
    kind = hy.real128
    state = np.array([kind("0.36"), kind("-0.48"), kind("0.8001")], dtype=kind)
    assert projector(
        block(SPHERE, kind=kind), threshold=1e-32, parameters=np.array([], dtype=kind)
    )(state)
    length = state[0] * state[0] + state[1] * state[1] + state[2] * state[2]
    assert abs(float(length - kind(1))) < 1e-32


def test_many_states_at_once():
    function = HeyokaFormulas(hy.cfunc([x * hy.par[0], x], [x]))
    values = function(np.array([[3.0, 4.0]]), np.array([2.0, 7.0, 8.0]))
    assert values.tolist() == [[6.0, 8.0]]
