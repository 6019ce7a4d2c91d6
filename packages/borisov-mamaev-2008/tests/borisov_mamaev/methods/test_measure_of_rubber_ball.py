"""For which rubber balls a measure exists (§10.2)."""

from __future__ import annotations

import pytest
import sympy as sp

from borisov_mamaev_2008.methods.measure_of_rubber_ball import curl, only_symmetric_balls

PLACE = tuple(map(sp.Rational, ("2/7", "-3/7", "6/7")))


def at(moments, offset):
    return curl(PLACE, offset, moments)


def test_it_is_decided():
    assert only_symmetric_balls()


def test_the_curl_vanishes_for_symmetric_balls():
    assert at((3, 3, 4), (0, 0, 1)) == 0
    assert at((3, 4, 4), (1, 0, 0)) == 0
    assert at((3, 3, 3), (1, 2, -1)) == 0
    assert at((3, 4, 5), (0, 0, 0)) == 0


def test_the_curl_does_not_vanish_for_others():
    assert at((3, 4, 5), (0, 0, 1)) != 0
    assert at((3, 3, 4), (1, 0, 0)) != 0
    assert at((3, 3, 4), (1, 0, 1)) != 0


@pytest.mark.slow
def test_the_curl_is_that_of_the_inertia_about_the_contact():
    moments, radius = (3, 4, 5), sp.Rational(1, 2)
    # m = 1 and 2mR = 1, so that κ = c
    offset = tuple(map(sp.Rational, ("1/2", "1", "-1/3")))
    c, gamma = sp.Matrix(offset), sp.Matrix(sp.symbols("g1:4"))
    inertia = sp.diag(*moments) - (radius**2 + c.dot(c)) * sp.eye(3) + c * c.T
    r = c - radius * gamma
    direction = (inertia + r.dot(r) * sp.eye(3) - r * r.T).adjugate() * gamma
    q = direction / gamma.dot(direction)
    total = sum(
        gamma[i] * (sp.diff(q[k], gamma[j]) - sp.diff(q[j], gamma[k]))
        for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1))
    )
    assert total.subs(dict(zip(gamma, PLACE, strict=True))) == at(moments, offset)
