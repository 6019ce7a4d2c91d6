from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy as sp
from flint import arb, ctx

from flowlanes.formulas.balls import array_function, ball, ball_function, ball_values
from flowlanes.system.named_formulas import needed_steps

x, y, z = sp.symbols("x y z")


@pytest.mark.parametrize(
    "value", [0.1, "0.1", Fraction(1, 10), sp.Rational(1, 10), np.float64(0.1)], ids=repr
)
def test_a_tenth_is_a_tenth(value: object) -> None:
    with ctx.workprec(200):
        assert (ball(value) * 10).contains(1)
        assert ball(value).rad() < arb(2) ** -150


def test_long_numbers_keep_their_digits() -> None:
    with mpmath.workdps(50):
        third = -mpmath.mpf(1) / 3
    with ctx.workprec(200):
        assert abs(ball(third) + arb(1) / 3) < arb(10) ** -49


def test_formulas_agree_in_balls_and_arrays() -> None:
    formulas = (
        (x + sp.Rational(1, 3)) ** 3 / sp.sqrt(y),
        sp.Abs(x) ** sp.Rational(-3, 2) + y**-2,
        sp.Integer(2),
        sp.sqrt(2) * y / sp.sqrt(3),
        sp.Float(0.5) * x,
    )
    known = {x: arb("-0.7"), y: arb("1.9")}
    balls = ball_values(formulas, known)
    arrays = array_function((x, y), formulas)(-0.7, 1.9)
    for one, other in zip(balls, arrays, strict=True):
        assert float(one.mid()) == pytest.approx(float(other), rel=1e-15)


def test_powers_of_balls_around_zero_are_finite() -> None:
    (value,) = ball_values([x**2 + x**3], {x: arb(0, 1e-30)})
    assert value.is_finite()
    assert value.contains(0)


def test_steps_are_taken_in_order() -> None:
    steps = ((y, x**2), (z, y + 1))
    assert needed_steps((*steps, (sp.Symbol("unused"), x)), [z]) == steps
    (value,) = ball_function((x,), (z * y,), steps)(arb(3))
    assert value == 90
    (array,) = array_function((x,), (z * y,), steps)(np.array([3.0, 1.0]))
    assert list(array) == [90.0, 2.0]
