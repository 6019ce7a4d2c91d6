"""Start points drawn uniformly on a level of the integrals.

Uniform means: by the invariant measure where one is known, else by the surface measure of the
level in the space of the state.  With δ-functions the invariant measure of a level is
ρ ∏ δ(relations) ∏ δ(held integrals) dx, that is ρ / √det(G Gᵀ) times the surface measure, the rows
of G being the gradients of relations and held integrals (the Gelfand–Leray form).

Points are drawn by rejection, so that they are independent and their distribution exact; each
depends on the seed and its own number alone.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ...arguments import Parameters, arguments_checked
from ...core.laws import Measure
from ...core.system import System
from ...core.vectors import to_components
from ...errors import InputError
from ...formulas.compiled import Compiled, SystemFormulas
from ...formulas.evaluate import parameter_rows
from ..cost import require_room
from .counter_rng import counter_normals
from .fibration import Fibration
from .find_fibration import find_fibration
from .great_circles import GreatCircleProposal
from .held_integrals import level_label, measure_label, measures, validate_level
from .proposals import Proposal, RayProposal, WeightedPoints, maximise

__all__ = ["LevelSampler", "level_sampler", "sample_level"]

#: Attempts looked at together.
_BATCH = 1 << 14
#: What is put on top of the largest density that was met.
_MARGIN = 1.15
#: Attempts from which their yield is estimated.
_TRIAL = 1 << 11
#: Attempts for one point after which the level counts as too thin.
_PATIENCE = 10**6
#: Newton steps by which a point is settled on its level.
_NEWTON = 2


@arguments_checked
def sample_level(
    system: System,
    count: int,
    level: Mapping[str, float],
    parameters: Parameters = None,
    *,
    seed: int = 0,
    first: int = 0,
) -> Any:
    """Points drawn uniformly on a level of the integrals.

    Parameters
    ----------
    system : System
    count : int
        How many.
    level : mapping of str to float
        Values of the held integrals by name; the relations of the system hold anyway.
    parameters : mapping of Symbol or name to float, optional
        Values that replace the defaults.
    seed : int
    first : int
        Number of the first point: point k depends on `seed` and k alone.

    Returns
    -------
    array (count, size)
        States in flat order.

    Raises
    ------
    InputError
        If an integral is unknown or does not hold at these parameters, if the level is empty (the
        message names the values that are reached) or not bounded.

    Examples
    --------
    >>> import chaplygin as ch
    >>> ball = ch.from_catalogue("unbalanced-ball")
    >>> ch.sample_level(ball, 1000, {"energy": 2.0}, seed=1).shape
    (1000, 6)
    """
    return level_sampler(system, level, parameters).draw(count, seed=seed, first=first)


@dataclass(frozen=True)
class LevelSampler:
    """A level of the integrals from which points can be drawn; made by `prepared`.

    Attributes
    ----------
    system : System
    values : mapping of str to float
        The held integrals.
    parameters : array (p,)
    measure : str
        Which measure the points are drawn by: the name of the invariant measure and its source,
        or "surface measure".
    invariant : bool
        Whether it is invariant under the motion.
    """

    system: System
    values: Mapping[str, float]
    parameters: Any
    measure: str
    invariant: bool
    _thrower: Proposal
    _held: Compiled
    _targets: Any
    _slopes: Compiled
    _density: Compiled | None
    _bound: float
    _tries: int

    def draw(self, count: int, *, seed: int = 0, first: int = 0) -> Any:
        """Points `first` to `first` + `count`; array (count, size).  See :func:`draw`."""
        if count < 0:
            raise InputError(f"count = {count}: it must not be negative")
        size = len(self.system.symbols)
        # beside the points, as many numbers again while they are drawn
        require_room(16.0 * count * size, None, f"{count:,} starts at once")
        found = np.empty((count, size))
        pending, attempt, tries = np.arange(count), 0, self._tries
        while pending.size:
            left = []
            for start in range(0, pending.size, _BATCH // tries):
                some = pending[start : start + _BATCH // tries]
                states, done = self._first(seed, first + some, attempt, tries)
                found[some[done]] = states
                left.append(some[~done])
            pending, attempt = np.concatenate(left), attempt + tries
            tries = min(tries + 1, _BATCH)
            if attempt > _PATIENCE:
                raise InputError(
                    f"{self.system.name}: the level {level_label(self.values)} is too thin: no "
                    f"point of it was met in {attempt} attempts"
                )
        return found

    def _first(self, seed: int, members: Any, attempt: int, tries: int) -> tuple[Any, Any]:
        """The first accepted of some attempts of each member, and which members have one."""
        from scipy.special import ndtr

        many = self._thrower.numbers
        owners = np.repeat(members, tries)
        gauss = counter_normals(
            seed, owners, attempt + np.tile(np.arange(tries), members.size), many + 1
        )
        spots = self._thrower.spots(gauss[:many])
        density = self.density(spots)
        dice = self._bound * ndtr(gauss[many])
        # of the points of a throw at most one is taken, each as often as its density says
        rank = np.arange(spots.which.size) - np.searchsorted(spots.which, spots.which)
        hit = np.zeros(spots.which.size, dtype=bool)
        passed = np.zeros(owners.size)
        for turn in range(rank.max(initial=-1) + 1):
            here = np.flatnonzero(rank == turn)
            throw = spots.which[here]
            below = passed[throw] <= dice[throw]
            passed[throw] += density[here]
            hit[here] = below & (dice[throw] < passed[throw])
        if (passed > self._bound).any():
            raise self._beyond()
        taken = np.flatnonzero(hit)
        owner, first = np.unique(spots.which[taken] // tries, return_index=True)
        done = np.zeros(members.size, dtype=bool)
        done[owner] = True
        return self._settled(np.ascontiguousarray(spots.states[:, taken[first]])).T, done

    def _beyond(self) -> InputError:
        return InputError(
            f"{self.system.name}: the density of the level {level_label(self.values)} has no bound "
            "that could be found: it lies next to a critical level"
        )

    def density(self, spots: WeightedPoints) -> Any:
        """The density to be drawn by, relative to that of the throws."""
        return spots.volume * self._weight(spots.states)

    def _weight(self, states: Any) -> Any:
        """The density to be drawn by, relative to ∏ δ(relations) ∏ δ(held integrals) dx."""
        if self._density is not None:
            return np.abs(self._density(states, self.parameters)[0])
        slopes = self._gradients(states)
        return np.sqrt(np.linalg.det(slopes @ np.swapaxes(slopes, 1, 2)))

    def _gradients(self, states: Any) -> Any:
        size, k = states.shape
        flat = self._slopes(states, self.parameters).T
        return np.ascontiguousarray(flat).reshape(k, self._targets.size, size)

    def _settled(self, states: Any) -> Any:
        """States moved onto the level along the shortest way, by Newton's method."""
        for _ in range(_NEWTON):
            defect = self._held(states, self.parameters) - self._targets[:, None]
            slopes = self._gradients(states)
            gram = slopes @ np.swapaxes(slopes, 1, 2)
            share = np.linalg.solve(gram, np.ascontiguousarray(defect.T)[:, :, None])
            states = states - (np.swapaxes(slopes, 1, 2) @ share)[:, :, 0].T
        return states


