"""Bodies: what is accepted, how it is kept, and what is refused."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import partial

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, strategies as st

import reference
from flowlanes.errors import InputError
from nonholonomic.mechanics.rolling.body import Body, triangle_inequalities
from nonholonomic.mechanics.rolling.equations import RollingBody
from nonholonomic.mechanics.shapes.shapes import Ball, Disk, Torus

BALL = Ball(1.0)
UNIT = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))

MISTAKES = {
    "mass": ({"mass": -1.0}, "mass -1.0: it must be a positive finite number"),
    "no mass": ({"mass": 0.0}, "mass 0.0: it must be a positive finite number"),
    "mass that is no number": ({"mass": np.nan}, "mass nan: it must be a positive finite number"),
    "two moments": (
        {"inertia": (1.0, 2.0)},
        "inertia (1.0, 2.0): it must be three principal moments or a symmetric 3x3 matrix",
    ),
    "ragged matrix": (
        {"inertia": ((1.0, 0.0, 0.0), (0.0, 1.0), (0.0, 0.0, 1.0))},
        "it must be three principal moments or a symmetric 3x3 matrix",
    ),
    "words": (
        {"inertia": ("a", "b", "c")},
        "inertia ('a', 'b', 'c'): it must be three principal moments or a symmetric 3x3 matrix",
    ),
    "infinite moment": (
        {"inertia": (1.0, 1.0, np.inf)},
        "it must be three principal moments or a symmetric 3x3 matrix",
    ),
    "not symmetric": (
        {"inertia": ((1.0, 0.1, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))},
        "inertia ((1.0, 0.1, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)): the matrix must be symmetric",
    ),
    "negative moment": (
        {"inertia": (1.0, -0.5, 1.0)},
        "inertia: principal moments -0.5, 1, 1 must all be positive",
    ),
    "indefinite matrix": (
        {"inertia": ((1.0, 2.0, 0.0), (2.0, 1.0, 0.0), (0.0, 0.0, 1.0))},
        "inertia: principal moments -1, 1, 3 must all be positive",
    ),
    "triangle inequality": (
        {"inertia": (1.0, 2.5, 1.2)},
        "inertia: principal moments 1, 1.2, 2.5 break the triangle inequality (2.5 > 1 + 1.2); "
        "each moment must be at most the sum of the other two",
    ),
    "two rotors": (
        {"gyrostat": (0.1, 0.2)},
        "gyrostat (0.1, 0.2): it must be three finite numbers",
    ),
    "infinite rotor": (
        {"gyrostat": (0.1, 0.2, np.inf)},
        "gyrostat (0.1, 0.2, inf): it must be three finite numbers",
    ),
}


@pytest.mark.parametrize(("wrong", "message"), MISTAKES.values(), ids=MISTAKES)
def test_mistake_is_named(wrong, message):
    right = {"mass": 1.0, "inertia": (1.0, 1.0, 1.0), "shape": BALL}
    with pytest.raises(InputError, match=re.escape(message)):
        Body(**(right | wrong))


def test_flat_plate_is_a_body():
    assert Body(1.0, (1.0, 1.5, 2.5), BALL).principal


positive = st.floats(0.01, 10.0)


@given(st.tuples(positive, positive, positive), st.tuples(*[st.floats(-1.0, 1.0)] * 4))
def test_turned_tensor_of_a_body_is_accepted(masses, attitude):
    """Any distribution of mass obeys the triangle inequality, in any axes, within rounding."""
    squares = np.array(masses)
    principal = squares.sum() - squares
    turn = reference.rotation(np.add(attitude, (1.5, 0.0, 0.0, 0.0)))
    body = Body(1.0, turn @ np.diag(principal) @ turn.T, BALL)
    found = np.linalg.eigvalsh(body.tensor)
    np.testing.assert_allclose(found, np.sort(principal), rtol=1e-12)


def test_numbers_are_kept_as_plain_tuples():
    body = Body(1.0, np.array([1, 2, 2]), BALL, np.array([0, 1, 0]))
    assert body.inertia == (1.0, 2.0, 2.0)
    assert body.gyrostat == (0.0, 1.0, 0.0)
    assert {type(x) for x in (*body.inertia, *body.gyrostat)} == {float}
    assert hash(body) == hash(Body(1.0, [1.0, 2.0, 2.0], BALL, [0.0, 1.0, 0.0]))
    np.testing.assert_array_equal(body.tensor, np.diag([1.0, 2.0, 2.0]))


def test_diagonal_matrix_means_principal_axes():
    assert Body(1.0, UNIT, BALL).principal
    off = ((1.0, 0.1, 0.0), (0.1, 1.0, 0.0), (0.0, 0.0, 1.0))
    assert not Body(1.0, off, BALL).principal
    assert Body(1.0, off, BALL).inertia == off


def test_what_the_moments_of_a_body_must_satisfy() -> None:
    a, b, c = symbols = sp.symbols("a b c", real=True)
    asked = triangle_inequalities(symbols)
    assert asked == {a: (a > 0, a <= b + c), b: (b > 0, b <= a + c), c: (c > 0, c <= a + b)}


def test_products_of_inertia_may_have_either_sign() -> None:
    tensor = ((1.0, 0.1, 0.0), (0.1, 1.0, 0.0), (0.0, 0.0, 1.0))
    system = RollingBody(Body(1.0, tensor, BALL)).system()
    asked = {str(p.symbol): len(p.admissible) for p in system.parameters if "I_" in str(p.symbol)}
    assert asked == {"I_11": 2, "I_12": 0, "I_13": 0, "I_22": 2, "I_23": 0, "I_33": 2}


def test_a_centre_of_mass_outside_is_remarked() -> None:
    words = "shape.centre puts the centre of mass outside the body"
    assert Body(1.0, (1.0, 1.0, 1.0), Ball(1.0, centre=(0.0, 0.8, 0.8))).remarks == (words,)
    assert Body(1.0, (1.0, 1.0, 1.0), Ball(1.0, centre=(0.0, 0.6, 0.7))).remarks == ()
    assert Body(1.0, (1.0, 1.0, 1.0), BALL).remarks == ()


@pytest.mark.parametrize("rim", [Disk, partial(Torus, tube=0.1)])
def test_a_cylinder_on_its_rim_has_its_centre_inside(rim: Callable[..., Disk | Torus]) -> None:
    def remarks(centre: tuple[float, float, float]) -> tuple[str, ...]:
        return Body(1.0, (1.0, 1.0, 1.0), rim(radius=1.0, centre=centre)).remarks

    assert remarks((0.0, 0.0, 2.0)) == remarks((0.3, 0.4, 0.5)) == ()
    assert remarks((0.0, 1.2, 0.0)) == ("shape.centre puts the centre of mass outside the body",)
