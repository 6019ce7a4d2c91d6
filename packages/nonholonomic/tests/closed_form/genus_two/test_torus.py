from dataclasses import replace

import numpy as np
import pytest
from flint import arb, ctx

from closed_form.followed_states import GAMMA, OMEGA, without
from flowlanes.formulas.balls import number
from nonholonomic.closed_form.genus_two.separated_motion import separate
from nonholonomic.closed_form.separations.veselova import veselova
from nonholonomic.starts import initial_state

START = initial_state(veselova().system, tuple(without(OMEGA, GAMMA)), tuple(GAMMA))[:6]


def test_the_derivative_is_along_the_flow() -> None:
    with ctx.workprec(256):
        torus = separate(veselova(), veselova().system.defaults, START).torus
        step = arb(2) ** -60

        def at(tau: arb) -> tuple[tuple[arb, ...], tuple[arb, ...]]:
            return torus.ball([x + rate * tau for x, rate in zip(torus.v_0, torus.V, strict=True)])

        (before, _), (after, _), (here, slope) = at(-step), at(step), at(arb(0))
        for low, high, rate in zip(before, after, slope, strict=True):
            assert abs((high - low) / (2 * step) - rate) < arb(2) ** -90
        assert sum((x * x for x in here), arb(0)).contains(1)


def test_arrays_agree_with_balls() -> None:
    with ctx.workprec(256):
        torus = separate(veselova(), veselova().system.defaults, START).torus
        v = np.array([[0.3, -0.8], [1.7, 0.2]])
        direction, turning = torus.values(v)
        for place, row in enumerate(v):
            nu, nuprime = torus.ball([arb(float(x)) for x in row])
            assert direction[:, place] == pytest.approx([number(x) for x in nu], abs=1e-14)
            assert turning[:, place] == pytest.approx([number(x) for x in nuprime], abs=1e-13)


def test_the_direction_has_period_two() -> None:
    torus = separate(veselova(), veselova().system.defaults, START).torus
    here, shifted = (torus.values(np.array([[x, y]]))[0] for x, y in ((0.3, 0.4), (2.3, -3.6)))
    assert here == pytest.approx(shifted, abs=1e-14)


def test_a_wrong_weight_is_noticed() -> None:
    of = veselova()
    wrong = replace(of, weights=(of.weights[0], 2 * of.weights[1], of.weights[2]))
    with ctx.workprec(256), pytest.raises(ArithmeticError, match="does not pass through its start"):
        separate(wrong, of.system.defaults, START)


def test_a_wrong_root_is_noticed() -> None:
    of = veselova()
    wrong = replace(of, roots=(*of.roots[:4], of.roots[4] * 21 / 20))
    with ctx.workprec(256), pytest.raises(ArithmeticError, match="does not pass through its start"):
        separate(wrong, of.system.defaults, START)