def level_sampler(
    system: System,
    level: Mapping[str, float],
    parameters: Parameters = None,
) -> LevelSampler:
    """A level from which points can be drawn again and again; see :func:`draw`."""
    values = parameter_rows(system, parameters, 1)[0]
    validate_level(system, level, values)
    sheet = SystemFormulas(system)
    made = find_fibration(system, sheet, level, values)
    thrower = _thrower(system, sheet, made, level, values)
    law, density = _density(system, sheet, level, thrower, values)
    conditions = [sheet.read(to_components(relation)) for relation in system.relations]
    held = {law.name: sheet.read(law.value) for law in system.integrals if law.name in level}
    conditions += [held[name] for name in level]
    blank = LevelSampler(
        system=system,
        values=dict(level),
        parameters=values,
        measure=measure_label(law),
        invariant=law is not None,
        _thrower=thrower,
        _held=Compiled(conditions),
        _targets=np.array([0.0] * len(system.relations) + [float(v) for v in level.values()]),
        _slopes=Compiled([term for row in sheet.slopes(conditions) for term in row]),
        _density=density,
        _bound=np.inf,
        _tries=1,
    )
    return _bounded(blank)


def _density(
    system: System,
    sheet: SystemFormulas,
    level: Mapping[str, float],
    thrower: Proposal,
    values: Any,
) -> tuple[Measure | None, Compiled | None]:
    """The invariant measure that holds here and has one sign on the level, and its density."""
    states = thrower.spots(
        counter_normals(0, np.arange(_TRIAL), np.zeros(_TRIAL), thrower.numbers)
    ).states
    for law in measures(system, level, values):
        density = Compiled([sheet.read(law.value)])
        signs = np.sign(density(states, values))
        if signs.size and (np.isfinite(signs) & (signs == signs[0, 0])).all() and signs.all():
            return law, density
    return None, None


