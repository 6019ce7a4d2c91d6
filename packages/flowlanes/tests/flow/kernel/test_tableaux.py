"""Coefficients of the methods: what defines each of them, in exact arithmetic."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import numpy as np
import pytest
from scipy.integrate import DOP853

from flowlanes.flow.kernel.dop853_coefficients import weights
from flowlanes.flow.kernel.tableaux import (
    FINE,
    Explicit,
    arithmetic_and_method,
    explicit,
    explicit_fine,
    explicit_steady,
    gauss,
)

STAGES = pytest.mark.parametrize("stages", [1, 2, 4, 8, 16])

#: The tables have 240 bits.
SMALL = Fraction(1, 10**65)


@STAGES
def test_weights_and_nodes_integrate_powers(stages: int) -> None:
    """To the degree 2s − 1, and not one more."""
    method = gauss(stages)
    for power in range(2 * stages):
        total = sum(b * c**power for b, c in zip(method.b, method.c, strict=True))
        assert abs(total - Fraction(1, power + 1)) < SMALL
    power = 2 * stages
    total = sum(b * c**power for b, c in zip(method.b, method.c, strict=True))
    assert abs(total - Fraction(1, power + 1)) > Fraction(1, 10**25)


@STAGES
def test_rows_integrate_to_each_node(stages: int) -> None:
    method = gauss(stages)
    for c, row in zip(method.c, method.a, strict=True):
        for power in range(stages):
            total = sum(a * x**power for a, x in zip(row, method.c, strict=True))
            assert abs(total - c ** (power + 1) / (power + 1)) < SMALL


@STAGES
def test_rows_ahead_extrapolate(stages: int) -> None:
    """The polynomial of one step at the nodes of the next: powers go on; large factors occur."""
    method = gauss(stages)
    for c, row in zip(method.c, method.ahead, strict=True):
        for power in range(stages):
            total = sum(e * x**power for e, x in zip(row, method.c, strict=True))
            assert abs(total - (1 + c) ** power) < SMALL * 10**20


@STAGES
def test_the_highest_coefficient(stages: int) -> None:
    """Of the Legendre polynomials on [0, 1], whose leading coefficient is (2k)!/k!²."""
    method = gauss(stages)
    for power in range(stages - 1):
        total = sum(t * x**power for t, x in zip(method.top, method.c, strict=True))
        assert abs(total) < SMALL
    leading = Fraction(1)
    for k in range(1, stages):
        leading = leading * (2 * k - 1) * 2 / k
    total = sum(t * x ** (stages - 1) for t, x in zip(method.top, method.c, strict=True))
    assert abs(total - 1 / leading) < SMALL


@STAGES
def test_the_method_is_symmetric_and_symplectic(stages: int) -> None:
    """c and b are the same from both ends; b_i a_ij + b_j a_ji = b_i b_j."""
    method = gauss(stages)
    b, a = method.b, method.a
    assert all(abs(b[i] - b[-1 - i]) < SMALL for i in range(stages))
    assert all(abs(method.c[i] + method.c[-1 - i] - 1) < SMALL for i in range(stages))
    for i in range(stages):
        for j in range(stages):
            assert abs(b[i] * a[i][j] + b[j] * a[j][i] - b[i] * b[j]) < SMALL


def test_two_stages_as_printed() -> None:
    """Hairer, Nørsett, Wanner: a₁₂ = 1/4 − √3/6."""
    method = gauss(2)
    entry = Fraction(1, 4) - method.a[0][1]
    assert abs(entry**2 - Fraction(1, 12)) < SMALL
    assert abs(method.a[0][0] - Fraction(1, 4)) < SMALL
    assert all(abs(b - Fraction(1, 2)) < SMALL for b in method.b)


@pytest.mark.parametrize("table", [explicit, explicit_fine, explicit_steady])
def test_the_explicit_method_is_explicit(table: Callable[[], Explicit]) -> None:
    """Row i has i entries; results and estimates are of the same stages; sums to one and zero."""
    method = table()
    assert [len(row) for row in method.a] == list(range(12))
    assert len(method.b) == len(method.e3) == len(method.e5) == 12
    assert method.order == 8
    assert abs(sum(method.b) - 1) < Fraction(1, 10**14)
    assert abs(sum(method.e3)) < Fraction(1, 10**14)
    assert abs(sum(method.e5)) < Fraction(1, 10**14)


def test_the_fine_table_rounds_to_the_short_one() -> None:
    for fine, short in zip(explicit_fine().a, explicit().a, strict=True):
        for x, y in zip(fine, short, strict=True):
            assert abs(x - y) <= abs(y) * Fraction(1, 10**14) + Fraction(1, 10**16)


def test_the_short_table_is_that_of_scipy() -> None:
    table, stages = explicit(), len(DOP853.B)
    assert [[float(x) for x in row] for row in table.a] == [
        list(DOP853.A[i, :i]) for i in range(stages)
    ]
    for mine, other in ((table.b, DOP853.B), (table.e3, DOP853.E3), (table.e5, DOP853.E5)):
        assert [float(x) for x in mine] == list(other[:stages])


def _square(table: Explicit) -> np.ndarray:
    stages = len(table.b)
    return np.array([[*map(float, row), *[0.0] * (stages - len(row))] for row in table.a])


def test_the_steady_method_meets_the_conditions_of_order_8() -> None:
    table = explicit_steady()
    a, b = _square(table), np.array(table.b, float)
    for order in range(1, 9):
        np.testing.assert_allclose(weights(a, b, order), 1, atol=1e-14)
    assert np.abs(weights(a, b, 9) - 1).max() > 1e-3
    # estimates see errors from the sixth and from the seventh order on
    for estimate, order in ((table.e3, 5), (table.e5, 6)):
        e = np.array(estimate, float)
        assert np.abs(weights(a, e, order)).max() < 1e-13 * np.abs(e).max()
        assert np.abs(weights(a, e, order + 1)).max() > 1e-3


def test_the_steady_method_has_small_positive_weights() -> None:
    table = explicit_steady()
    assert min(table.b) == 0
    assert sum(b * b for b in table.b) < Fraction(16, 100)
    assert sum(b * b for b in explicit().b) > 57
    # in doubles, but their sums with powers of the nodes are those of the exact ones
    nodes = [sum(row) for row in table.a]
    for power in range(6):
        total = sum(b * c**power for b, c in zip(table.b, nodes, strict=True))
        assert abs(total - Fraction(1, power + 1)) < Fraction(1, 2**55)


def test_fine_tolerances_take_the_steady_method() -> None:
    assert arithmetic_and_method("double", FINE)[1] is explicit()
    assert arithmetic_and_method("double", FINE / 2)[1] is explicit_steady()
    assert arithmetic_and_method("quad", FINE / 2)[1] is explicit_fine()


def test_tables_are_made_once() -> None:
    assert gauss(4) is gauss(4)
    assert explicit() is explicit()
