"""A few starts at once: on their level, and distributed as those of the exact sampler."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.stats import ks_2samp

from flowlanes import InputError
from flowlanes.flow import level_sampler, resampled_level
from flowlanes.formulas.array_evaluation import values
from nonholonomic import from_catalogue

LEVELS = [
    ("chaplygin-ball", {"energy": 1.0, "area": 0.3}),
    ("unbalanced-ball", {"energy": 1.9493471982392048, "quadratic": 5.675720975160289}),
]


@pytest.mark.parametrize(("name", "level"), LEVELS)
def test_starts_are_on_the_level_and_depend_on_their_number_alone(
    name: str, level: dict[str, float]
) -> None:
    system = from_catalogue(name)
    drawn = resampled_level(system, level)
    points = drawn.draw(8, seed=3)
    laws = [law for law in system.integrals if law.name in level]
    numbers = values(system, [law.value for law in laws], points)
    assert numbers == pytest.approx(np.tile([level[law.name] for law in laws], (8, 1)), rel=1e-12)
    assert (drawn.draw(3, seed=3, first=5) == points[5:]).all()
    assert "resampled from 64 proposals" in drawn.description


@pytest.mark.parametrize(("name", "level"), LEVELS)
def test_the_distribution_is_that_of_the_exact_sampler(name: str, level: dict[str, float]) -> None:
    system = from_catalogue(name)
    few = resampled_level(system, level).draw(600, seed=1)
    exact = level_sampler(system, level).draw(600, seed=2)
    assert min(ks_2samp(few[:, k], exact[:, k]).pvalue for k in range(few.shape[1])) > 1e-3


def test_dense_candidates_alone_are_told_from_the_distribution() -> None:
    """The test above would notice a choice that prefers dense candidates too much."""
    name, level = LEVELS[1]
    system = from_catalogue(name)
    drawn = resampled_level(system, level)
    proposal = drawn.level.proposal
    rng = np.random.default_rng(0)
    candidates = proposal.weighted_points(rng.standard_normal((proposal.numbers, 6000)))
    assert candidates.which.size > 600
    density = drawn.level.density(candidates)
    heavy = candidates.states[:, np.argsort(-density)[: density.size // 2]]
    exact = level_sampler(system, level).draw(600, seed=2)
    assert min(ks_2samp(heavy[k], exact[:, k]).pvalue for k in range(len(heavy))) < 1e-3


def test_an_empty_level_says_what_is_reached() -> None:
    system = from_catalogue("chaplygin-ball")
    with pytest.raises(InputError, match="is empty"):
        resampled_level(system, {"energy": -1.0}).draw(2)
