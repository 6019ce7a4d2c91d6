"""A level of the integrals: its conditions, its measure, and proposals of points on it.

The microcanonical measure of a level is the invariant measure of the system restricted to it, ρ
∏ δ(relations) ∏ δ(held integrals) dx, which is ρ / √det(G Gᵀ) times the surface measure, where the
rows of G are the gradients of relations and held integrals (the Gelfand–Leray form).  Without a
known invariant measure of constant sign the surface measure itself is used.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ...errors import InputError
from ...formulas.compiled import CompiledTerms, SystemFormulas
from ...system.arrays import FloatArray
from ...system.laws import Measure
from ...system.system import System
from .counter_rng import counter_normals
from .fibration import Fibration
from .great_circles import GreatCircleProposal
from .level_integrals import level_label, measure_label, measures, validate_level
from .level_set_fibration import find_fibration
from .proposals import Proposal, RayProposal, WeightedPoints

#: Number of proposals from which the sign of an invariant measure is read.
TRIAL = 1 << 11
#: Number of Newton steps that project a point onto its level.
_NEWTON = 2
#: NaNs are detected in the results, and rejected there.
MINDING_RESULTS = np.errstate(over="ignore", invalid="ignore", divide="ignore")


@dataclass(frozen=True)
class Level:
    """A level of the integrals, with proposals of its points and their density.

    Attributes
    ----------
    system : System
    values : mapping of str to float
        The held integrals.
    parameters : array (p,)
    measure : str
        The measure by which points count: the name of the invariant measure and its source, or
        "surface measure".
    invariant : bool
        Whether it is invariant under the motion.
    proposal : Proposal
    """

    system: System
    values: Mapping[str, float]
    parameters: FloatArray
    measure: str
    invariant: bool
    proposal: Proposal
    _held_terms: CompiledTerms
    _targets: FloatArray
    _slopes: CompiledTerms
    _density: CompiledTerms | None

    def density(self, weighted_points: WeightedPoints) -> FloatArray:
        """The target density, relative to that of the proposals."""
        return weighted_points.volume * self._weight(weighted_points.states)

    def onto_level(self, states: FloatArray) -> FloatArray:
        """States projected onto the level by Newton's method."""
        for _ in range(_NEWTON):
            defect = self._held_terms(states, self.parameters) - self._targets[:, None]
            slopes = self._gradients(states)
            gram = slopes @ np.swapaxes(slopes, 1, 2)
            if not np.isfinite(gram).all():
                raise self.too_far()
            share = np.linalg.solve(gram, np.ascontiguousarray(defect.T)[:, :, None])
            states = states - (np.swapaxes(slopes, 1, 2) @ share)[:, :, 0].T
        return states

    def too_far(self) -> InputError:
        """The error for a level whose numbers overflow."""
        return InputError(
            f"{self.system.name}: the level {level_label(self.values)} is too far from 1 to "
            "compute with: choose other units or numbers"
        )

    def _weight(self, states: FloatArray) -> FloatArray:
        """The target density, relative to ∏ δ(relations) ∏ δ(held integrals) dx."""
        if self._density is not None:
            density: FloatArray = np.abs(self._density(states, self.parameters)[0])
            return density
        slopes = self._gradients(states)
        gram: FloatArray = slopes @ np.swapaxes(slopes, 1, 2)
        result: FloatArray = np.sqrt(np.linalg.det(gram))
        return result

    def _gradients(self, states: FloatArray) -> FloatArray:
        size, k = states.shape
        flat = self._slopes(states, self.parameters).T
        return np.ascontiguousarray(flat).reshape(k, self._targets.size, size)


def prepare_level(system: System, level: Mapping[str, float], values: FloatArray) -> Level:
    """The level of a system on which integrals have given values.

    Parameters
    ----------
    system : System
    level : mapping of str to float
        Integrals by name, with their values.
    values : array (p,)
        Parameters.

    Raises
    ------
    InputError
        If an integral is unknown, or the level is not bounded or of a form for which no method is
        known here.  Whether it has any point is seen from the proposals only.
    """
    validate_level(system, level, values)
    sheet = SystemFormulas(system)
    fibration = find_fibration(system, sheet, level, values)
    proposal = _proposal(system, sheet, fibration, values)
    law, density = _density(system, sheet, level, proposal, values)
    conditions = [sheet.term_of(relation) for relation in system.scalar.relations]
    integrals = {
        law.name: sheet.term_of(law.value) for law in system.integrals if law.name in level
    }
    conditions += [integrals[name] for name in level]
    return Level(
        system=system,
        values=dict(level),
        parameters=values,
        measure=measure_label(law),
        invariant=law is not None,
        proposal=proposal,
        _held_terms=CompiledTerms(conditions),
        _targets=np.array([0.0] * len(system.relations) + [float(v) for v in level.values()]),
        _slopes=CompiledTerms([term for row in sheet.slopes(conditions) for term in row]),
        _density=density,
    )


def _proposal(
    system: System, sheet: SystemFormulas, fibration: Fibration, values: FloatArray
) -> Proposal:
    """Rays, or great circles where an integral is held besides."""
    if not fibration.further:
        return RayProposal(fibration, values)
    if len(fibration.further) > 1:
        raise InputError(
            f"{system.name}: {' and '.join(c.name for c in fibration.further)} cannot both be held "
            f"besides {fibration.quadratic.name}; one of them can"
        )
    return GreatCircleProposal.from_fibration(fibration, sheet, values)


def _density(
    system: System,
    sheet: SystemFormulas,
    level: Mapping[str, float],
    proposal: Proposal,
    values: FloatArray,
) -> tuple[Measure | None, CompiledTerms | None]:
    """The invariant measure that has constant sign on the level, and its density."""
    states = proposal.weighted_points(
        counter_normals(0, np.arange(TRIAL), np.zeros(TRIAL), proposal.numbers)
    ).states
    for law in measures(system, level, values):
        density = CompiledTerms([sheet.term_of(law.value)])
        signs = np.sign(density(states, values))
        if signs.size and (np.isfinite(signs) & (signs == signs[0, 0])).all() and signs.all():
            return law, density
    return None, None
