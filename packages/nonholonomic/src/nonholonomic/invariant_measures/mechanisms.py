"""Existence of an invariant measure for mechanisms, from the growth of the lifted fields."""

from __future__ import annotations

from typing import Any, TypeAlias

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.parsing.exact_decimals import exact_number
from flowlanes.system.laws import Measure
from flowlanes.system.named_formulas import expand
from flowlanes.system.system import System
from lawproof.proof.fields.budget import EFFORT
from lawproof.proof.prover import prove
from lawproof.proof.verdict import Verdict

from ..mechanics.constraints.exact_points import NoPointError
from ..mechanics.constraints.growth import generic
from ..mechanics.lagrangian.constrained_frame import Restriction, constraint_distribution
from ..mechanics.lagrangian.mechanism import Mechanism
from ..mechanics.lagrangian.poincare_suslov import equations_of_motion
from .density_fit import density_from_powers, density_law
from .lifted_fields import LiftedFields, lift
from .parameter_conditions import Level, branches
from .positivity import Powers, Signs, positive
from .result import MeasureExistence

FURTHER = 3
EFFORT_PER_PROOF = EFFORT // 10
"""Term operations for the proof in all variables; the proof in coordinates comes after it."""

Domain: TypeAlias = tuple[Any, ...]
LevelMeasure: TypeAlias = tuple[Level, Measure, Verdict, Domain]


def decide_mechanism(mechanism: Mechanism, name: str, effort: int) -> MeasureExistence:
    """Decide for a mechanism with arbitrary parameters.

    Parameters
    ----------
    name : str
        Name in the result.
    effort : int
        Largest number of term operations of a proof.
    """
    restriction = constraint_distribution(mechanism)
    lifted = lift(restriction)
    parameters = tuple(p.symbol for p in mechanism.parameters)
    system = equations_of_motion(mechanism)
    base = generic(lifted.base, parameters)
    if generic(lifted.lifted, parameters).final == base.final:
        return _everywhere(restriction, lifted, system, name, effort)
    measures, complete = _levels(restriction, lifted, system, len(base.growth), effort)
    values = {p.symbol: exact_number(p.default) for p in mechanism.parameters}
    met = [measure for measure in measures if all(c.xreplace(values) == 0 for c in measure[0])]
    obstruction = None if met else _obstruction(lifted)
    if measures:
        _, law, _, domain = (*met, *measures)[0]
        return MeasureExistence(
            name,
            "conditional",
            density=law,
            system=system,
            domain=domain,
            conditions=tuple(level for level, *_ in measures),
            complete=complete,
            holds=bool(met),
            obstruction=obstruction,
            verdicts=tuple(verdict for _, _, verdict, _ in measures),
        )
    if obstruction is None:
        return MeasureExistence(
            name,
            "undecided",
            reason="for general parameters there is none; for their own values no obstruction was "
            "found at a rational point, and no density",
        )
    reason = ""
    if parameters:
        reason = (
            "there is none for any values of the parameters"
            if complete
            else "for other values of the parameters than their own it is not decided"
        )
    return MeasureExistence(name, "none", obstruction=obstruction, complete=complete, reason=reason)


def _everywhere(
    restriction: Restriction, lifted: LiftedFields, system: System, name: str, effort: int
) -> MeasureExistence:
    """The result if there is no obstruction at a generic point: the density if it is found."""
    measure = _measure(restriction, lifted, system, (), effort)
    if measure is not None:
        law, verdict, domain = measure
        return MeasureExistence(
            name, "exists", density=law, system=system, domain=domain, verdicts=(verdict,)
        )
    return MeasureExistence(
        name,
        "undecided",
        reason="the 1-form is closed about a generic point, but no closed form of the density was "
        "found, which alone would show that it is smooth and of one value everywhere",
    )


