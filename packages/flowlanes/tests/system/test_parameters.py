"""Conditions on parameters, with rounding where equality is allowed."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.parameters import (
    conditions,
    parameter_values,
    parameters_by_symbol,
    require_admissible,
    require_finite,
    require_parameters,
    satisfies,
)
from flowlanes.system.system import Parameter, System

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


SYSTEM = System(
    name="trial",
    title="Trial",
    field=((c, sp.S.Zero),),
    parameters=(Parameter(a, "a", 2.0, admissible=(a > b,)), Parameter(b, "b", 1.0)),
)


def test_values_by_symbol_or_name_complete_the_defaults() -> None:
    assert parameter_values(SYSTEM, None) == {a: 2.0, b: 1.0}
    assert parameter_values(SYSTEM, {"a": "3.5"}) == {a: "3.5", b: 1.0}
    assert parameters_by_symbol(SYSTEM, {sp.Symbol("b"): 0.5}) == {b: 0.5}
    with pytest.raises(InputError, match="trial: no parameter q; it has a, b"):
        parameter_values(SYSTEM, {"q": 1.0})
    with pytest.raises(InputError, match="nothing: no parameter q; it has none"):
        require_parameters("nothing", (), ["q"])


@pytest.mark.parametrize(
    ("numbers", "values", "text"),
    [
        ({a: 0.5, b: 1.0}, None, "a = 0.5 is not admissible; a > b must hold"),
        ({a: 0.5, b: 1.0}, {a: "1/2", b: 1}, "a = 1/2 is not admissible; a > b must hold"),
        ({a: np.array([2.0, 0.25]), b: np.array([1.0])}, None, "a = 0.25 is not admissible"),
    ],
)
def test_the_first_inadmissible_value_is_named(numbers: Any, values: Any, text: str) -> None:
    with pytest.raises(InputError, match=f"trial: {text}"):
        require_admissible(SYSTEM, numbers, values)


def test_admissible_and_infinite_values() -> None:
    require_admissible(SYSTEM, {a: 2.0, b: 1.0})
    require_finite(SYSTEM, {a: 2.0, b: "1e300"})
    with pytest.raises(InputError, match="trial: b = inf must be a finite number"):
        require_finite(SYSTEM, {a: 2.0, b: float("inf")})
