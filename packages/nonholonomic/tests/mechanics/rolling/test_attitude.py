"""Quaternions: exact identities at rational unit quaternions, and the known rotations."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

import reference
from flowlanes.system.vectors import Vector, to_components
from nonholonomic.mechanics.rolling.attitude import (
    attitude,
    attitude_observable,
    attitude_relations,
    quaternion_rate,
    rotation,
    unit_length,
)

OMEGA = Vector("omega")
SPIN = sp.Matrix([sp.Rational(3, 7), sp.Rational(-2, 5), sp.Rational(5, 3)])
UNIT_QUATERNIONS = [
    (sp.Rational(1, 11), sp.Rational(2, 11), sp.Rational(-4, 11), sp.Rational(10, 11)),
    (sp.Rational(-5, 9), sp.Rational(4, 9), sp.Rational(2, 9), sp.Rational(6, 9)),
    (sp.S.One, sp.S.Zero, sp.S.Zero, sp.S.Zero),
]


def at(formula, quaternion, more=()):
    values = dict(zip(attitude.symbols, quaternion, strict=True)) | dict(more)
    return sp.Matrix(to_components(formula)).xreplace(values)


def hat(v):
    return sp.Matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


@pytest.mark.parametrize("quaternion", UNIT_QUATERNIONS)
def test_rotation_is_a_rotation(quaternion):
    turn = at(rotation(), quaternion)
    assert turn * turn.T == sp.eye(3)
    assert turn.det() == 1


@pytest.mark.parametrize("quaternion", UNIT_QUATERNIONS)
def test_rate_turns_body_axes_with_the_angular_velocity(quaternion):
    """(1.13): the rows of R are alpha, beta, gamma, and alpha' = alpha x omega: R' = R hat(omega).

    The rate keeps the length of a quaternion.
    """
    spin = dict(zip(OMEGA.symbols, SPIN, strict=True))
    rate = at(quaternion_rate(OMEGA), quaternion, spin)
    change = sp.zeros(3, 3)
    for symbol, speed in zip(attitude.symbols, rate, strict=True):
        change += at(rotation().diff(symbol), quaternion) * speed
    assert change == at(rotation(), quaternion) * hat(SPIN)
    assert rate.dot(sp.Matrix(quaternion)) == 0


def test_quarter_turn_about_the_third_axis():
    half = sp.sqrt(2) / 2
    turn = at(rotation(), (half, 0, 0, half))
    assert turn * sp.Matrix([1, 0, 0]) == sp.Matrix([0, 1, 0])


def test_rotation_agrees_with_the_reference():
    rng = np.random.default_rng(4)
    matrix = sp.lambdify(attitude.symbols, rotation())
    for _ in range(5):
        q = rng.normal(size=4)
        q /= np.linalg.norm(q)
        np.testing.assert_allclose(matrix(*q), reference.rotation(q), rtol=0, atol=1e-15)


@pytest.mark.parametrize("quaternion", UNIT_QUATERNIONS)
def test_relations_vanish_where_they_should_only(quaternion):
    values = dict(zip(attitude.symbols, quaternion, strict=True))
    assert unit_length().xreplace(values) == 0
    assert unit_length().xreplace({s: 2 * x for s, x in values.items()}) == 3
    gamma = Vector("gamma")
    third = at(rotation(), quaternion).row(2)
    upright = values | dict(zip(gamma.symbols, third, strict=True))
    assert [defect.xreplace(upright) for defect in attitude_relations(gamma)] == [0, 0, 0]
    tilted = values | dict(zip(gamma.symbols, -third, strict=True))
    assert [defect.xreplace(tilted) for defect in attitude_relations(gamma)] == [
        2 * x for x in third
    ]


def test_observable_is_the_quaternion():
    observable = attitude_observable()
    assert (observable.name, observable.frame) == ("attitude", "quaternion")
    assert tuple(to_components(observable.value)) == attitude.symbols
