"""Lists, products and random starts."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from flowlanes.errors import InputError
from flowlanes.flow.ensembles.members import Members, from_lists, grid, random_starts, single


def test_a_list_goes_row_by_row() -> None:
    everyone = from_lists(M=[[1, 2, 3], [4, 5, 6]], m=[7, 8])
    assert everyone.size == 2
    values, points = everyone.rows(1, 2)
    assert values["M"].tolist() == [[4, 5, 6]]
    assert values["m"].tolist() == [8]
    assert points is None


def test_a_grid_has_every_combination() -> None:
    everyone = grid(m=[1, 2], R=[3, 4, 5])
    values, _ = everyone.rows(0, 6)
    assert values["m"].tolist() == [1, 1, 1, 2, 2, 2]
    assert values["R"].tolist() == [3, 4, 5, 3, 4, 5]


def test_a_product_is_associative_and_its_last_factor_fastest() -> None:
    a, b, c = (
        from_lists(x=[1, 2]),
        from_lists(y=[3, 4], z=[5, 6]),
        random_starts(2, {"energy": 1.0}, seed=7),
    )
    for everyone in (a * b * c, a * (b * c)):
        assert everyone.size == 8
        values, points = everyone.rows(2, 7)
        assert values["x"].tolist() == [1, 1, 2, 2, 2]
        assert values["y"].tolist() == [4, 4, 3, 3, 4]
        assert values["z"].tolist() == [6, 6, 5, 5, 6]
        assert points.tolist() == [0, 1, 0, 1, 0]


def test_rows_are_the_same_in_any_blocks() -> None:
    everyone = (
        grid(m=np.arange(7.0)) * from_lists(x=np.arange(5.0)) * random_starts(3, {"energy": 1.0})
    )
    whole, points = everyone.rows(0, everyone.size)
    for first in range(0, everyone.size, 11):
        last = min(first + 11, everyone.size)
        some, few = everyone.rows(first, last)
        assert all(np.array_equal(some[name], whole[name][first:last]) for name in whole)
        assert np.array_equal(few, points[first:last])


def test_many_members_need_no_memory() -> None:
    everyone = random_starts(10**9, {"energy": 1.0}) * grid(m=np.arange(1000.0))
    assert everyone.size == 10**12
    values, points = everyone.rows(10**12 - 2, 10**12)
    assert values["m"].tolist() == [998, 999]
    assert points.tolist() == [10**9 - 1] * 2


def test_they_say_what_they_are() -> None:
    everyone = random_starts(5, {"energy": 1.0, "area": 0.5}, seed=3) * grid(m=[1, 2])
    assert str(everyone) == "5 drawn on energy = 1.0, area = 0.5 (seed 3) × 2 of m"


@pytest.mark.parametrize(
    ("made", "sentence"),
    [
        (from_lists, "at least one is needed"),
        (grid, "at least one is needed"),
        (lambda: from_lists(m=[]), "at least one is needed"),
        (lambda: random_starts(0, {"energy": 1.0}), "at least one is needed"),
        (lambda: random_starts("few", {}), "count must be a whole number, not the text 'few'"),
        (lambda: from_lists(m="abc"), "m must be numbers in an array or in nested sequences"),
        (lambda: single(M=[[1], [1, 2]]), "M must be numbers in an array or in nested sequences"),
        (lambda: from_lists(m=[1, 2], R=[1]), r"different lengths \(m 2, R 1\)"),
        (lambda: single(m=float("nan")), "m must be finite numbers"),
        (lambda: single(m=1) * grid(m=[1, 2]), "m is given twice"),
        (lambda: random_starts(1, {}) * random_starts(1, {}), "starts are drawn twice"),
    ],
    ids=[
        "list",
        "grid",
        "empty",
        "drawn",
        "few",
        "text",
        "ragged",
        "lengths",
        "nan",
        "twice",
        "drawn-twice",
    ],
)
def test_mistakes_are_told(made: Any, sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        made()


def test_one_is_one() -> None:
    everyone: Members = single(M=(1, 2, 3), m=4)
    assert everyone.size == 1
    assert everyone.rows(0, 1)[0]["M"].tolist() == [[1, 2, 3]]
