"""Formulas of a System at many states."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.formulas.array_formulas import Formulas
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import to_components
from nonholonomic.catalogue.ball_on_sphere.ball_on_sphere_equations import equations_on_sphere

BALL = equations_on_sphere()
LEVELS = (
    to_components(BALL.relations[0]),
    *(to_components(law.value) for law in BALL.integrals[:2]),
)
STATES = np.random.default_rng(1).normal(size=(7, 6))
RATIOS = {"k": np.linspace(-1.0, 1.0, 7)}


def test_values_are_those_of_sympy() -> None:
    x, y, c = sp.symbols("x y c", real=True)
    made = System(
        name="made", title="Made", field={x: y, y: -x}, parameters=(Parameter(c, "factor", 3.0),)
    )
    functions = [sp.sin, sp.cos, sp.tan, sp.atan, sp.sinh, sp.cosh, sp.tanh, sp.exp, sp.Abs]
    formulas = [f(x) * c / y for f in functions] + [
        sp.asin(x / 9) - sp.acos(y / 9),
        sp.log(x**2) + sp.sqrt(1 + y**2) ** 3,
        sp.atan2(y, x) - sp.sign(x),
    ]
    states = STATES[:, :2]
    for factor in (3.0, np.linspace(1.0, 2.0, 7)):
        found = Formulas(made, tuple(formulas))(states, {c: factor})
        numbers = np.broadcast_to(factor, 7)
        for row, state, number in zip(found, states, numbers, strict=True):
            exact = [f.subs({x: state[0], y: state[1], c: number}) for f in formulas]
            assert np.allclose(row, np.array(exact, dtype=float), rtol=1e-13, atol=1e-13)


def test_slopes_are_differences() -> None:
    made = Formulas(BALL, LEVELS)
    slopes = made.slopes(STATES, RATIOS)
    assert slopes.shape == (7, 3, 6)
    for j in range(6):
        step = 1e-6 * np.eye(6)[j]
        differences = (made(STATES + step, RATIOS) - made(STATES - step, RATIOS)) / 2e-6
        assert np.abs(differences - slopes[:, :, j]).max() < 1e-7


def test_strange_names_are_refused() -> None:
    with pytest.raises(InputError, match=r"no parameter K; it has I_1, I_2, I_3, d, k"):
        Formulas(BALL, LEVELS)(STATES, {"K": 1.0})
    with pytest.raises(InputError, match="uses q, which"):
        Formulas(BALL, (sp.Symbol("q"),))(STATES)


def test_it_travels_to_other_processes() -> None:
    made = Formulas(BALL, LEVELS)
    before = made.slopes(STATES, RATIOS)
    assert np.array_equal(pickle.loads(pickle.dumps(made)).slopes(STATES, RATIOS), before)


def test_states_of_any_shape() -> None:
    made = Formulas(BALL, LEVELS)
    stacked = np.stack([STATES, 2.0 * STATES], axis=1)
    found = made(stacked, RATIOS)
    assert np.array_equal(found[:, 0], made(STATES, RATIOS))
    assert np.array_equal(made(STATES[0]), made(STATES)[0])
    assert made.slopes(STATES[0]).shape == (3, 6)
