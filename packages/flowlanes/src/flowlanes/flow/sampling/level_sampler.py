"""Random start points, uniformly distributed on a level of the integrals.

The distribution is uniform with respect to the invariant measure if one is known, and otherwise to
the surface measure of the level in state space.  In terms of δ-functions the invariant measure of
a level is ρ ∏ δ(relations) ∏ δ(given integrals) dx, that is ρ / √det(G Gᵀ) times the surface
measure, where the rows of G are the gradients of relations and given integrals (the Gelfand–Leray
form).

Points are drawn by rejection sampling, so they are independent and exactly distributed; each
depends only on the seed and its own index.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from ...arguments import Parameters, arguments_checked
from ...errors import InputError
from ...formulas.array_evaluation import parameter_rows
from ...formulas.compiled import CompiledTerms, SystemFormulas
from ...system.arrays import BoolArray, FloatArray, IntArray
from ...system.laws import Measure
from ...system.system import System
from ..cost import require_room
from ..devices.threads import map_in_threads
from .counter_rng import counter_normals
from .fibration import Fibration
from .great_circles import GreatCircleProposal
from .level_integrals import level_label, measure_label, measures, validate_level
from .level_set_fibration import find_fibration
from .proposals import Proposal, RayProposal, WeightedPoints, maximise

#: Number of attempts computed together.
_BATCH = 1 << 14
#: Bound of the density, relative to the largest value found.
_MARGIN = 1.15
#: Number of attempts from which the acceptance rate is estimated.
_TRIAL = 1 << 11
#: Number of attempts for one point after which the level is regarded as too thin.
_MOST_ATTEMPTS = 10**6
#: Number of Newton steps that project a point onto its level.
_NEWTON = 2


#: Invalid operations give NaN, which is detected in the results and rejected there.
_MINDING_RESULTS = np.errstate(over="ignore", invalid="ignore", divide="ignore")


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
    system : System
    values : mapping of str to float
        Values of the given integrals.
    parameters : array (p,)
    measure : str
        Measure of the random points: the name of the invariant measure and its source, or "surface
        measure".
    invariant : bool
        True if it is invariant under the motion.
    """

    system: System
    values: Mapping[str, float]
    parameters: FloatArray
    measure: str
    invariant: bool
    _proposal: Proposal
    _held_terms: CompiledTerms
    _targets: FloatArray
    _slopes: CompiledTerms
    _density: CompiledTerms | None
    _density_bound: float
    _tries: int

    @_MINDING_RESULTS
    def draw(self, count: int, *, seed: int = 0, first: int = 0) -> FloatArray:
        """Points `first` to `first` + `count`; array (count, size).  See :func:`sample_level`."""
        if count < 0:
            raise InputError(f"count = {count}: it must not be negative")
        size = len(self.system.symbols)
        # The computation needs as much memory again as the points themselves.
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
                    f"{self.system.name}: the level {level_label(self.values)} is too thin: no "
                    f"point of it was met in {attempt} attempts"
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

        many = self._proposal.numbers
        owners = np.repeat(members, tries)
        gauss = counter_normals(
            seed, owners, attempt + np.tile(np.arange(tries), members.size), many + 1
        )
        weighted_points = self._proposal.weighted_points(gauss[:many])
        density = self.density(weighted_points)
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
                f"{self.system.name}: the density of the level {level_label(self.values)} has no "
                "bound that could be found: it lies next to a critical level"
            )
        accepted = np.flatnonzero(hit)
        owner, first = np.unique(weighted_points.which[accepted] // tries, return_index=True)
        done = np.zeros(members.size, dtype=bool)
        done[owner] = True
        states = np.ascontiguousarray(weighted_points.states[:, accepted[first]])
        return self._onto_level(states).T, done

    def _too_far(self) -> InputError:
        return InputError(
            f"{self.system.name}: the level {level_label(self.values)} is too far from 1 to "
            "compute with: choose other units or numbers"
        )

    def density(self, weighted_points: WeightedPoints) -> FloatArray:
        """Density of the target distribution relative to that of the proposals."""
        return weighted_points.volume * self._weight(weighted_points.states)

    def _weight(self, states: FloatArray) -> FloatArray:
        """Density of the target distribution relative to ∏ δ(relations) ∏ δ(given integrals) dx."""
        if self._density is not None:
            density: FloatArray = np.abs(self._density(states, self.parameters)[0])
            return density
        slopes = self._gradients(states)
        # The surface measure is √det(G Gᵀ) ∏ δ(…) dx.
        gram: FloatArray = slopes @ np.swapaxes(slopes, 1, 2)
        result: FloatArray = np.sqrt(np.linalg.det(gram))
        return result

    def _gradients(self, states: FloatArray) -> FloatArray:
        size, k = states.shape
        flat = self._slopes(states, self.parameters).T
        return np.ascontiguousarray(flat).reshape(k, self._targets.size, size)

    def _onto_level(self, states: FloatArray) -> FloatArray:
        """States projected onto the level by Newton's method."""
        for _ in range(_NEWTON):
            defect = self._held_terms(states, self.parameters) - self._targets[:, None]
            slopes = self._gradients(states)
            # Newton's method with the step −Gᵀ(G Gᵀ)⁻¹ c, which is orthogonal to the level.
            gram = slopes @ np.swapaxes(slopes, 1, 2)
            if not np.isfinite(gram).all():
                raise self._too_far()
            share = np.linalg.solve(gram, np.ascontiguousarray(defect.T)[:, :, None])
            states = states - (np.swapaxes(slopes, 1, 2) @ share)[:, :, 0].T
        return states


@arguments_checked
@_MINDING_RESULTS
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
    validate_level(system, level, values)
    sheet = SystemFormulas(system)
    fibration = find_fibration(system, sheet, level, values)
    proposal = _proposal(system, sheet, fibration, level, values)
    law, density = _density(system, sheet, level, proposal, values)
    conditions = [sheet.term_of(relation) for relation in system.scalar.relations]
    integrals = {
        law.name: sheet.term_of(law.value) for law in system.integrals if law.name in level
    }
    conditions += [integrals[name] for name in level]
    blank = LevelSampler(
        system=system,
        values=dict(level),
        parameters=values,
        measure=measure_label(law),
        invariant=law is not None,
        _proposal=proposal,
        _held_terms=CompiledTerms(conditions),
        _targets=np.array([0.0] * len(system.relations) + [float(v) for v in level.values()]),
        _slopes=CompiledTerms([term for row in sheet.slopes(conditions) for term in row]),
        _density=density,
        _density_bound=np.inf,
        _tries=1,
    )
    return _with_bound_on_density(blank)


def _density(
    system: System,
    sheet: SystemFormulas,
    level: Mapping[str, float],
    proposal: Proposal,
    values: FloatArray,
) -> tuple[Measure | None, CompiledTerms | None]:
    """Invariant measure with constant sign on the level, and its density."""
    states = proposal.weighted_points(
        counter_normals(0, np.arange(_TRIAL), np.zeros(_TRIAL), proposal.numbers)
    ).states
    # A density that changes its sign, or is singular on the level, is not a probability.
    for law in measures(system, level, values):
        density = CompiledTerms([sheet.term_of(law.value)])
        signs = np.sign(density(states, values))
        if signs.size and (np.isfinite(signs) & (signs == signs[0, 0])).all() and signs.all():
            return law, density
    return None, None


def _proposal(
    system: System,
    sheet: SystemFormulas,
    fibration: Fibration,
    level: Mapping[str, float],
    values: FloatArray,
) -> Proposal:
    """Proposal distribution on the level; InputError if the level is empty."""

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
            level,
            names,
            f"{fibration.quadratic.name} is at least {fibration.quadratic.target - spare:.6g}",
        )
    if not fibration.further:
        return RayProposal(fibration, values)
    if len(fibration.further) > 1:
        raise InputError(
            f"{system.name}: {' and '.join(c.name for c in fibration.further)} cannot both be held "
            f"besides {fibration.quadratic.name}; one of them can"
        )
    slice_ = GreatCircleProposal.from_fibration(fibration, sheet, values)
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
            system, level, {further.name}, f"{further.name} lies between {low:.6g} and {high:.6g}"
        )
    return slice_


def _empty(system: System, level: Mapping[str, float], names: set[str], reach: str) -> InputError:
    others = {name: value for name, value in level.items() if name not in names}
    condition = f"with {level_label(others)} " if others else ""
    return InputError(f"{system.name}: the level {level_label(level)} is empty: {condition}{reach}")


def _with_bound_on_density(level: LevelSampler) -> LevelSampler:
    """Level with a bound of the total density of the points of one proposal."""
    proposal = level._proposal

    def height(gauss: FloatArray) -> tuple[FloatArray, FloatArray]:
        weighted_points = proposal.weighted_points(gauss)
        return weighted_points.places, level.density(weighted_points)

    trial = counter_normals(0, np.arange(_TRIAL), np.zeros(_TRIAL), proposal.numbers)
    top, _ = maximise(proposal.fibration, height, proposal.nearby_proposals, proposal.numbers)
    bound = _MARGIN * proposal.most * top
    share = height(trial)[1].sum() / (_TRIAL * bound)
    if not np.isfinite(share):
        raise level._too_far()
    # Half of the average number of attempts per point, so that few of them are superfluous.
    tries = int(np.clip(0.5 / max(share, 1 / _BATCH), 1, _BATCH))
    return replace(level, _density_bound=bound, _tries=tries)
