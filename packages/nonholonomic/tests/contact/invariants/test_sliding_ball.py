"""A sliding ball: its laws hold for any friction, and one slip in them is refuted."""

from __future__ import annotations

import pytest
import sympy as sp

import lawproof
import nonholonomic
from flowlanes.system.laws import Identity, Integral, Rate
from nonholonomic.contact.invariants import sliding_ball as ball


def test_any_force_keeps_the_momentum_about_the_contact() -> None:
    system = ball.sliding_ball(ball.ANY_FORCE)
    assert [lawproof.prove(system, law).decision for law in ball.momenta()] == ["proven"] * 3


def test_a_couple_changes_the_spin_alone() -> None:
    system = ball.sliding_ball(ball.ANY_FORCE, ball.ANY_COUPLE)
    decisions = [lawproof.prove(system, law).decision for law in ball.momenta()]
    assert decisions == ["proven", "proven", "refuted"]


def test_the_slip_keeps_its_direction_if_friction_is_against_it() -> None:
    system = ball.sliding_ball(ball.against_slip(), ball.ANY_COUPLE)
    assert [lawproof.prove(system, law).decision for law in ball.slip_direction()] == ["proven"] * 2
    across = ball.sliding_ball(ball.ANY_FORCE)
    assert lawproof.prove(across, ball.slip_direction()[0]).decision == "refuted"


def test_a_wrong_sign_in_the_momentum_is_refuted() -> None:
    V_2 = ball.V.symbols[1]
    wrong = Integral("wrong", ball.inertia * ball.omega.symbols[0] + ball.m * ball.R * V_2)
    verdict = lawproof.prove(ball.sliding_ball(ball.ANY_FORCE), wrong)
    assert verdict.decision == "refuted" and verdict.witness is not None


@pytest.mark.parametrize("factor", [sp.Rational(7, 2), sp.Rational(5, 2)])
def test_the_slip_of_a_full_ball_falls_at_seven_halves_mu_g(factor: sp.Rational) -> None:
    """Coriolis: 2|u|/(7μg) to the end, with I = 2mR²/5."""
    system = nonholonomic.from_catalogue("sliding-ball")
    solid = (ball.inertia - sp.Rational(2, 5) * ball.m * ball.R**2,)
    law = Identity("rate", Rate(ball.slip_speed) + factor * ball.mu * ball.g, level=solid)
    right = factor == sp.Rational(7, 2)
    assert lawproof.prove(system, law).decision == ("proven" if right else "refuted")
