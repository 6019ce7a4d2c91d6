"""A few random start points on a level, without the bound that exact rejection needs.

Sampling importance resampling (Rubin, 1988): every point is chosen among the candidates of a batch
of proposals of its own with probabilities in proportion to their density.  As the batch grows the
distribution of the point approaches the one of :mod:`flowlanes.flow.sampling.level_sampler`; its
error is of the order 1/n for n candidates whose densities vary by a factor of order one.  Points
are independent, and each depends only on the seed and its own index.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ...arguments import Parameters, arguments_checked
from ...errors import InputError
from ...formulas.array_evaluation import parameter_rows
from ...system.arrays import FloatArray, IntArray
from ...system.system import System
from .counter_rng import counter_normals, uniforms
from .level import MINDING_RESULTS, Level, prepare_level
from .level_sampler import sampler_of

#: Number of proposals for each point; a tenth of them or more meet a usual level.
_PROPOSALS = 64
#: Number of proposals computed together.
_BATCH = 1 << 14
#: Seeds of proposals and of choices among them differ by this.
_CHOICE = 0x5851F42D4C957F2D


@dataclass(frozen=True)
class ResampledLevel:
    """A level of the integrals from which a few points can be drawn at once.

    Attributes
    ----------
    level : Level
    """

    level: Level

    @property
    def description(self) -> str:
        """The measure, and how points are drawn by it."""
        return f"{self.level.measure}, resampled from {_PROPOSALS} proposals for each start"

    @MINDING_RESULTS
    def draw(self, count: int, *, seed: int = 0, first: int = 0) -> FloatArray:
        """Points `first` to `first` + `count`; array (count, size).

        Raises
        ------
        InputError
            If the level has no point, or so few that no proposal meets it.
        """
        if count < 0:
            raise InputError(f"count = {count}: it must not be negative")
        step = _BATCH // _PROPOSALS
        members = first + np.arange(count)
        parts = [
            self._chosen(seed, members[start : start + step]) for start in range(0, count, step)
        ]
        return np.concatenate([np.empty((0, len(self.level.system.symbols))), *parts])

    def _chosen(self, seed: int, members: IntArray) -> FloatArray:
        """One candidate of each member, drawn in proportion to its density."""
        proposal = self.level.proposal
        owners = np.repeat(np.arange(members.size), _PROPOSALS)
        attempts = np.tile(np.arange(_PROPOSALS), members.size)
        gauss = counter_normals(seed, members[owners], attempts, proposal.numbers)
        candidates = proposal.weighted_points(gauss)
        density = self.level.density(candidates)
        if not np.isfinite(density).all():
            raise self.level.too_far()
        owner = owners[candidates.which]
        total = np.bincount(owner, density, members.size)
        met = np.flatnonzero(total > 0)
        # Candidates in order of their owners tile one unit interval for each owner that has any; a
        # uniform number in the interval of an owner chooses among its candidates.
        share = np.cumsum(density / np.where(total > 0, total, 1.0)[owner])
        choice = uniforms(seed ^ _CHOICE, members[met], np.zeros(met.size), 1)[0]
        index = np.searchsorted(share, np.arange(met.size) + choice).clip(max=share.size - 1)
        states = np.empty((members.size, len(self.level.system.symbols)))
        if met.size:
            chosen = np.ascontiguousarray(candidates.states[:, index])
            states[met] = self.level.onto_level(chosen).T
        missed = np.setdiff1d(np.arange(members.size), met)
        if missed.size:
            # The exact sampler says why a level has no point, and finds those of a thin one.
            sampler = sampler_of(self.level)
            for k in missed:
                states[k] = sampler.draw(1, seed=seed, first=int(members[k]))[0]
        return states


@arguments_checked
@MINDING_RESULTS
def resampled_level(
    system: System, level: Mapping[str, float], parameters: Parameters = None
) -> ResampledLevel:
    """Prepare a level from which a few points are drawn at once.

    Parameters
    ----------
    system : System
    level : mapping of str to float
        Integrals by name, with their values.
    parameters : mapping of Symbol or name to number, optional
        Values that replace the defaults.

    Returns
    -------
    ResampledLevel
        Its ``draw`` gives states (n, size) in flat order.

    Raises
    ------
    InputError
        If an integral is unknown, or the level is not bounded.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> a, b, c = sp.symbols("a b c", real=True)
    >>> energy = flowlanes.Integral("energy", a**2 + b**2 / 2 + c**2 / 3)
    >>> field = {a: -b * c, b: 4 * a * c, c: -3 * a * b}
    >>> top = flowlanes.System("top", "Euler's top", field, laws=(energy,))
    >>> flowlanes.flow.resampled_level(top, {"energy": 2.0}).draw(5, seed=1).shape
    (5, 3)
    """
    values = parameter_rows(system, parameters, 1)[0]
    return ResampledLevel(prepare_level(system, level, values))
