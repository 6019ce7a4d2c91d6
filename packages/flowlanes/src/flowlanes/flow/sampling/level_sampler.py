"""Random start points, uniformly distributed on a level of the integrals.

Uniform means with respect to the measure of :mod:`flowlanes.flow.sampling.level`.  Points are drawn
by rejection sampling, so they are independent and exactly distributed; each depends only on the
seed and its own index.  The bound of the density that this needs takes a second or more to find;
:mod:`flowlanes.flow.sampling.resampling` does without it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial

import numpy as np

from ...arguments import Parameters, arguments_checked
from ...errors import InputError
from ...formulas.array_evaluation import parameter_rows
from ...system.arrays import BoolArray, FloatArray, IntArray
from ...system.system import System
from ..cost import require_room
from ..devices.threads import map_in_threads
from .counter_rng import counter_normals
from .great_circles import GreatCircleProposal
from .level import MINDING_RESULTS, TRIAL, Level, prepare_level
from .level_integrals import level_label
from .proposals import maximise

#: Number of attempts computed together.
_BATCH = 1 << 14
#: Bound of the density, relative to the largest value found.
_MARGIN = 1.15
#: Number of attempts for one point after which the level counts as too thin.
_MOST_ATTEMPTS = 10**6


@arguments_checked
def sample_level(
    system: System,
    count: int,
    level: Mapping[str, float],
    parameters: Parameters = None,
    *,
    seed: int = 0,
    first: int = 0,
) -> FloatArray:
    """Draw points uniformly on a level of the integrals.

    Parameters
    ----------
    system : System
    count : int
        Number of points.
    level : mapping of str to float
        Values of integrals by name; the relations of the system are always satisfied.
    parameters : mapping of Symbol or name to float, optional
        Values that replace the defaults.
    seed : int
    first : int
        Number of the first point; point k depends only on `seed` and k.

    Returns
    -------
    array (count, size)
        States in flat order.

    Raises
    ------
    InputError
        If an integral is unknown or not valid for these parameters, or if the level is empty (the
        message contains the possible values) or not bounded.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> a, b, c = sp.symbols("a b c", real=True)
    >>> energy = flowlanes.Integral("energy", a**2 + b**2 / 2 + c**2 / 3)
    >>> field = {a: -b * c, b: 4 * a * c, c: -3 * a * b}
    >>> top = flowlanes.System("top", "Euler's top", field, laws=(energy,))
    >>> flowlanes.sample_level(top, 1000, {"energy": 2.0}, seed=1).shape
    (1000, 3)
    """
    return level_sampler(system, level, parameters).draw(count, seed=seed, first=first)


@dataclass(frozen=True)
class LevelSampler:
    """Level of the integrals for random points; see `level_sampler`.

    Attributes
    ----------
    level : Level
    """

    level: Level
    _density_bound: float
    _tries: int

    @property
    def measure(self) -> str:
        """The measure by which points are drawn, with its source."""
        return self.level.measure

    @property
    def invariant(self) -> bool:
        """Whether that measure is invariant under the motion."""
        return self.level.invariant

    @MINDING_RESULTS
    def draw(self, count: int, *, seed: int = 0, first: int = 0) -> FloatArray:
        """Points `first` to `first` + `count`; array (count, size).  See :func:`sample_level`."""
        if count < 0:
            raise InputError(f"count = {count}: it must not be negative")
        size = len(self.level.system.symbols)
        # Drawing needs as much memory again as the points themselves.
        require_room(16.0 * count * size, None, f"{count:,} starts at once")
        points = np.empty((count, size))
        pending, attempt, tries = np.arange(count), 0, self._tries
        while pending.size:
            attempts = partial(self._attempts, seed, first + pending, attempt, tries)
            parts = map_in_threads(attempts, pending.size)
            done = np.concatenate([part for _, part in parts])
            points[pending[done]] = np.concatenate([states for states, _ in parts])
            pending, attempt = pending[~done], attempt + tries
            tries = min(tries + 1, _BATCH)
            if attempt > _MOST_ATTEMPTS:
                raise InputError(
                    f"{self.level.system.name}: the level {level_label(self.level.values)} is too "
                    f"thin: no point of it was met in {attempt} attempts"
                )
        return points

    def _attempts(
        self, seed: int, members: IntArray, attempt: int, tries: int, low: int, high: int
    ) -> tuple[FloatArray, BoolArray]:
        """First accepted attempt for each of the members from `low` to `high`."""
        step = _BATCH // tries
        parts = [
            self._first(seed, members[start : min(start + step, high)], attempt, tries)
            for start in range(low, high, step)
        ]
        return np.concatenate([s for s, _ in parts]), np.concatenate([d for _, d in parts])

    def _first(
        self, seed: int, members: IntArray, attempt: int, tries: int
    ) -> tuple[FloatArray, BoolArray]:
        """First accepted attempt of each member, and the members that have one."""
        from scipy.special import ndtr

        many = self.level.proposal.numbers
        owners = np.repeat(members, tries)
        gauss = counter_normals(
            seed, owners, attempt + np.tile(np.arange(tries), members.size), many + 1
        )
        weighted_points = self.level.proposal.weighted_points(gauss[:many])
        density = self.level.density(weighted_points)
        # A uniform number below the bound selects a point with the probability density/bound.
        thresholds = self._density_bound * ndtr(gauss[many])
        # At most one point of a proposal is accepted, each with the probability of its density.
        rank = np.arange(weighted_points.which.size) - np.searchsorted(
            weighted_points.which, weighted_points.which
        )
        hit = np.zeros(weighted_points.which.size, dtype=bool)
        passed = np.zeros(owners.size)
        for turn in range(rank.max(initial=-1) + 1):
            here = np.flatnonzero(rank == turn)
            throw = weighted_points.which[here]
            # The intervals of the points of a proposal are adjacent, so at most one of them
            # contains the threshold.
            below = passed[throw] <= thresholds[throw]
            passed[throw] += density[here]
            hit[here] = below & (thresholds[throw] < passed[throw])
        if (passed > self._density_bound).any():
            raise InputError(
                f"{self.level.system.name}: the density of the level "
                f"{level_label(self.level.values)} has no bound that could be found: it lies next "
                "to a critical level"
            )
        accepted = np.flatnonzero(hit)
        owner, first = np.unique(weighted_points.which[accepted] // tries, return_index=True)
        done = np.zeros(members.size, dtype=bool)
        done[owner] = True
        states = np.ascontiguousarray(weighted_points.states[:, accepted[first]])
        return self.level.onto_level(states).T, done


@arguments_checked
@MINDING_RESULTS
def level_sampler(
    system: System,
    level: Mapping[str, float],
    parameters: Parameters = None,
) -> LevelSampler:
    """Prepare a level for repeated draws of points; see :func:`sample_level`.

    Parameters
    ----------
    system : System
    level : mapping of str to float
        Values of integrals by name.
    parameters : mapping of Symbol or name to number, optional
        Values that replace the defaults.

    Returns
    -------
    LevelSampler
        Its method ``draw`` returns states (n, size) in flat order.

    Raises
    ------
    InputError
        If an integral is unknown, or the level has no points.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> a, b, c = sp.symbols("a b c", real=True)
    >>> energy = flowlanes.Integral("energy", a**2 + b**2 / 2 + c**2 / 3)
    >>> field = {a: -b * c, b: 4 * a * c, c: -3 * a * b}
    >>> top = flowlanes.System("top", "Euler's top", field, laws=(energy,))
    >>> sampler = flowlanes.flow.level_sampler(top, {"energy": 2.0})
    >>> sampler.draw(5, seed=1).shape
    (5, 3)
    """
    values = parameter_rows(system, parameters, 1)[0]
    return sampler_of(prepare_level(system, level, values))


def sampler_of(level: Level) -> LevelSampler:
    """The exact sampler of a prepared level; raises InputError if the level has no point."""
    _require_points(level)
    return _with_bound_on_density(level)


def _require_points(level: Level) -> None:
    """Raise an error if the level has no point; the message names the values that are reached."""
    system, fibration, values = level.system, level.proposal.fibration, level.parameters

    def excess(gauss: FloatArray) -> tuple[FloatArray, FloatArray]:
        places = fibration.uniform_points(gauss)
        return places, fibration.over(places, values).excess

    def same(gauss: FloatArray, _: FloatArray) -> FloatArray:
        return gauss

    # The minimum of the quadratic integral over all base points is found by maximization of the
    # excess.
    spare, top = maximise(fibration, excess, same, fibration.numbers)
    if not spare > 0:
        names = {c.name for c in (fibration.quadratic, *fibration.further)}
        raise _empty(
            system,
            level.values,
            names,
            f"{fibration.quadratic.name} is at least {fibration.quadratic.target - spare:.6g}",
        )
    if not isinstance(level.proposal, GreatCircleProposal):
        return
    slice_ = level.proposal
    (further,) = fibration.further

    def height_of(sign: float) -> Callable[[FloatArray], tuple[FloatArray, FloatArray]]:
        def height(gauss: FloatArray) -> tuple[FloatArray, FloatArray]:
            places = fibration.uniform_points(gauss)
            difference = sign * slice_.value(places)[0]
            real = np.isfinite(difference)
            return places[:, real], difference[real]

        return height

    low, high = (
        further.target
        + sign * maximise(fibration, height_of(sign), same, fibration.numbers, top[:, None])[0]
        for sign in (-1.0, 1.0)
    )
    if not low < further.target < high:
        raise _empty(
            system,
            level.values,
            {further.name},
            f"{further.name} lies between {low:.6g} and {high:.6g}",
        )


def _empty(system: System, level: Mapping[str, float], names: set[str], reach: str) -> InputError:
    others = {name: value for name, value in level.items() if name not in names}
    condition = f"with {level_label(others)} " if others else ""
    return InputError(f"{system.name}: the level {level_label(level)} is empty: {condition}{reach}")


def _with_bound_on_density(level: Level) -> LevelSampler:
    """The sampler of a level, with a bound of the total density of the points of one proposal."""
    proposal = level.proposal

    def height(gauss: FloatArray) -> tuple[FloatArray, FloatArray]:
        weighted_points = proposal.weighted_points(gauss)
        return weighted_points.places, level.density(weighted_points)

    trial = counter_normals(0, np.arange(TRIAL), np.zeros(TRIAL), proposal.numbers)
    top, _ = maximise(proposal.fibration, height, proposal.nearby_proposals, proposal.numbers)
    bound = _MARGIN * proposal.most * top
    share = height(trial)[1].sum() / (TRIAL * bound)
    if not np.isfinite(share):
        raise level.too_far()
    # Half of the average number of attempts per point, so that few are superfluous.
    tries = int(np.clip(0.5 / max(share, 1 / _BATCH), 1, _BATCH))
    return LevelSampler(level, bound, tries)
