"""The hollow ball around a sphere without slipping, separated at zero linear integral."""

from __future__ import annotations

from dataclasses import replace
from itertools import permutations

import mpmath
import pytest
import sympy as sp

from closed_form.along import abel_sums, at, located, restored, states
from closed_form.separations.ball_sphere_coordinates import in_coordinates
from lawproof.proof.prover import prove
from nonholonomic.closed_form.genus_two.separation_laws import separation_laws
from nonholonomic.closed_form.separations.ball_sphere import hollow_ball, of_tensor

BY_TENSOR, BALL = of_tensor(), hollow_ball()
INSTANT = in_coordinates(BY_TENSOR)
LAWS = {f"{of.name} {law.name}": (of.system, law) for of in (BY_TENSOR, BALL) for law in of.laws}
LAWS |= {f"instant {law.name}": (INSTANT, law) for law in INSTANT.laws if law.name != "separation"}

MOMENTS = tuple(permutations(("1", "1.5", "2.1")))[::2]
NORMAL = ("0.48", "-0.64", "0.6")


@pytest.mark.slow
@pytest.mark.parametrize("name", LAWS)
def test_proven(name):
    system, law = LAWS[name]
    assert prove(system, law).decision == "proven"


@pytest.mark.slow
def test_the_rates_at_an_instant():
    assert prove(INSTANT, "separation").decision == "proven"


CURVES = {
    "leading": ({"leading": 2 * BY_TENSOR.leading}, "curve"),
    "root": ({"roots": (*BY_TENSOR.roots[:3], 0, *BY_TENSOR.roots[4:])}, "curve"),
    "speeds exchanged": ({"speeds": BY_TENSOR.speeds[::-1]}, "curve"),
    "second speed": ({"speeds": (BY_TENSOR.speeds[0], sp.S.Zero)}, "curve"),
    "weights of Veselova": (
        {"weights": tuple(w * e for w, e in zip(BY_TENSOR.weights, BY_TENSOR.poles, strict=True))},
        "direction",
    ),
}
STATED = {
    "time_rescaling": ({"time_rescaling": 1 / BY_TENSOR.time_rescaling}, "direction"),
    "momentum": (
        {"state": tuple((name, -formula) for name, formula in BY_TENSOR.state)},
        "reconstruction",
    ),
    "normal fixed": ({"fixed": (BY_TENSOR.direction,)}, "fixed_1"),
}


@pytest.mark.parametrize("slip", CURVES)
def test_a_slip_in_the_curve_is_refuted(slip):
    changes, name = CURVES[slip]
    assert prove(in_coordinates(replace(BY_TENSOR, **changes)), name).decision == "refuted"


@pytest.mark.parametrize("slip", STATED)
def test_a_slip_is_refuted(slip):
    changes, name = STATED[slip]
    (law,) = (law for law in separation_laws(replace(BY_TENSOR, **changes)) if law.name == name)
    assert prove(BY_TENSOR.system, law).decision == "refuted"


@pytest.mark.parametrize("order", MOMENTS, ids="-".join)
def test_along_a_motion(order):
    parameters = {"m": "1.3", "R": "0.8", "a": "0.4", **dict(zip(I_NAMES, order, strict=True))}
    with mpmath.workdps(34):
        motion = states(BALL.system, (*momentum(parameters), *NORMAL), parameters)
        begin = located(BALL, motion[0])
        speeds = [at(speed, begin) for speed in BALL.speeds]
        for values in motion:
            known = located(BALL, values)
            for found, speed in zip(abel_sums(BALL, known), speeds, strict=True):
                assert abs(found - speed) < 1e-26 * abs(speed)
            for symbol, _ in BALL.constants:
                assert abs(known[symbol] - begin[symbol]) < 1e-27
            for symbol, value in restored(BALL, known).items():
                assert abs(value - known[symbol]) < 1e-28
            assert at(BALL.time_rescaling, known) > 0


I_NAMES = ("I_1", "I_2", "I_3")


def momentum(parameters):
    """M with (AM, γ) = 0, to 34 digits."""
    inertia = [mpmath.mpf(parameters[name]) for name in I_NAMES]
    d = mpmath.mpf(parameters["m"]) * mpmath.mpf(parameters["R"]) ** 2
    lever = [(mpmath.fsum(inertia) + d) / 2 - moment for moment in inertia]
    first, second, third = (a * mpmath.mpf(x) for a, x in zip(lever, NORMAL, strict=True))
    M = mpmath.mpf("0.9"), mpmath.mpf("-0.7")
    return tuple(mpmath.nstr(x, 36) for x in (*M, -(first * M[0] + second * M[1]) / third))