def _levels(
    restriction: Restriction, lifted: LiftedFields, system: System, steps: int, effort: int
) -> tuple[list[LevelMeasure], bool]:
    """Levels in the parameters on which a measure is proven, and whether the list is complete."""
    proven: list[LevelMeasure] = []
    complete = False
    try:
        volume = _volume(restriction)
        # conditions from the first commutators may be too weak; then longer ones are added
        for more in range(FURTHER):
            solved = branches(lifted, steps + more, _positive(restriction), volume)
            proofs = [
                (level, _measure(restriction, lifted, system, level, effort))
                for level in solved.levels
            ]
            proven = [(level, *measure) for level, measure in proofs if measure is not None]
            complete = solved.complete and len(proven) == len(proofs)
            if complete:
                break
    except (InputError, NoPointError):
        return proven, False
    return proven, complete


def _volume(restriction: Restriction) -> sp.Expr:
    """The determinant of the kinetic form, factored, with definitions substituted."""
    size = len(restriction.velocities)
    entries = [e for row in restriction.kinetic for e in row]
    matrix = sp.Matrix(size, size, [expand(e, restriction.definitions) for e in entries])
    return sp.factor(sp.together(matrix.det(method="berkowitz")))


def _positive(restriction: Restriction) -> frozenset[sp.Symbol]:
    """Parameters declared positive, or on the diagonal of the kinetic form."""
    parameters = restriction.mechanism.parameters
    declared = {p.symbol for p in parameters if (p.symbol > 0) in p.admissible}
    diagonal = {row[i] for i, row in enumerate(restriction.kinetic)}
    L = restriction.mechanism.L
    diagonal |= {sp.diff(L, s, 2) for s in restriction.mechanism.frame.w}
    return frozenset(declared | (diagonal & {p.symbol for p in parameters}))


def _measure(
    restriction: Restriction, lifted: LiftedFields, system: System, level: Level, effort: int
) -> tuple[Measure, Verdict, Domain] | None:
    """A proven measure on a level, and where its density is shown to be positive."""
    jacobian: Powers = (
        (_volume(restriction), sp.S.One),
        # The constraints that remain as relations restrict the volume of the velocities.
        *((expand(f, restriction.definitions), sp.S.One) for f in restriction.nonzero),
    )
    fit = density_from_powers(lifted, jacobian, level)
    if fit is None:
        return None
    potential, powers = fit
    powers, domain = positive(powers, _signs(restriction))
    law = Measure(
        "configuration_measure",
        powers,
        meaning="density that depends on the configuration alone",
        level=level,
    )
    try:
        verdict = prove(system, law, effort=min(effort, EFFORT_PER_PROOF))
    except InputError as reason:
        # The equations of motion may be singular where the distribution is not.
        verdict = Verdict(law.name, "undecided", reason=str(reason))
    if not verdict:
        # dσ = θ along the admissible fields is an equivalent statement in fewer variables.
        verdict = prove(*density_law(lifted, potential, level), effort=effort)
    return (law, verdict, domain) if verdict else None


def _signs(restriction: Restriction) -> Signs:
    """Signs of factors of a density; the kinetic form is positive."""
    mechanism = restriction.mechanism
    return Signs(
        _positive(restriction),
        mechanism.frame.relations,
        (_volume(restriction),),
        tuple((p.symbol, exact_number(p.default)) for p in mechanism.parameters),
    )


def _obstruction(lifted: LiftedFields) -> dict[str, object] | None:
    """A rational point at which a combination of commutators points along z, for the defaults."""
    base, raised = generic(lifted.base), generic(lifted.lifted)
    full = base.final == base.dimension
    if raised.final == base.final or not (raised.exact and (full or base.exact)):
        return None
    return {
        "what": f"commutators of the lifted fields span {raised.final} dimensions over "
        f"{base.final}, so that no function has the derivatives required",
        "point": {str(s): str(v) for s, v in raised.point.items() if s != lifted.height},
        "residual": str(raised.growth),
    }
