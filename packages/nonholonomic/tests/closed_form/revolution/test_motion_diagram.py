"""The diagram (h, K) of a motion of a rubber body of revolution, and its place there."""

from __future__ import annotations

import math

import pytest

from flowlanes.errors import InputError
from nonholonomic.closed_form.base.problem import Problem
from nonholonomic.closed_form.revolution.motion_diagram import (
    column_of,
    diagram_of_body_of_revolution,
)
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces, RollingBody
from nonholonomic.mechanics.shapes.shape_base import Shape
from nonholonomic.mechanics.shapes.shapes import Ball, Disk
from nonholonomic.starts import initial_state


def problem(
    shape: Shape, omega: tuple[float, float, float], gamma: tuple[float, float, float], g: float
) -> Problem:
    rolling = RollingBody(Body(1.0, (0.25, 0.25, 0.5), shape), contact="rubber", field=Forces(g))
    system = rolling.system()
    start = tuple(initial_state(system, omega, gamma))
    return Problem(system, system.defaults, start, rolling)


def test_a_disk() -> None:
    # B = I₁ + m R² and K = A ω₃, A² = I₁ u² + (I₃ + m R²)(1 − u²)
    spin, turn = -2.0, 0.5
    asked = problem(Disk(1.0), (spin * -0.75, turn, spin), (0.8, 0.0, 0.6), 9.81)
    found = diagram_of_body_of_revolution(asked)
    assert found is not None
    diagram, (h, K) = found
    square = 0.25 * 0.36 + 1.5 * 0.64
    assert math.isclose(K, spin * math.sqrt(square))
    assert math.isclose(h, (1.25 * turn**2 + K**2 / 0.64) / 2 + 9.81 * 0.8)
    assert diagram.columns[0].K < abs(K) < diagram.columns[-1].K
    # upright rolling gains its stability at K² = m g R, which the diagram shows
    assert set(diagram.stable) == {True, False}
    assert diagram.columns[-1].K ** 2 > 9.81
    column = column_of(asked, K)
    assert column is not None
    assert abs(K) == column.K
    assert column.motions_at(h) == 2


def test_without_weight_or_spin_the_diagram_has_a_scale() -> None:
    asked = problem(Ball(1.0), (0.0, 1.0, 0.0), (1.0, 0.0, 0.0), 0.0)
    found = diagram_of_body_of_revolution(asked)
    assert found is not None
    diagram, (_, K) = found
    assert (K, diagram.columns[-1].K) == (0.0, 1.5)
    assert column_of(asked, K) is None


def test_what_is_no_rubber_body_of_revolution() -> None:
    rolling = RollingBody(Body(1.0, (0.25, 0.3, 0.5), Ball(1.0)), contact="rubber")
    system = rolling.system()
    start = tuple(initial_state(system, (0.0, 1.0, 0.0), (1.0, 0.0, 0.0)))
    assert diagram_of_body_of_revolution(Problem(system, system.defaults, start, rolling)) is None
    assert diagram_of_body_of_revolution(Problem(system, system.defaults, start)) is None


def test_a_start_off_the_phase_space() -> None:
    asked = problem(Disk(1.0), (0.0, 1.0, 0.0), (1.0, 0.0, 0.0), 9.81)
    wrong = Problem(asked.system, asked.parameters, (5.0, *asked.start[1:]), asked.rolling)
    with pytest.raises(InputError):
        diagram_of_body_of_revolution(wrong)
