"""Conditions on parameters, with rounding where equality is allowed."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import sympy as sp

from chaplygin.core.parameters import conditions, satisfies
from chaplygin.core.system import Parameter

a, b, c = sp.symbols("a b c", real=True)


@pytest.mark.parametrize(
    ("condition", "numbers", "holds"),
    [
        (a > 0, {a: 0.0}, False),
        (a > b, {a: 1.0, b: np.nextafter(1.0, 0)}, True),
        (c <= a + b, {a: 0.1, b: 0.2, c: 0.1 + 0.2}, True),
        (c <= a + b, {a: 1e-10, b: 2e-10, c: 3e-10 * (1 + 1e-14)}, True),
        (c <= a + b, {a: 1e-10, b: 2e-10, c: 3e-10 * (1 + 1e-9)}, False),
        (a >= 0, {a: 0.0}, True),
        (a >= 0, {a: -1e-300}, False),
        (sp.Ne(a, 0), {a: 0.0}, False),
        (sp.true, {}, True),
        (c > a, {a: np.array([1.0, 2.0, 3.0]), c: 2.0}, [True, False, False]),
        (c >= a, {a: np.array([1.0, 2.0, 3.0]), c: 2.0}, [True, True, False]),
    ],
    ids=str,
)
def test_conditions(condition: Any, numbers: dict[sp.Symbol, Any], holds: Any) -> None:
    assert np.array_equal(satisfies(condition, numbers), holds)


def test_conditions_on_one_parameter_come_first() -> None:
    first = Parameter(a, "a", 1.0, admissible=(a > b, a > 0))
    second = Parameter(b, "b", 0.5, admissible=(b > 0,))
    assert conditions((first, second)) == [(first, a > 0), (second, b > 0), (first, a > b)]
