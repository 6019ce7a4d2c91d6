"""Roots of which the power alone is known: what is proved with them holds for either sign."""

from __future__ import annotations

from lawproof.proof.fields.budget import Budget
from lawproof.proof.fields.formal_roots import FormalRoots


def test_the_root_of_a_square_is_not_its_base() -> None:
    field = FormalRoots(["x"], 8, {"x": 1.0}, Budget(), {})
    x = field.generator("x")
    root = field.root(x * x, 2)
    assert not field.vanishes(root - x)
    assert field.vanishes(root * root - x * x)


def test_the_root_of_a_square_is_its_base_where_that_is_positive() -> None:
    field = FormalRoots(["x"], 8, {"x": 1.0}, Budget(), {})
    field.signs = field.signs.with_positive("x")
    x = field.generator("x")
    assert field.vanishes(field.root(x * x, 2) - x)


def test_the_third_root_of_a_cube_is_its_base() -> None:
    field = FormalRoots(["x"], 8, {"x": 1.0}, Budget(), {})
    x = field.generator("x")
    assert field.vanishes(field.root(x**3, 3) - x)
