"""Budgets: operations counted, refused before they are begun."""

from __future__ import annotations

import time

import pytest

from flowlanes.errors import InputError
from flowlanes.formulas.errors import EffortSpentError, OutOfReachError
from lawproof.proof.fields.budget import STEP, Budget, checked_effort
from lawproof.proof.fields.quotient_ring import QuotientRing


def sized(terms: int) -> list[int]:
    """Something with so many terms."""
    return [0] * terms


def test_products_and_steps_are_counted() -> None:
    budget = Budget(effort=10_000)
    budget.foresee(sized(20), sized(30))
    assert budget.used == 600 + STEP
    budget.spend(sized(45))
    assert budget.used == 645 + 2 * STEP
    assert budget.largest == 45


def test_the_last_operation_allowed_is_done_and_no_more() -> None:
    budget = Budget(effort=600 + STEP)
    budget.foresee(sized(20), sized(30))
    with pytest.raises(EffortSpentError, match="an effort of 800 term operations"):
        budget.charge(1)


def test_a_product_that_is_too_much_is_refused_before_it_is_made() -> None:
    budget = Budget(effort=10**6)
    field = QuotientRing(("x", "y"), budget)
    x, y = (field.generator(name) for name in field.names)
    power = field.integer_power(x + y + field.one, 60)
    began = time.perf_counter()
    with pytest.raises(EffortSpentError):
        field.multiply(power, power)
    assert time.perf_counter() - began < 0.1
    assert budget.used == budget.effort


def test_size_is_limited_as_well() -> None:
    budget = Budget(terms=10)
    with pytest.raises(OutOfReachError, match="11 terms exceeds the limit of 10"):
        budget.spend(sized(11))
    with pytest.raises(OutOfReachError, match="a product of polynomials"):
        budget.foresee(sized(1001), sized(2))


@pytest.mark.parametrize("effort", [0, -5])
def test_no_effort_is_refused(effort: int) -> None:
    with pytest.raises(InputError, match="positive number of term operations"):
        checked_effort(effort)
