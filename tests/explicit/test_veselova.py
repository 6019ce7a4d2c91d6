"""The Veselova system, separated."""

from __future__ import annotations

from dataclasses import replace

import mpmath
import pytest

from chaplygin.explicit.stated import stated
from chaplygin.explicit.veselova import veselova
from chaplygin.laws.prove import prove
from explicit.along import abel_sums, at, located, restored, states

SEPARABLE = veselova()
LAWS = {law.name: law for law in SEPARABLE.laws}
#: Principal moments in another order, and a start with (ω, γ) = 0.
PARAMETERS = {"I_1": "2.1", "I_2": "1", "I_3": "1.5"}
GAMMA = ("0.48", "-0.64", "0.6")
OMEGA = ("0.9", "-0.3", "-1.04")


@pytest.mark.parametrize("name", LAWS)
def test_proven(name):
    assert prove(SEPARABLE.system, LAWS[name]).decision == "proven"


PLANTED = {
    "leading": ({"leading": 2 * SEPARABLE.leading}, "separation"),
    "root": ({"roots": (*SEPARABLE.roots[:4], 2 * SEPARABLE.roots[4])}, "separation"),
    "weight": (
        {"weights": (*SEPARABLE.weights[:2], SEPARABLE.system.symbols[0] * SEPARABLE.weights[2])},
        "separation",
    ),
    "speed": ({"speeds": (SEPARABLE.speeds[0], 2 * SEPARABLE.speeds[1])}, "separation"),
    "clock": ({"clock": 2 * SEPARABLE.clock}, "direction"),
    "state": (
        {"state": tuple((name, 2 * formula) for name, formula in SEPARABLE.state)},
        "reconstruction",
    ),
    "fixed": ({"fixed": (SEPARABLE.state[0][0],)}, "fixed_1"),
}


@pytest.mark.parametrize("slip", PLANTED)
def test_a_slip_is_refuted(slip):
    changes, name = PLANTED[slip]
    (law,) = (law for law in stated(replace(SEPARABLE, **changes)) if law.name == name)
    assert prove(SEPARABLE.system, law).decision == "refuted"


def test_along_a_motion():
    motion = states(SEPARABLE.system, (*OMEGA, *GAMMA), PARAMETERS)
    with mpmath.workdps(34):
        begin = located(SEPARABLE, motion[0])
        for values in motion:
            known = located(SEPARABLE, values)
            first, second = abel_sums(SEPARABLE, known)
            assert abs(first) < 1e-27
            assert abs(second - 1) < 1e-27
            for symbol, _ in SEPARABLE.constants:
                assert abs(known[symbol] - begin[symbol]) < 1e-27
            for symbol, value in restored(SEPARABLE, known).items():
                assert abs(value - known[symbol]) < 1e-28
            assert at(SEPARABLE.clock, known) > 0
