"""Equilibria that exclude an invariant measure, on systems whose linearisation is known by hand."""

from __future__ import annotations

import pytest
import sympy as sp

from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import unit_vector
from flowlanes.system.vectors import Vector, cross, dot
from nonholonomic.catalogue import from_catalogue
from nonholonomic.invariant_measures.equilibria import equilibrium_obstruction

x, y, k = sp.symbols("x y k", real=True)
gamma = Vector("gamma")
UP = unit_vector(3)


def on_the_sphere(rate: sp.Expr) -> System:
    return System("sphere", "On the sphere", {gamma: rate}, relations=(dot(gamma, gamma) - 1,))


def test_volumes_shrink_about_a_damped_oscillator_at_rest():
    damped = System("damped", "Damped", {x: y, y: -x - k * y}, (Parameter(k, "damping", 0.1),))
    found = equilibrium_obstruction(damped)
    assert found is not None
    assert (found.point, found.trace) == ((0, 0), sp.Rational(-1, 10))
    assert "at the equilibrium x = 0, y = 0" in str(found)
    assert "the trace is −1 / 10" in str(found)


def test_the_equilibrium_need_not_be_the_origin():
    logistic = System("logistic", "Logistic", {x: x**2 - 1, y: (x + 1) * y})
    found = equilibrium_obstruction(logistic)
    assert found is not None
    assert (found.point, found.trace) == ((1, 0), 4)


def test_on_a_level_the_trace_is_that_along_it():
    # the gradient of the height: sources and sinks at the poles of a two-dimensional sphere
    height = equilibrium_obstruction(on_the_sphere(UP - dot(UP, gamma) * gamma))
    assert height is not None
    assert (height.point, height.trace) == ((0, 0, 1), -2)
    # a rate across the sphere that vanishes on it changes the trace in space, not on the sphere
    rotation = cross(gamma, UP) + (dot(gamma, gamma) - 1) * gamma
    assert equilibrium_obstruction(on_the_sphere(rotation)) is None


@pytest.mark.parametrize(
    "name",
    [
        "veselova",
        pytest.param("chaplygin-ball", marks=pytest.mark.slow),
        pytest.param("rubber-chaplygin-ball", marks=pytest.mark.slow),
    ],
)
def test_a_system_with_a_measure_has_none(name: str):
    assert equilibrium_obstruction(from_catalogue(name)) is None
