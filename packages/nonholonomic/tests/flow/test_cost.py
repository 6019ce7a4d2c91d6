"""Computations that no machine has the time or the room for."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from flowlanes.flow.cost import Pace, TooMuchError, in_words, require_room
from flowlanes.flow.ensembles.members import grid, single
from flowlanes.flow.ensembles.run import ensemble
from flowlanes.flow.validation import too_extreme
from nonholonomic.catalogue import from_catalogue

BALL = from_catalogue("chaplygin-ball")


def test_pace() -> None:
    slow = Pace(time.perf_counter() - 2.0)
    slow.check(0.5, "it")
    with pytest.raises(TooMuchError, match=r"^it would take about 6e\+02 years: in 2 s "):
        slow.check(1e-10, "it")
    with pytest.raises(TooMuchError, match="about endless years"):
        slow.check(0.0, "it")
    Pace().check(1e-300, "what has just begun")


def test_room(tmp_path: Path) -> None:
    require_room(1e3, None, "it")
    require_room(1e3, tmp_path / "new" / "store.zarr", "it")
    with pytest.raises(TooMuchError, match="it would take 867 EiB of disk, and there are "):
        require_room(1e21, tmp_path / "new", "it")
    with pytest.raises(TooMuchError, match="of memory, and there are "):
        require_room(1e21, None, "it")


@pytest.mark.parametrize(
    ("size", "words"),
    [(5.0, "5 bytes"), (2048.0, "2 KiB"), (3.5e9, "3.26 GiB")],
)
def test_sizes_in_words(size: float, words: str) -> None:
    assert in_words(size) == words


def test_an_ensemble_that_is_never_over() -> None:
    spun = single(omega=(0.7, 0.4, 1.1), gamma=(0.2, -0.3, 0.93)) * grid(m=[1.0, 2.0])
    with pytest.raises(TooMuchError, match=r"would take about 1e\+301 steps"):
        ensemble(BALL, spun, [0.0, 1e300])


def test_numbers_to_blame() -> None:
    def product(numbers: list[float]) -> bool:
        return abs(numbers[0]) * abs(numbers[1]) * abs(numbers[2]) < 1e250

    assert too_extreme([1e200, 3.0, 1e100], product) == [0]
    assert too_extreme([-1e200, 1e200, 1.0], product) == [0] or too_extreme(
        [-1e200, 1e200, 1.0], product
    ) == [1]
    assert too_extreme([1e20, 1e20, 1.0], lambda _: False) == []
    assert too_extreme([0.0, 1.0], lambda _: False) == []
