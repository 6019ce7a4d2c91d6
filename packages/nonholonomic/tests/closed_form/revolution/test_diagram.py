"""The bifurcation diagram of rubber bodies of revolution."""

from __future__ import annotations

import math

import numpy as np
import pytest

from flowlanes.errors import InputError
from nonholonomic.closed_form.revolution import solve_rolling
from nonholonomic.closed_form.revolution.diagram import Diagram, revolution_diagram
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces, RollingBody
from nonholonomic.mechanics.shapes.shapes import Ball, Disk
from nonholonomic.starts import initial_state

DISK = RollingBody(Body(1.0, (0.25, 0.25, 0.5), Disk(1.0)), contact="rubber", field=Forces(9.81))
SPINS = (0.5, 1.0, 2.0, 3.0, 3.2, 4.0)


@pytest.fixture(scope="module")
def diagram() -> Diagram:
    return revolution_diagram(DISK, SPINS)


def test_upright_disk_gains_stability_with_its_spin(diagram: Diagram) -> None:
    # V = g sin θ + K²/(2 sin² θ) has a maximum upright for K² < g, and a minimum beyond
    for column in diagram.columns:
        (upright,) = (rest for rest in column.rests if rest.u.contains(0))
        assert upright.stable == (column.K**2 > 9.81)
        assert abs(float(upright.h) - (9.81 + column.K**2 / 2)) < 1e-12
        assert len(column.rests) == (1 if upright.stable else 3)


def test_leaning_disks_are_where_the_formula_says(diagram: Diagram) -> None:
    for column in diagram.columns:
        leaning = [float(rest.u) for rest in column.rests if not rest.u.contains(0)]
        for place in leaning:
            assert abs((1 - place**2) ** 1.5 - column.K**2 / 9.81) < 1e-12


def test_numbers_of_motions(diagram: Diagram) -> None:
    column = diagram.columns[1]
    leaning, upright = float(column.rests[0].h), 9.81 + 0.5
    assert column.motions_at(leaning - 0.1) == 0
    assert column.motions_at((leaning + upright) / 2) == 2
    assert column.motions_at(upright + 0.1) == 1


@pytest.mark.slow
def test_a_motion_lies_where_its_integrals_say(diagram: Diagram) -> None:
    state = initial_state(DISK.system(), (0.3, 1.0, 1.0), (1.0, -0.3, 0.0))
    solution = solve_rolling(DISK, DISK.system(), state)
    assert solution is not None
    h, K, *_ = (float(figure.value) for figure in solution.form.constants)
    column = revolution_diagram(DISK, [abs(K)]).columns[0]
    assert column.motions_at(h) == 1


def test_curves_join_the_columns(diagram: Diagram) -> None:
    assert sum(len(curve) for curve in diagram.curves) == sum(len(c.rests) for c in diagram.columns)
    lengths = sorted(len(curve) for curve in diagram.curves)
    assert lengths[-1] >= 3
    assert all(np.all(np.diff(curve[:, 1]) > 0) for curve in diagram.curves)


def test_refusals() -> None:
    for K in (0.0, math.inf):
        with pytest.raises(InputError, match="must be positive"):
            revolution_diagram(DISK, [K])
    for spins in ([], [2.0, 1.0]):
        with pytest.raises(InputError, match="each above the one before"):
            revolution_diagram(DISK, spins)
    marble = RollingBody(DISK.body, contact="marble", field=Forces(9.81))
    with pytest.raises(InputError, match="rubber body of revolution"):
        revolution_diagram(marble, [1.0])
    with pytest.raises(InputError, match="merge"):
        # at K² = g the three rotations of the disk become one
        revolution_diagram(RollingBody(DISK.body, contact="rubber", field=Forces(4.0)), [2.0])


def test_ball_without_gravity_has_one_rotation() -> None:
    ball = RollingBody(Body(1.0, (0.3, 0.3, 0.2), Ball(1.0)), contact="rubber")
    (column,) = revolution_diagram(ball, [1.0]).columns
    (rest,) = column.rests
    assert rest.stable
    assert math.isclose(float(rest.h), 0.5)


def test_its_overview(diagram: Diagram) -> None:
    first, columns, families = repr(diagram).splitlines()
    assert first.endswith("in the plane of h and K")
    assert columns.split() == ["columns", "6,", "K", "from", "0.5", "to", "4"]
    assert families.split()[0] == "families"
