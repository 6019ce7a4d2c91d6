"""The verdict on a law, combined from the components of its level.

The level of a law is first decomposed into components. On each component the law is evaluated at
random points; a residual that is not zero there, exactly or as a ball that does not contain zero,
refutes it. Otherwise the residuals are computed symbolically; if all of them vanish modulo the
equations of the component, the law holds on it. A law that holds on every component is proven. If
some components are neither proven nor refuted, the law is proven where their points are excluded.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property, partial

import sympy as sp

from certificate_checker import CheckError
from certificate_checker.certificate_points import point_of_level
from certificate_checker.claim.claim import Claim as CheckedClaim, read_claim
from certificate_checker.claim.errors import UndefinedError
from flowlanes.errors import InputError
from flowlanes.formulas.errors import NeedMoreGeneratorsError, NotExactError, OutOfReachError
from flowlanes.memory import memory
from flowlanes.printing.formula import text
from flowlanes.system.laws import Law
from flowlanes.system.system import System

from .claim_text import claim_text
from .fields.budget import Budget
from .fields.function_field import FunctionField
from .fields.signs import Sign
from .level.alternatives import Alternative, alternatives
from .level.level_formulas import EmptyLevelSetError
from .level.level_set import LevelSet
from .level.polynomial_problems import Claim, polynomial_problems
from .level.positivity_conditions import positive_formulas, sign_determining_bases
from .level.target_conditions import has_target, is_admissible_target, open_conditions
from .random_test import FURTHER, Trial, is_nowhere, point_of_reversed_time, trials
from .rank import DIMENSION
from .remarks import remark
from .residuals import bracket_with, conditions_are_independent, derivative_of, in_words
from .symbolic_proof import NO_VOLUME, Proof, proof
from .verdict import Verdict
from .witness_points import Witness, point_shown, witness, witness_point

NOTHING = Proof(0)
NOWHERE = "no point was found at which the density is real"
NO_TARGET = "the parameters that it gives its target are not admissible there at any point tried"


@dataclass(frozen=True)
class _Part:
    """The outcome for a law on one part of its level.

    Attributes
    ----------
    defining_factors : tuple of sympy.Expr
        The factors that vanish on this part.
    trial : Trial, optional
        A point at which the law fails.
    point : mapping of str to str, optional
        State and parameters at this point.
    dispute : str
        Why the certificate checker rejects a point at which the law seems to fail.
    needs : tuple of (str, str)
        Quantities that must be positive for the law to be defined and whose sign is unknown: in
        words, and as a formula.
    remark : str
        A remark on the law.
    witness : Witness, optional
        The point as confirmed by the certificate checker.
    """

    defining_factors: tuple[sp.Expr, ...]
    proof: Proof = NOTHING
    trial: Trial | None = None
    point: dict[str, str] | None = None
    dispute: str = ""
    needs: tuple[tuple[str, str], ...] = ()
    remark: str = ""
    witness: Witness | None = None

    @property
    def where(self) -> str:
        """The equations of the part, in words."""
        return " and ".join(f"{text(c)} = 0" for c in self.defining_factors)

    @property
    def elsewhere(self) -> str:
        """The complement of the part, in words."""
        if len(self.defining_factors) == 1:
            return f"{text(self.defining_factors[0])} ≠ 0"
        return f"not ({self.where})"

    @property
    def formula(self) -> str:
        """The complement as a Python formula; empty if it is not a single inequality."""
        return f"{self.defining_factors[0]} != 0" if len(self.defining_factors) == 1 else ""


def verdict_of(system: System, law: Law, budget: Budget) -> Verdict:
    """The verdict on a law within a budget.

    Raises
    ------
    InputError
        If the level is empty, or the law is defined nowhere on it.
    """
    parts: list[_Part] = []
    empty: list[EmptyLevelSetError] = []
    for alternative in alternatives(system, law):
        # The level is the union of the alternatives, so a counterexample on one refutes the law.
        checked = _Checker(alternative.system, alternative.law)
        try:
            parts += _of_alternative(alternative, budget, checked)
        except EmptyLevelSetError as nothing:
            empty.append(nothing)
    if empty and not parts:
        raise empty[0]
    if failed := [part for part in parts if part.trial is not None]:
        return _refutation(law, failed[0], parts)
    if disputed := [part for part in parts if part.dispute]:
        return Verdict(law.name, "undecided", reason=disputed[0].dispute)
    open_parts = [part for part in parts if part.proof.failure]
    proven = [part for part in parts if part.proof.residuals and not part.proof.failure]
    nowhere = all(part.proof.failure in (NOWHERE, NO_VOLUME, NO_TARGET) for part in open_parts)
    if not nowhere and (not proven or any(not part.defining_factors for part in open_parts)):
        return Verdict(law.name, "undecided", reason=open_parts[0].proof.failure)
    for reason in (NO_VOLUME, NO_TARGET) if not proven else ():
        if any(part.proof.failure == reason for part in open_parts):
            raise InputError(f"{system.name}: the law {law.name!r} states nothing: {reason}")
    if not proven:
        raise InputError(
            f"{system.name}: the law {law.name!r} divides by zero, or takes a root of a "
            "negative quantity, at every point tried on its level"
        )
    conditions = dict([(part.elsewhere, part.formula) for part in open_parts])
    conditions |= {
        sign: sign.replace("^", "**") for part in proven for sign in part.proof.conditions
    }
    conditions |= {need: formula for part in proven for need, formula in part.needs}
    count = sum(part.proof.residuals for part in proven)
    return Verdict(
        law.name,
        "proven where" if conditions else "proven",
        finding=_zero_residuals_text(law, count, len(proven))
        + "".join({p.remark: 0 for p in proven}),
        conditions=tuple(conditions),
        formulas=tuple(conditions.values()),
    )


@dataclass(frozen=True)
class _Checker:
    """A law as the certificate checker reads it; every refutation must be confirmed by it."""

    system: System
    law: Law

    @cached_property
    def read(self) -> CheckedClaim:
        return read_claim(claim_text(self.system, self.law), "the claim")

    def refutation(self, claim: Claim, level: LevelSet, trial: Trial) -> _Part:
        """The part with a point of failure; in dispute if the checker does not confirm it."""
        failed = _Part((), trial=trial, point=point_shown(claim, level, trial.field))
        try:
            return replace(failed, witness=witness(self.read, claim, level, trial.values))
        except (CheckError, UndefinedError) as reason:
            what = trial.witness[0] if trial.witness else ""
            if self._beyond(claim, level, trial, what):
                return failed
            return _Part(
                (),
                dispute=f"{claim.original_words(what)} is not zero at a point tried, but the check "
                f"of certificates does not confirm it: {reason}",
            )

    def _beyond(self, claim: Claim, level: LevelSet, trial: Trial, what: str) -> bool:
        """True if the checker accepts the point but has no residual of this kind.

        The checker reads the conditions as stated. It does not compute the equations of a
        component, whose rates, brackets and derivatives along a symmetry field must vanish as
        well, nor does it test that quantities separate or that time runs forward.
        """
        own = [c for c in level.moving if c not in level.volume_conditions]
        names = ["dτ/dt", *map(in_words, own), *map(bracket_with, own), *map(derivative_of, own)]
        partly = self.law.by_formulas is not self.law
        if not (partly or what.startswith(tuple(names))):
            return False
        point = witness_point(claim, level, trial.values)
        if point is None:
            return False
        try:
            point_of_level(self.read, point)
        except (CheckError, UndefinedError):
            return False
        return True


def _of_alternative(alternative: Alternative, budget: Budget, checker: _Checker) -> Iterator[_Part]:
    """The outcomes for a law on the components of one alternative."""
    try:
        claims = polynomial_problems(alternative.system, alternative.law)
    except OutOfReachError as reason:
        yield _Part(alternative.defining_factors, Proof(0, failure=str(reason)))
        return
    for claim in claims:
        try:
            levels = _components(claim.system, claim.law.level)
        except OutOfReachError as reason:
            raise type(reason)(claim.original_words(str(reason))) from None
        for level in levels:
            part = _on(level, claim, budget, checker)
            own = map(claim.original, level.defining_factors)
            yield replace(part, defining_factors=(*alternative.defining_factors, *own))
            if part.trial is not None or (part.proof.failure and not level.defining_factors):
                return
        for excluded in claim.excluded_zeros:
            defining_factors = (*alternative.defining_factors, claim.original(excluded))
            yield _Part(defining_factors, Proof(0, failure="not decided"))


@memory(16)
def _components(system: System, on: tuple[sp.Expr, ...]) -> tuple[LevelSet, ...]:
    """The components of a level, which several laws of a system share."""
    return LevelSet(system, on).components


def _on(level: LevelSet, claim: Claim, budget: Budget, checker: _Checker) -> _Part:
    """The outcome for a law on one component."""
    # A motion may leave the zero set of an initial for the rest of the parent component, so only
    # the parent is required to be invariant.
    points = replace(level, inner=True) if level.parent else level
    law = claim.law
    sample: dict[str, float] | None = None
    first: Trial | None = None
    disputed: _Part | None = None
    # A claimed rank refers to almost all points; where an initial vanishes it may be lower.
    attained = level.parent is not None
    for trial in trials(law, points):
        if trial.witness is not None:
            failed = checker.refutation(claim, points, trial)
            if not failed.dispute:
                return failed
            disputed = disputed or failed
            continue
        if trial.lack is not None and trial.lack[0] == DIMENSION:
            return _lacking(claim, points, trial, trial.lack)
        first = first or trial
        sample = sample or {name: float(value) for name, value in trial.field.values.items()}
        attained = attained or trial.lack is None
    if first is None and disputed is None:
        last = point_of_reversed_time(law, points)
        if last is not None and last.witness is not None:
            failed = checker.refutation(claim, points, last)
            if not failed.dispute:
                return failed
            disputed = failed
        if law.of_volume and is_nowhere(points, conditions_are_independent):
            return _Part((), Proof(0, failure=NO_VOLUME))
        if has_target(law) and is_nowhere(points, partial(is_admissible_target, law)):
            return _Part((), Proof(0, failure=NO_TARGET))
        if law.of_volume and positive_formulas(law, level):
            return _Part((), Proof(0, failure=NOWHERE))
    # A disputed counterexample must not be overruled by a proof.
    outcome = NOTHING if disputed else proof(law, level, sample, budget, attained)
    if outcome.lack is not None and first is not None:
        return _lacking(claim, points, first, outcome.lack)
    if disputed or outcome.failure or outcome.conditions:
        for trial in trials(law, points, FURTHER):
            if trial.witness is not None:
                failed = checker.refutation(claim, points, trial)
                if not failed.dispute:
                    return failed
                disputed = disputed or failed
    if disputed is not None:
        return disputed
    words = claim.original_words
    return _Part(
        (),
        replace(
            outcome,
            conditions=tuple(map(words, outcome.conditions)),
            failure=words(outcome.failure),
        ),
        needs=tuple((words(need), words(formula)) for need, formula in _needs(law, level)),
        remark=words(_remark(law, level, first)),
    )


def _lacking(claim: Claim, level: LevelSet, trial: Trial, lack: tuple[str, str]) -> _Part:
    """The outcome on a component where the law does not have its rank."""
    failed = replace(trial, witness=lack)
    return _Part((), trial=failed, point=point_shown(claim, level, trial.field))


def _needs(law: Law, level: LevelSet) -> tuple[tuple[str, str], ...]:
    """Conditions of an isomorphism that are not known to hold, in words and as formulas.

    Time must run forward, and the parameters of the target must be admissible.
    """
    if not has_target(law):
        return ()
    admissible = tuple((text(c), str(c)) for c in open_conditions(law, level))
    if level.sign(law.scalar.time) is Sign.POSITIVE:
        return admissible
    return admissible + tuple(
        (f"{what} > 0", f"{formula} > 0")
        for what, formula in positive_formulas(law, level)
        if level.sign(formula) is not Sign.POSITIVE
    )


def _remark(law: Law, level: LevelSet, first: Trial | None) -> str:
    """A remark on a law that holds: where a density is real, or that the law is trivial."""
    if law.of_volume:
        return _of_density(law, level)
    try:
        # A property found at one point is reported only if it also holds symbolically.
        said = first is not None and remark(law, level, first.field)
        return f"; {said}" if said and said == remark(law, level, _symbols(level)) else ""
    except (NotExactError, OutOfReachError, NeedMoreGeneratorsError, ZeroDivisionError):
        return ""


def _symbols(level: LevelSet) -> FunctionField:
    return level.fractions(FunctionField, 32, None, Budget())


def _of_density(law: Law, level: LevelSet) -> str:
    real = [
        f"{text(formula)} > 0"
        for _, formula in positive_formulas(law, level)
        if level.sign(formula) is not Sign.POSITIVE
        # an even power is positive where the density is defined at all
        and not (formula.is_Pow and formula.exp.is_even)
    ]
    signed = [
        f"({text(formula)})"
        for _, formula in sign_determining_bases(law, level)
        if abs(level.sign(formula)) != Sign.POSITIVE
    ]
    return (f"; ρ is real where {', '.join(real)}" if real else "") + (
        f"; a signed measure, with the sign of {' · '.join(signed)}" if signed else ""
    )


def _refutation(law: Law, failed_part: _Part, parts: list[_Part]) -> Verdict:
    assert failed_part.trial is not None and failed_part.trial.witness is not None
    what, residual = failed_part.trial.witness
    place = f"a point where {failed_part.where}" if failed_part.defining_factors else "a point"
    holds = [
        part.where
        for part in parts
        if part.defining_factors
        and part.proof.residuals
        and not part.proof.failure
        and not part.proof.conditions
    ]
    besides = f"; it holds where {', and where '.join(dict.fromkeys(holds))}" if holds else ""
    witness = {"point": failed_part.point, "what": what, "residual": str(residual)}
    return Verdict(
        law.name,
        "refuted",
        finding=f"{what} fails at {place}{besides}",
        witness=witness | (vars(failed_part.witness) if failed_part.witness is not None else {}),
    )


def _zero_residuals_text(law: Law, count: int, parts: int) -> str:
    many = "1 residual is" if count == 1 else f"{count} residuals are"
    on = f" on {parts} components" if parts > 1 else ""
    return f"{many} zero modulo the relations{on}" + (f" ({law.included})" if law.included else "")