def _thrower(
    system: System, sheet: SystemFormulas, made: Fibration, level: Mapping[str, float], values: Any
) -> Proposal:
    """What throws points onto the level; refuse a level that is empty."""

    def room(gauss: Any) -> tuple[Any, Any]:
        places = made.normed(gauss)
        return places, made.over(places, values).excess

    def same(gauss: Any, _: Any) -> Any:
        return gauss

    spare, top = maximise(made, room, same, made.numbers)
    if not spare > 0:
        names = {c.name for c in (made.quadratic, *made.further)}
        raise _empty(
            system,
            level,
            names,
            f"{made.quadratic.name} is at least {made.quadratic.target - spare:.6g}",
        )
    if not made.further:
        return RayProposal(made, values)
    if len(made.further) > 1:
        raise InputError(
            f"{system.name}: {' and '.join(c.name for c in made.further)} cannot both be held "
            f"besides {made.quadratic.name}; one of them can"
        )
    slice_ = GreatCircleProposal.of(made, sheet, values)
    (further,) = made.further

    def signed(sign: float) -> Callable[[Any], tuple[Any, Any]]:
        def height(gauss: Any) -> tuple[Any, Any]:
            places = made.normed(gauss)
            difference = sign * slice_.value(places)[0]
            real = np.isfinite(difference)
            return places[:, real], difference[real]

        return height

    low, high = (
        further.target + sign * maximise(made, signed(sign), same, made.numbers, top[:, None])[0]
        for sign in (-1.0, 1.0)
    )
    if not low < further.target < high:
        raise _empty(
            system, level, {further.name}, f"{further.name} lies between {low:.6g} and {high:.6g}"
        )
    return slice_


def _empty(system: System, level: Mapping[str, float], names: set[str], reach: str) -> InputError:
    others = {name: value for name, value in level.items() if name not in names}
    given = f"with {level_label(others)} " if others else ""
    return InputError(f"{system.name}: the level {level_label(level)} is empty: {given}{reach}")


def _bounded(level: LevelSampler) -> LevelSampler:
    """The level with a bound of what the densities of the points of one throw add up to."""
    thrower = level._thrower

    def height(gauss: Any) -> tuple[Any, Any]:
        spots = thrower.spots(gauss)
        return spots.places, level.density(spots)

    top, _ = maximise(thrower.made, height, thrower.near, thrower.numbers)
    bound = _MARGIN * thrower.most * top
    trial = counter_normals(0, np.arange(_TRIAL), np.zeros(_TRIAL), thrower.numbers)
    taken = height(trial)[1].sum() / (_TRIAL * bound)
    # half of the attempts that a point takes, so that few are made in vain
    tries = int(np.clip(0.5 / max(taken, 1 / _BATCH), 1, _BATCH))
    return replace(level, _bound=bound, _tries=tries)
