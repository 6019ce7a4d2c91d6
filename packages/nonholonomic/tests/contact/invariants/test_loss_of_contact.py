"""A ball that rolls without normal force, by other equations."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp

import flowlanes
import lawproof
import nonholonomic
from flowlanes.system.laws import Identity
from nonholonomic.contact.invariants.loss_of_contact import (
    WITHOUT_FORCE,
    any_contact,
    zero_normal_acceleration,
)

BALL = WITHOUT_FORCE


def test_the_rolling_body_of_the_package_has_no_normal_force() -> None:
    moment = float(BALL.moment)
    body = nonholonomic.Body(1.0, (moment,) * 3, nonholonomic.Ball(1.0, centre=(0.0, 0.0, 0.7)))
    motion = flowlanes.integrate(
        nonholonomic.rolling_system(body, field=nonholonomic.Forces(gravity=float(BALL.gravity))),
        {"omega": (-1.0, 0.0, -1.0), "gamma": (0.6, 0.0, 0.8)},
        [0.0, 1e-6],
        on_liftoff="warn",
    )
    assert abs(motion["normal_force"][0]) < 1e-15


def test_free_motion_presses_the_ball_into_the_plane() -> None:
    """The height of the lowest point is z − R + (c, γ), and a ball in flight turns evenly."""
    tilt = BALL.omega.cross(BALL.omega.cross(BALL.centre)).dot(BALL.gamma)
    assert -BALL.gravity + tilt == BALL.free_rise < 0


def test_the_normal_force_changes_its_sign_there() -> None:
    more = replace(BALL, gravity=BALL.gravity + sp.Rational(1, 100))
    less = replace(BALL, gravity=BALL.gravity - sp.Rational(1, 100))
    assert less.normal_force < 0 == BALL.normal_force < more.normal_force
    assert less.free_rise < 0


def test_a_wrong_sign_in_the_paradox_is_refuted() -> None:
    system, law = any_contact(), zero_normal_acceleration()
    assert lawproof.prove(system, law).decision == "proven"
    b_3 = sp.Symbol("b_3", real=True)
    assert lawproof.prove(system, Identity("wrong", law.value - 2 * b_3)).decision == "refuted"


@pytest.mark.parametrize("gravity", [sp.Rational(3, 10), sp.Rational(31, 100)])
def test_the_friction_that_rolling_needs_is_paradoxical(gravity: sp.Rational) -> None:
    """With N < 0 and b_n < 0, sliding against that friction has B < 0."""
    ball = replace(BALL, gravity=gravity)
    N, free = ball.normal_force, ball.free_rise
    assert N < 0 > free
    pushed = ball.reaction() / N
    response = ball.gamma.dot(ball.mobility() * pushed)
    assert response == -free / N < 0
