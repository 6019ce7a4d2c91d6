"""Planes of parameters and starts."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

from flowlanes.errors import InputError
from flowlanes.formulas.array_evaluation import values
from flowlanes.scans.grid import INADMISSIBLE, NO_STATE, axis, scan_grid
from nonholonomic.catalogue import entry
from nonholonomic.catalogue.ball_on_sphere.ball_on_sphere_equations import equations_on_sphere

BALL = equations_on_sphere()
START = {"M": (1.0, 0.5, 1.2), "n": (0.2, -0.3, 0.93)}
ENTRY = entry("ball-on-sphere")
ROLLING = ENTRY.system()


def test_axes_are_read() -> None:
    item = axis(" theta = 0 : 2*pi : 5 ")
    assert (item.name, item.count) == ("theta", 5)
    assert np.array_equal(item.values, np.linspace(0.0, 2 * np.pi, 5))
    assert axis("k=0.5:0.5:1").values.tolist() == [0.5]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("k", "an axis is written NAME=FIRST:LAST:COUNT"),
        ("k=1:2", "an axis is written"),
        ("2k=1:2:3", "an axis is written"),
        ("k=0:1:2.5", "a whole number from 1"),
        ("k=0:1:0", "a whole number from 1"),
        ("k=0:1:1000000", "a whole number from 1"),
        ("k=1:1:5", "two ends that differ"),
        ("k=0:1:1", "a count of 1 one end"),
        ("k=a:1:5", "unknown name 'a'"),
    ],
)
def test_axes_that_are_none(text: str, message: str) -> None:
    with pytest.raises(InputError, match=message):
        axis(text, "--x")


def test_parameters_and_components_stand_as_given() -> None:
    made = scan_grid(BALL, axis("k=-1:1:5"), axis("n_1=-0.9:0.9:4"), START)
    cells = made.cells(1, 3)
    assert not cells.reasons.any()
    ((symbol, ratios),) = cells.parameters.items()
    assert str(symbol) == "k"
    assert np.array_equal(ratios, np.tile(np.linspace(-1, 1, 5), 2))
    assert np.array_equal(cells.starts[:, 3], np.repeat(np.linspace(-0.9, 0.9, 4)[1:3], 5))
    assert np.array_equal(cells.starts[:, :3], np.tile(START["M"], (10, 1)))
    assert np.abs(np.linalg.norm(cells.starts[:, 3:], axis=1) - 1).max() < 4e-16


def test_rows_do_not_depend_on_the_block() -> None:
    made = scan_grid(BALL, axis("k=-1:1:5"), axis("energy=0.5:0.9:6"), START)
    whole = made.cells(0, 6).starts
    parts = [made.cells(row, row + 1).starts for row in range(6)]
    assert np.array_equal(whole, np.concatenate(parts))
    again = pickle.loads(pickle.dumps(made)).cells(0, 6).starts
    assert np.array_equal(whole, again)


def test_levels_move_the_momentum_and_not_the_normal() -> None:
    made = scan_grid(
        BALL,
        axis("energy=0.51:0.77:4"),
        axis("theta=0:3:5"),
        START,
        formulas={
            "n_1": "sin(theta)*0.6",
            "n_2": "0.8*sin(theta)",
            "n_3": "cos(theta)",
            "momentum": "3",
        },
    )
    cells = made.cells(0, 5)
    good = cells.reasons == 0
    found = values(BALL, [law.value for law in BALL.integrals[:2]], cells.starts[good])
    wanted = np.stack([np.tile(made.x.values, 5), np.full(20, 3.0)], axis=1)
    assert np.abs(found - wanted[good]).max() < 1e-14
    theta = np.repeat(made.y.values, 4)
    normals = np.stack([0.6 * np.sin(theta), 0.8 * np.sin(theta), np.cos(theta)], axis=1)
    assert np.abs(cells.starts[good, 3:] - normals[good]).max() < 1e-15
    # (M, ω)/2 lies between those of the principal axes of I_Q, and nowhere else
    tensors = np.diag([2.0, 2.5, 3.1]) - normals[:, :, None] * normals[:, None, :]
    moments = np.linalg.eigvalsh(tensors)
    possible = (1.5 / moments[:, 2] < wanted[:, 0]) & (wanted[:, 0] < 1.5 / moments[:, 0])
    assert np.array_equal(possible, good)


def test_a_start_by_angular_velocity_stays_what_it_is() -> None:
    made = scan_grid(
        ROLLING,
        axis("k=-2:0.75:5"),
        axis("I_3=2:2.4:3"),
        ENTRY.start.values,
        formulas={"a": "k*R/(1-k)"},
    )
    cells = made.cells(0, 3)
    found = values(ROLLING, ["omega_1", "omega_2", "omega_3", "k"], cells.starts, cells.parameters)
    assert np.abs(found[:, :3] - (0.7, 0.4, 1.1)).max() < 1e-14
    assert np.abs(found[:, 3] - np.tile(made.x.values, 3)).max() < 1e-15


def test_cells_without_a_motion_say_why() -> None:
    made = scan_grid(BALL, axis("I_1=-0.5:1:4"), axis("n_1=-1.5:1.5:4"), START)
    cells = made.cells(0, 4)
    reasons = cells.reasons.reshape(4, 4)
    assert np.all(reasons[:, :2] == INADMISSIBLE)
    assert np.all(reasons[[0, 3], 2:] == NO_STATE)
    assert np.all(reasons[[1, 2], 2:] == 0)
    assert np.array_equal(np.isnan(cells.starts).any(axis=1), cells.reasons != 0)


def test_cells_of_bodies_that_cannot_be_say_so() -> None:
    made = scan_grid(ROLLING, axis("I_1=-1:4:6"), axis("m=-1:1:3"), ENTRY.start.values)
    reasons = made.cells(0, 3).reasons.reshape(3, 6)
    assert np.all(reasons[:2] == INADMISSIBLE)
    # I_2 + I_3 = 3.6
    assert reasons[2].tolist() == [INADMISSIBLE, INADMISSIBLE, 0, 0, 0, INADMISSIBLE]


def test_what_is_held_is_not_moved() -> None:
    x, y = axis("energy=0.6:0.8:3"), axis("k=0:1:3")
    free = scan_grid(BALL, x, y, {**START, "n": (0.0, 0.6, 0.8)}).cells(0, 3).starts
    held = scan_grid(BALL, x, y, {**START, "n": (0.0, 0.6, 0.8)}, fixed=["M_1", "n"]).cells(0, 3)
    assert np.ptp(free[:, 0]) > 1e-3
    assert np.array_equal(held.starts[:, [0, 3, 4, 5]], np.tile([1.0, 0.0, 0.6, 0.8], (9, 1)))


@pytest.mark.parametrize(
    ("x", "y", "more", "message"),
    [
        ("k=0:1:2", "k=0:1:2", {}, "the two axes need names that differ"),
        ("k=0:1:2", "q=0:1:2", {}, "q: .* no formula uses it"),
        ("k=0:1:2", "n1=0:1:2", {}, "did you mean 'n_1'"),
        ("k=0:1:2", "d=0:1:2", {"formulas": {"k": "2"}}, "k: it is an axis"),
        ("k=0:1:2", "q=0:1:2", {"formulas": {"n_7": "q"}}, "n_7: .* neither parameter, variable"),
        ("k=0:1:2", "q=0:1:2", {"formulas": {"n_1": "q + w"}}, "unknown name 'w'"),
        ("k=0:1:2", "d=0:1:2", {"fixed": ["p"]}, "p: no variable of the start"),
    ],
)
def test_mistakes(x: str, y: str, more: dict[str, object], message: str) -> None:
    with pytest.raises(InputError, match=message):
        scan_grid(BALL, axis(x), axis(y), START, **more)


def test_a_mistake_names_what_is_of_use_in_the_order_of_declaration() -> None:
    with pytest.raises(InputError) as caught:
        scan_grid(BALL, axis("k_9=0:1:2"), axis("energy=0:1:2"), START)
    allowed = "allowed: I_1 … I_3, d, k, M_1 … M_3, n_1 … n_3, energy, momentum, linear"
    assert str(caught.value).endswith(allowed)


def test_starts_that_are_incomplete() -> None:
    x, y = axis("k=0:1:2"), axis("d=0:1:2")
    with pytest.raises(InputError, match="the start gives no n"):
        scan_grid(BALL, x, y, {"M": (1.0, 0.5, 1.2)})
    with pytest.raises(InputError, match="n: 3 numbers are needed, not 2"):
        scan_grid(BALL, x, y, {**START, "n": (1.0, 0.0)})
