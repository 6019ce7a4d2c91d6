"""Stability of a spinning top: roots against the margin, and the equations they come from."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from nonholonomic.contact.invariants import top_stability as top
from nonholonomic.contact.invariants.sliding_top import (
    I_1,
    I_3,
    NORMAL_VISCOUS,
    R,
    c,
    g,
    m,
    tippe_top,
)

SYMBOLS = (m, I_1, I_3, R, c, g, top.n, top.kappa)


def roots_of(values: dict[sp.Symbol, float]) -> np.ndarray:
    """Roots of P(λ)."""
    polynomial = sp.Poly(top.characteristic_polynomial().subs(values), top.rate)
    return np.roots([complex(x) for x in polynomial.all_coeffs()])


@pytest.mark.parametrize("seed", range(12))
def test_the_margin_decides_on_the_roots(seed: int) -> None:
    random = np.random.default_rng(seed)
    numbers = random.uniform(0.2, 2.0, len(SYMBOLS))
    values = dict(zip(SYMBOLS, map(float, numbers), strict=True))
    values[R] = 1.0
    values[c] = float(random.uniform(-0.8, 0.8))
    values[I_1] = values[I_3] * float(random.uniform(0.6, 1.5))
    margin = float(top.stability_margin().subs(values))
    assert (roots_of(values).real.max() < 0) == (margin > 0)


def test_the_minors_are_products_with_the_margin() -> None:
    for minor, product in zip(top.hermitian_minors(), top.expected_minors(), strict=True):
        assert sp.expand(minor - product) == 0


def test_both_answers_occur_among_the_starts() -> None:
    """Leine and Glocker's top turns unstable between 20 and 180 rad/s."""
    values = {m: 0.006, I_1: 8e-7, I_3: 7e-7, R: 0.015, c: 0.003, g: 9.81, top.kappa: 0.01}
    assert (
        roots_of(values | {top.n: 20.0}).real.max()
        < 0
        < roots_of(values | {top.n: 180.0}).real.max()
    )


@pytest.mark.slow
def test_the_polynomial_is_that_of_the_equations() -> None:
    assert top.characteristic_difference(tippe_top()) == 0


@pytest.mark.slow
def test_friction_along_the_slip_has_another_polynomial() -> None:
    from dataclasses import replace

    from nonholonomic.contact.invariants.sliding_top import p

    system = tippe_top()
    definitions = tuple(
        (name, -1 * NORMAL_VISCOUS if name == p else formula)
        for name, formula in system.definitions
    )
    assert top.characteristic_difference(replace(system, definitions=definitions)) != 0
