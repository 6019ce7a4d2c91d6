from fractions import Fraction

import numpy as np
import pytest
from flint import arb, ctx

from nonholonomic.closed_form.genus_two.phases import phase_at
from nonholonomic.closed_form.one_degree.phase_reduction import pair


@pytest.mark.parametrize("time", [0.3, -17.25, 1e6 / 3, 1e12 / 7, -1e15])
def test_turns_keep_their_digits_at_long_times(time: float) -> None:
    with ctx.workprec(200):
        rate = pair(arb(2).sqrt())
    found = phase_at(rate, np.array([time]), 4.0)[0]
    exact = (Fraction(rate[0]) + Fraction(rate[1])) * Fraction(time)
    miss = (Fraction(float(found)) - exact) / 4
    assert abs(float(miss - round(miss))) < 1e-16


def test_two_halves_hold_thirty_digits() -> None:
    with ctx.workprec(200):
        value = arb.pi()
        high, low = pair(value)
        assert abs(arb(high) + arb(low) - value) < arb("1e-31")
