"""Random numbers by their place: the known answers of Philox, distributions, independence."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from flowlanes.errors import InputError
from flowlanes.flow.sampling.counter_rng import counter_normals, philox, uniforms


@pytest.mark.parametrize(
    ("key", "word", "wanted"),
    [
        ((0, 0), (0, 0, 0, 0), (0x6627E8D5, 0xE169C58D, 0xBC57AC4C, 0x9B00DBD8)),
        (
            (0xFFFFFFFF, 0xFFFFFFFF),
            (0xFFFFFFFF,) * 4,
            (0x408F276D, 0x41C83B0E, 0xA20BC7C6, 0x6D5451FD),
        ),
        (
            (0xA4093822, 0x299F31D0),
            (0x243F6A88, 0x85A308D3, 0x13198A2E, 0x03707344),
            (0xD16CFE09, 0x94FDCCEB, 0x5001E420, 0x24126EA1),
        ),
    ],
)
def test_known_answers(
    key: tuple[int, int], word: tuple[int, int, int, int], wanted: tuple[int, ...]
) -> None:
    assert tuple(int(part) for part in philox(key, word)) == wanted


def test_numbers_depend_on_their_place_alone() -> None:
    members, attempts = np.arange(100), np.repeat([3, 4], 50)
    whole = counter_normals(7, members, attempts, 5)
    assert (counter_normals(7, members[61:64], attempts[61:64], 5) == whole[:, 61:64]).all()
    assert (counter_normals(7, members[:1], attempts[:1], 5) == whole[:, :1]).all()


def test_seeds_members_and_attempts_differ() -> None:
    seen = [
        float(uniforms(seed, [member], [attempt], 1)[0, 0])
        for seed in (0, 1, 2**40)
        for member in (0, 1, 2**33)
        for attempt in (0, 1, 2)
    ]
    assert len(set(seen)) == 27


def test_distributions() -> None:
    members = np.arange(50_000)
    flat = uniforms(1, members, np.zeros(50_000), 3)
    bell = counter_normals(2, members, np.zeros(50_000), 3)
    assert flat.min() > 0 and flat.max() < 1
    for row in flat:
        assert stats.kstest(row, "uniform").pvalue > 1e-4
    for row in bell:
        assert stats.kstest(row, "norm").pvalue > 1e-4
    assert np.abs(np.corrcoef(bell) - np.eye(3)).max() < 0.02


def test_a_seed_out_of_range_is_refused() -> None:
    with pytest.raises(InputError, match="seed -1: it must be a whole number from 0"):
        uniforms(-1, [0], [0], 1)
