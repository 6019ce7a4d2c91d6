"""Formulas as one NumPy function."""

from __future__ import annotations

import numpy as np
import sympy as sp

from flowlanes.formulas.compiled import CompiledTerms, SystemFormulas
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import real_symbol

x, y, a = (real_symbol(name) for name in ["x", "y", "a"])
SYSTEM = System("trial", "Trial", {x: y, y: -a * x}, (Parameter(a, "stiffness", 2.0),))
FORMULAS = (
    a * x**2 / (1 + y**2),
    sp.atan2(y, x),
    sp.sqrt(x + 3) * sp.exp(-y) + sp.log(x + 4),
    sp.sin(x) * sp.cos(y) - sp.tan(x / 4) + sp.asin(x / 5) + sp.acos(y / 5) + sp.atan(x),
    sp.sinh(x) + sp.cosh(y) + sp.tanh(x) + sp.Abs(y) + sp.sign(x),
    sp.Rational(1, 3),
)
POINTS = np.random.default_rng(2).uniform(-2, 2, (2, 30))


def test_values() -> None:
    sheet = SystemFormulas(SYSTEM)
    found = CompiledTerms([sheet.term_of(f) for f in FORMULAS])(POINTS, np.array([1.7]))
    for row, formula in zip(found, FORMULAS, strict=True):
        wanted = sp.lambdify((x, y, a), formula)(*POINTS, 1.7)
        assert np.allclose(row, wanted, rtol=1e-14)


def test_slopes() -> None:
    sheet = SystemFormulas(SYSTEM)
    slopes = sheet.slopes([sheet.term_of(FORMULAS[0])])[0]
    found = CompiledTerms(slopes)(POINTS, np.array([1.7]))
    for row, symbol in zip(found, (x, y), strict=True):
        wanted = sp.lambdify((x, y, a), FORMULAS[0].diff(symbol))(*POINTS, 1.7)
        assert np.allclose(row, wanted, rtol=1e-14)
    assert sheet.depends(slopes) == {0, 1}


def test_no_real_value() -> None:
    sheet = SystemFormulas(SYSTEM)
    assert np.isnan(
        CompiledTerms([sheet.term_of(sp.sqrt(x))])(np.array([[-1.0], [0.0]]), np.ones(1))
    ).all()
