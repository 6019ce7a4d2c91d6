"""Charts of states, with coordinates fixed and solved for."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from flowlanes.errors import InputError
from flowlanes.flow.sampling.level_sampler import sample_level
from flowlanes.formulas.array_evaluation import values
from flowlanes.scans.state_coordinates import StateCoordinates, chart
from nonholonomic.catalogue import from_catalogue
from nonholonomic.mechanics.charts.charts import CHARTS

BALL, VESELOVA = from_catalogue("chaplygin-ball"), from_catalogue("veselova")
PI = np.pi


def grid(*axes: Any) -> Any:
    return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, len(axes))


@pytest.mark.parametrize("name", ["andoyer", "andoyer-ratio"])
def test_both_ways(name: str) -> None:
    states = sample_level(BALL, 200, {"energy": 1.0}, seed=1)
    made = chart(BALL, name)
    points = made.point(states)
    assert points.shape == (200, 5)
    assert np.abs(made.state(points) - states).max() < 1e-13
    assert (made.solutions(points) == 1).all()
    for column, period in zip(points.T, made.periods, strict=True):
        assert period == 0 or (column.min() >= 0 and column.max() < period)


def section(
    energy: float, area: float, parameters: dict[str, float] | None = None
) -> StateCoordinates:
    """(l, L/G) on the section g = π/2 of a level."""
    made = chart(BALL, "andoyer-ratio", parameters=parameters)
    return made.with_fixed({"g": PI / 2, "H": area}).without_coordinate("G", "energy", energy)


def test_a_section_of_a_level() -> None:
    made = section(1.0, 0.3)
    assert made.names == ("l", "L/G")
    assert made.periods == (2 * PI, 0.0)
    points = grid(np.linspace(0, 6, 7), np.linspace(-0.999, 0.999, 8))
    states = made.state(points)
    assert (made.solutions(points) == 1).all()
    assert np.abs(values(BALL, ["energy", "area"], states) - [1.0, 0.3]).max() < 3e-15
    assert np.abs(np.sin((made.point(states) - points) / 2)).max() < 1e-12


def test_the_solved_momentum_of_a_ball_of_equal_moments() -> None:
    # with I = 1, m = R = 1: M = 2 omega - (omega, gamma) gamma, and G follows in closed form
    equal = {"I_1": 1.0, "I_2": 1.0, "I_3": 1.0}
    states = section(1.0, 0.6, equal).state(grid([0.0, 2.0], [-0.5, 0.5]))
    G = np.linalg.norm(states[:, :3], axis=1)
    # 2 h = G^2 / 2 + H^2 / 2
    assert np.abs(G - np.sqrt(4.0 - 0.36)).max() < 1e-14


def test_points_without_a_state() -> None:
    made = section(1.0, 2.5)
    points = grid(np.linspace(0, 6, 9), np.linspace(-0.9, 0.9, 9))
    many = made.solutions(points)
    assert set(many) <= {0, 1, 2} and 0 in many
    states = made.state(points)
    assert (np.isnan(states).all(axis=1) == (many == 0)).all()
    with pytest.raises(InputError, match=r"no state at l = [^;]*; the coordinates need G"):
        made.require(points)
    made.require(points[many > 0])


@pytest.mark.slow
def test_branches_on_a_torus() -> None:
    made = (
        chart(VESELOVA, "directions")
        .with_fixed({"energy": 1.0})
        .without_coordinate("psi", "momentum", 2.6)
    )
    assert made.names == ("theta", "phi")
    points = grid(np.linspace(0.1, 3.0, 9), np.linspace(0.0, 6.0, 9))
    many = made.solutions(points)
    # omega and -omega, and two quadratic conditions on a plane
    assert set(many) == {0, 4}
    turns = []
    for branch in range(4):
        states = made.state(points, branch)
        assert (np.isnan(states[:, 0]) == (many == 0)).all()
        found = values(VESELOVA, ["energy", "momentum"], states[many > 0])
        assert np.abs(found - [1.0, 2.6]).max() < 1e-14
        turns.append(chart(VESELOVA, "directions").point(states[many > 0])[:, 2])
    assert (np.diff(turns, axis=0) > 0).all()
    last = made.state(points, -1)
    assert (last[many > 0] == made.state(points, 3)[many > 0]).all()


def test_energy_and_angle_at_a_place() -> None:
    made = chart(BALL, "directions", {"area": 0.3}).with_fixed({"theta": 1.0, "phi": 0.5})
    assert made.names == ("psi", "energy")
    points = grid(np.linspace(0, 6, 5), [0.001, 0.5, 2.0])
    many = made.solutions(points)
    assert (many == (points[:, 1] > 0.01)).all()
    states = made.state(points)[many > 0]
    assert np.abs(values(BALL, ["energy", "area"], states)[:, 1] - 0.3).max() < 1e-15
    off = made.point(states) - points[many > 0]
    assert np.abs(np.sin(off / 2)).max() < 1e-13


def test_a_state_depends_on_its_point_alone() -> None:
    made = section(1.0, 0.3)
    points = grid(np.linspace(0, 6, 5), np.linspace(-0.9, 0.9, 5))
    whole = made.state(points)
    for k in (0, 7, 24):
        assert (made.state(points[k : k + 1]) == whole[k]).all()


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: chart(BALL, "polar"), f"no coordinates 'polar'; there are {', '.join(CHARTS)}"),
        (lambda: chart(BALL, "andoyer", {"energy": 1.0}), "use .with_fixed"),
        (lambda: chart(VESELOVA, "andoyer"), "need a momentum and a unit vector"),
        (
            lambda: chart(BALL, "andoyer").with_fixed({"x": 1.0}),
            "no coordinate 'x' .* L, G, H, l, g",
        ),
        (
            lambda: chart(BALL, "andoyer").without_coordinate("x", "energy", 1.0),
            "no coordinate 'x'",
        ),
        (
            lambda: chart(BALL, "andoyer").without_coordinate("G", "spin", 1.0),
            "no integral 'spin'; it has",
        ),
        (
            lambda: section(1.0, 0.3).without_coordinate("l", "momentum", 1.0),
            "one coordinate can be solved for, not two",
        ),
        (lambda: chart(BALL, "andoyer").state([[1.0, 2.0]]), "rows of 5 numbers are needed"),
        (
            lambda: chart(BALL, "andoyer").require([[2.0, 1.0, 0.0, 0.0, 0.0]]),
            "no state at L = 2, G = 1, .*need G > 0, -G <= L <= G",
        ),
    ],
)
def test_refusals(make: Any, said: str) -> None:
    with pytest.raises(InputError, match=said):
        make()
