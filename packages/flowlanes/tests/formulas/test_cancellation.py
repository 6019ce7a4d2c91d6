"""Small formulas in lowest terms, as SymPy has them."""

import pytest
import sympy as sp

from flowlanes.formulas.cancellation import in_lowest_terms

x, y, z = sp.symbols("x y z", real=True)
FORMULAS = (
    x,
    -x - y,
    -2 * x - 4 * y,
    6 * x * y - 4 * x**2 * z,
    (x**2 - y**2) / (x - y),
    (x - y) / (y - x),
    (2 * x**2 * y + 2 * x * y) / (x + 1) / (x**2 + x * y),
    -(x**2) * (y - z) / (2 * x * z - 2 * x * y),
    (4 * x + 6) / (2 * y - 8),
    -3 / (x + y) + 1 / (x - y),
    x / (x + y) + y / (x + y) - 1,
    sp.sin(x) ** 2 * y / (sp.sin(x) * sp.cos(x) - sp.sin(x)),
    (x * sp.cos(x) - sp.cos(x)) / (1 - x),
    x / 2 + y / 3,
    (x / 2 + y) / (x + 2 * y),
    sp.sqrt(x**2 + x * y) * (x**2 - 1) / (x - 1),
    sp.sin(x + y) * (x**2 - 1) / (x + 1),
    (x * sp.sin(x - y) - y * sp.sin(y - x)) * sp.cos(y - x) / sp.sin(x - y),
    (z * sp.cos(x - y - z) ** 2 - z) / (2 * sp.cos(x - y - z) + 2 * sp.sin(x) ** 2 * sp.cos(x - y)),
    (sp.sin(x - y) ** 2 * z - sp.sin(x - y) * x) / (z**2 * sp.sin(x - y) - x * z) / sp.cos(x + y),
    sp.sin(2 * x + 2 * y) * (x**2 - 1) / (x + 1),
    sp.sin(x + sp.cos(y)) * (x**2 - 1) / (x + 1),
    1.5 * x / (x**2 + x),
)


@pytest.mark.parametrize("formula", FORMULAS, ids=str)
def test_lowest_terms_are_those_of_sympy(formula: sp.Expr) -> None:
    expected = sp.factor_terms(sp.cancel(formula))
    found = in_lowest_terms(formula)
    assert found == expected
    assert str(found) == str(expected)
