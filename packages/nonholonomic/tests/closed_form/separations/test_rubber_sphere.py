"""The rubber ball around a sphere, separated."""

from __future__ import annotations

from dataclasses import replace

import mpmath
import pytest
import sympy as sp

from closed_form.along import abel_sums, at, located, restored, states
from lawproof.proof.prover import prove
from nonholonomic.closed_form.genus_two.separation_laws import separation_laws
from nonholonomic.closed_form.separations.rubber_sphere import (
    hollow_ball,
    of_ratio,
    on_e3,
    on_plane,
)

FAMILY, BALL, ON_PLANE, ON_E3 = of_ratio(), hollow_ball(), on_plane(), on_e3()
LAWS = {law.name: law for law in FAMILY.laws}
PLANE = {law.name: law for law in ON_PLANE.laws}
#: The separated equations in m, R and I take longer than those in J.
QUICK = {law.name: law for law in BALL.laws if law.name != "separation"}

#: Principal moments in every order, and starts with (ω, n) = 0 and n² = 1.
MOMENTS = {
    "rising": ("1", "1.5", "2.1"),
    "falling": ("2.1", "1.5", "1"),
    "middle last": ("1", "2.1", "1.5"),
}
NORMAL = ("0.48", "-0.64", "0.6")
STARTS = {
    "rising": ("0.9", "-0.3", "-1.04"),
    "falling": ("-0.3", "0.6", "0.88"),
    "middle last": ("0.4", "0.45", "0.16"),
}


@pytest.mark.parametrize("name", LAWS)
def test_of_the_family(name):
    assert prove(FAMILY.system, LAWS[name]).decision == "proven"


@pytest.mark.parametrize("name", QUICK)
def test_of_the_ball(name):
    assert prove(BALL.system, QUICK[name]).decision == "proven"


@pytest.mark.parametrize("name", PLANE)
def test_on_the_plane(name):
    assert prove(ON_PLANE.system, PLANE[name]).decision == "proven"


@pytest.mark.parametrize("law", ON_E3.laws, ids=lambda law: law.name)
def test_on_e3(law):
    assert prove(ON_E3.system, law).decision == "proven"


@pytest.mark.slow
def test_separation_of_the_ball():
    (law,) = (law for law in BALL.laws if law.name == "separation")
    assert prove(BALL.system, law).decision == "proven"


PLANTED = {
    "leading": ({"leading": 2 * FAMILY.leading}, "separation"),
    "root": ({"roots": (*FAMILY.roots[:4], 2 * FAMILY.roots[4])}, "separation"),
    "weights of n": (
        {"weights": tuple(w * e for w, e in zip(FAMILY.weights, FAMILY.poles, strict=True))},
        "separation",
    ),
    "speed": ({"speeds": (FAMILY.speeds[0], 2 * FAMILY.speeds[1])}, "separation"),
    "first speed": ({"speeds": (sp.S.One, FAMILY.speeds[1])}, "separation"),
    "time_rescaling": ({"time_rescaling": 1 / FAMILY.time_rescaling}, "direction"),
    "state": (
        {"state": tuple((name, -formula) for name, formula in FAMILY.state)},
        "reconstruction",
    ),
    "normal fixed": ({"fixed": (FAMILY.state[1][0],)}, "fixed_1"),
}


@pytest.mark.parametrize("slip", PLANTED)
def test_a_slip_is_refuted(slip):
    changes, name = PLANTED[slip]
    (law,) = (law for law in separation_laws(replace(FAMILY, **changes)) if law.name == name)
    assert prove(FAMILY.system, law).decision == "refuted"


@pytest.mark.parametrize("order", MOMENTS)
def test_along_a_motion(order):
    inertia = dict(zip(("I_1", "I_2", "I_3"), MOMENTS[order], strict=True))
    parameters = {"m": "1.3", "R": "1.2", "a": "0.6", **inertia}
    motion = states(BALL.system, (*STARTS[order], *NORMAL), parameters)
    with mpmath.workdps(34):
        begin = located(BALL, motion[0])
        speed = at(BALL.speeds[1], begin)
        roots = sorted(at(root, begin) for root in BALL.roots)
        for values in motion:
            known = located(BALL, values)
            first, second = abel_sums(BALL, known)
            assert abs(first) < 1e-27
            assert abs(second - speed) < 1e-27
            for symbol, _ in BALL.constants:
                assert abs(known[symbol] - begin[symbol]) < 1e-27
            for symbol, value in restored(BALL, known).items():
                assert abs(value - known[symbol]) < 1e-28
            assert at(BALL.time_rescaling, known) > 0
        # the last root lies beyond all poles
        assert roots[-1] > max(at(pole, begin) for pole in BALL.poles)
