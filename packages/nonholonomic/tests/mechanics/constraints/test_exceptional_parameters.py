"""Values of parameters at which constraints become integrable, or nearly so."""

from __future__ import annotations

import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.system import Parameter
from flowlanes.system.vectors import real_symbol
from nonholonomic import Ball, Body, Ellipsoid, Forces, Plane, RollingBody, Sphere
from nonholonomic.mechanics.constraints.exceptional_parameters import exceptional_values
from nonholonomic.mechanics.lagrangian.mechanism import Mechanism, coordinates
from nonholonomic.mechanics.rolling.mechanism import rolling_mechanism

x, y, z, k = (real_symbol(name) for name in "xyzk")
PLAIN = coordinates(x, y, z)
u, v, w = PLAIN.w


def found(constraint):
    made = Mechanism(
        "planted", PLAIN, sp.S.Zero, (constraint,), parameters=(Parameter(k, "k", 0.7),)
    )
    return {e.value: e.growth for e in exceptional_values(made, k)}


@pytest.mark.parametrize(
    ("constraint", "values"),
    [
        (w - k * x * v - y * u, {1: (2,)}),
        (w - (k**2 - 2) * x * v - 2 * y * u, {-2: (2,), 2: (2,)}),
        (w - x * v / (k - 4) - y * u, {5: (2,)}),
        (w - x * v - k * x * y * u, {}),
        ((k - 3) * (w - x * v) + (k - 3) * y * u, {3: (3,)}),
        (w - (k - 2) * sp.exp(x) * v - (k - 2) * sp.log(y) * u, {2: (2,)}),
        (w - (2 * k - 1) * (k**2 + 1) * sp.sin(x) * v, {sp.Rational(1, 2): (2,)}),
    ],
    ids=str,
)
def test_planted_values(constraint, values):
    assert found(constraint) == values


def ball(contact, radius=2.0):
    body = Body(1.0, (0.3, 0.4, 0.5), Ball(0.8))
    return rolling_mechanism(
        RollingBody(body, Sphere.of_signed_radius(radius), contact, Forces(gravity=9.81))
    )


@pytest.mark.parametrize("radius", [2.0, 0.8, -2.0])
def test_rubber_balls_of_equal_radii_are_the_only_exception(radius):
    (only,) = exceptional_values(ball("rubber", radius), real_symbol("a"))
    assert (only.value, only.growth, only.usual) == (sp.Rational(4, 5), (2,), (2, 3, 5))


def test_a_marble_ball_on_a_sphere_has_no_exceptional_ratio():
    assert exceptional_values(ball("marble"), real_symbol("a")) == ()


def test_mistakes():
    with pytest.raises(InputError, match="no parameter b; it has"):
        exceptional_values(ball("rubber"), real_symbol("b"))
    body = Body(1.0, (0.3, 0.4, 0.5), Ellipsoid((1.0, 0.8, 0.6)))
    with pytest.raises(InputError, match="does not enter the constraints rationally"):
        exceptional_values(
            rolling_mechanism(RollingBody(body, Plane(), "marble")), real_symbol("b_1")
        )
    made = Mechanism(
        "circle",
        PLAIN,
        sp.S.Zero,
        (w - x * v,),
        positions=(x**2 + y**2 - k**2,),
        parameters=(Parameter(k, "k", 0.7),),
    )
    with pytest.raises(InputError, match="configuration space itself depends on k"):
        exceptional_values(made, k)
