from itertools import product

import numpy as np
import pytest
from flint import acb, acb_mat, arb, arb_mat, ctx

from flowlanes.formulas.balls import number
from nonholonomic.closed_form.genus_two.theta import Theta

Y = arb_mat([[arb(0.875), arb(0.3125)], [arb(0.3125), arb(1.125)]])
ALL = [((a, b), (c, d)) for a, b, c, d in product((0, 1), repeat=4)]
AT = (arb(0.375), arb(-1.21875))
ALONG = (arb(0.8125), arb(-0.5))


def test_all_sixteen_agree_with_flint() -> None:
    with ctx.workprec(160):
        period = acb_mat([[acb(0, Y[i, j]) for j in (0, 1)] for i in (0, 1)])
        values = period.theta(acb_mat([[acb(x)] for x in AT]))
        for place, characteristic in enumerate(ALL):
            value, _ = Theta(Y, characteristic).ball(AT, ALONG)
            assert value.overlaps(values[0, place].real)
            assert value.rad() < arb(2) ** -130


@pytest.mark.parametrize("place", [0, 5, 10, 15])
def test_the_slope_is_that_of_the_values(place: int) -> None:
    theta = Theta(Y, ALL[place])
    with ctx.workprec(300):
        step = arb(2) ** -60
        before, after = (
            theta.ball([x + sign * step * u for x, u in zip(AT, ALONG, strict=True)], ALONG)[0]
            for sign in (-1, 1)
        )
        _, slope = theta.ball(AT, ALONG)
        assert abs((after - before) / (2 * step) - slope) < arb(2) ** -100


def test_arrays_agree_with_balls() -> None:
    rng = np.random.default_rng(5)
    v = rng.uniform(-3, 3, size=(7, 2))
    theta = Theta(Y, ALL[6])
    values, slopes = theta.values(v, [number(x) for x in ALONG])
    for row, value, slope in zip(v, values, slopes, strict=True):
        exact = theta.ball([arb(float(x)) for x in row], ALONG)
        assert value == pytest.approx(number(exact[0]), abs=1e-14)
        assert slope == pytest.approx(number(exact[1]), abs=1e-13)


def test_the_tail_bounds_what_is_left_out() -> None:
    flat = arb_mat([[arb(0.078125), arb(0.015625)], [arb(0.015625), arb(1.25)]])
    theta = Theta(flat, ALL[9])
    with ctx.workprec(200):
        few, many = (sum((w for _, w in theta.terms(bits)), arb(0)) for bits in (40, 160))
        assert abs(many - few) < theta.tail(40)
