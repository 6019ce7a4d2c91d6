"""The example of strange attractors."""

from __future__ import annotations

import sys
from pathlib import Path

import matplotlib
import numpy as np
import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def example():
    matplotlib.use("agg")
    sys.path.insert(0, str(EXAMPLES))
    try:
        import strange_attractors

        yield strange_attractors
    finally:
        sys.path.remove(str(EXAMPLES))


@pytest.fixture(scope="module")
def found(example):
    return [example.attractor_of(case, 60.0, 400) for case in example.CASES]


@pytest.mark.slow
def test_a_rattleback_is_attracted(found):
    stone = found[0].spectrum
    assert stone.chaotic
    assert stone.total.value < -stone.total.error
    assert 3 < stone.dimension[0] < 4
    assert [item.name for item, _ in stone.trivial] == ["γ² = 1", "energy", "flow"]


@pytest.mark.slow
def test_reversal_of_velocities(found):
    for each in found:
        turned = [" ".join(map(str, r.odd)) for r in each.reversors]
        assert turned == ["M_1 M_2 M_3", "M_3 gamma_1 gamma_2"]


@pytest.mark.slow
def test_sections_keep_to_their_level(found):
    for each in found:
        M, gamma = each.points[:, :3], each.points[:, 3:]
        assert np.abs(gamma[:, 0]).max() < 1e-12
        assert np.abs((gamma**2).sum(axis=1) - 1).max() < 1e-9
        assert np.ptp(M[:, 2]) > 1e-3


@pytest.mark.slow
def test_pictures(example, found, tmp_path):
    example.draw_all(found).savefig(tmp_path / "picture.png", dpi=50)
    assert (tmp_path / "picture.png").stat().st_size > 10_000


def test_words(example, found):
    told = "\n".join(map(example.summary, found))
    assert "λ3 = " in told
    assert "observed, not proven" in told
