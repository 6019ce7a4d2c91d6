"""Random points of a level with the volume of each, and the maximum of a quantity."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from ...system.arrays import FloatArray, IntArray
from .counter_rng import counter_normals
from .fibration import Fibration

#: Seed of the trials, a number that users are unlikely to choose.
_SEED = 0x9E3779B97F4A7C15
#: Number of initial trials; the best ones are refined in several rounds and directions.
_PILOT = 1 << 12
_BEST = 64
_ROUNDS = 24
_AROUND = 4


@dataclass(frozen=True)
class WeightedPoints:
    """Points of a level with weights.

    Attributes
    ----------
    which : int array (n,)
        Index of the proposal of each point, in increasing order.
    places : array (y, n)
        Unit vectors and angles; see :class:`~flowlanes.flow.sampling.fibration.Fibration`.
    states : array (size, n)
    volume : array (n,)
        δ(relations and given integrals) dx over the density of the proposals, up to a constant.
    """

    which: IntArray
    places: FloatArray
    states: FloatArray
    volume: FloatArray


class Proposal(Protocol):
    """Map from normal random numbers to weighted points of a level."""

    @property
    def fibration(self) -> Fibration:
        """Fibration of the level over its base."""

    @property
    def numbers(self) -> int:
        """Number of normal random numbers per proposal."""

    @property
    def most(self) -> float:
        """Approximate number of points of largest density in a proposal."""

    def weighted_points(self, gauss: FloatArray) -> WeightedPoints:
        """Points of proposals (numbers, k)."""

    def nearby_proposals(self, gauss: FloatArray, fresh: FloatArray) -> FloatArray:
        """Proposals near the points of `gauss` (y, k), from new random numbers (numbers, k)."""


@dataclass(frozen=True)
class RayProposal:
    """Ends of random rays over random base points, for a level without an additional condition."""

    fibration: Fibration
    parameters: FloatArray

    @property
    def numbers(self) -> int:
        """Number of normal random numbers per proposal."""
        return self.fibration.numbers

    @property
    def most(self) -> float:
        """One, because a ray has one end."""
        return 1.0

    def weighted_points(self, gauss: FloatArray) -> WeightedPoints:
        """Points of proposals (numbers, k)."""
        places = self.fibration.uniform_points(gauss)
        rays = self.fibration.over(places, self.parameters)
        real = np.flatnonzero(rays.volume > 0)
        states = np.ascontiguousarray(rays.states[:, real])
        return WeightedPoints(real, places[:, real], states, rays.volume[real])

    def nearby_proposals(self, gauss: FloatArray, fresh: FloatArray) -> FloatArray:
        """The normal random numbers themselves, unchanged."""
        return gauss


def maximise(
    fibration: Fibration,
    height: Callable[[FloatArray], tuple[FloatArray, FloatArray]],
    start: Callable[[FloatArray, FloatArray], FloatArray],
    many: int,
    first: FloatArray | None = None,
) -> tuple[float, FloatArray]:
    """Largest value of a quantity that was found, and its location.

    Parameters
    ----------
    fibration : Fibration
    height : callable
        Random numbers (many, k) ↦ places (y, n) and values (n,), for any n.
    start : callable
        (places as normal numbers (y, k), normal numbers (many, k)) ↦ proposals near these points.
    many : int
    first : array (y, k), optional
        Initial points besides the random ones.

    Returns
    -------
    float, array (y,)
        Value and location; −∞ if no proposal has a point.
    """
    # Random search: the best points are perturbed with decreasing width, which needs no gradients
    # and finds several maxima.
    places, values = height(counter_normals(_SEED, np.arange(_PILOT), np.zeros(_PILOT), many))
    if first is not None:
        more = height(start(fibration.gauss(first), _fresh(first.shape[1], _ROUNDS + 1, many)))
        places, values = np.append(places, more[0], axis=1), np.append(values, more[1])
    for turn in range(_ROUNDS):
        if not values.size:
            return -np.inf, np.zeros(fibration.numbers)
        best = np.argsort(-values, kind="stable")[:_BEST]
        places, values = places[:, best], values[best]
        around = np.repeat(fibration.gauss(places), _AROUND, axis=1)
        noise = _fresh(around.shape[1], turn + 1, fibration.numbers + many)
        moved = around + 0.4 * 0.7**turn * noise[: fibration.numbers]
        more = height(start(moved, noise[fibration.numbers :]))
        places, values = np.append(places, more[0], axis=1), np.append(values, more[1])
    top = int(np.argmax(values))
    return float(values[top]), places[:, top]


def _fresh(count: int, turn: int, many: int) -> FloatArray:
    return counter_normals(_SEED, np.arange(count), np.full(count, turn), many)
