"""Proof and refutation of laws.

The level of a law is decomposed into components first.  On each of them the law is tried at
points: where a residual is not zero, exactly or as a ball that does not contain zero, it is
refuted.  What survives is computed symbolically; where every residual vanishes modulo the
equations of the component, the law holds on all of it.  A law that holds on every component is
proven; one that holds on some, and is neither proven nor refuted on others, is proven where these
are left aside.
"""

from __future__ import annotations

import math
import time
from collections.abc import Iterator
from dataclasses import dataclass, fields, replace
from functools import cached_property
from typing import Any, overload

import sympy as sp

from ..arguments import arguments_checked
from ..check import CheckError
from ..check.claim.claim import Claim as CheckedClaim, read_claim
from ..check.claim.errors import UndefinedError
from ..check.witness import located
from ..core.isomorphism import Isomorphism
from ..core.laws import Law, Measure, PoissonStructure, Separation
from ..core.parameters import conditions, satisfies
from ..core.system import System
from ..core.vectors import to_components
from ..errors import InputError
from ..formulas.errors import (
    NeedMoreGeneratorsError,
    NotExactError,
    OutOfReachError,
    UnknownSymbolError,
)
from ..formulas.number_fields import ball_precision
from ..printing.formula import text
from .claim_text import claim_text
from .fields.budget import EFFORT, Budget, checked_effort
from .fields.function_field import FunctionField
from .fields.signs import Sign
from .level.alternatives import Alternative, alternatives
from .level.level_set import EmptyGroundError, LevelSet
from .level.polynomial_problems import Claim, polynomial_problems
from .level.positivity import orienting, positives
from .level.sample_points import far, near
from .random_test import Trial, backwards, trials
from .rank import DIMENSION
from .remarks import remark
from .symbolic_proof import Proof, proof
from .verdict import Verdict
from .verdict_cache import fingerprint, load_verdict, store_verdict
from .witness_points import Witness, witness, witness_point

__all__ = ["prove"]

FURTHER = (near,) * 6 + (far,) * 40
"""Points tried where a remainder is left, before a law is called undecided."""


@overload
def prove(system: System, law: None = None, *, effort: int = ...) -> tuple[Verdict, ...]: ...
@overload
def prove(system: System, law: Law | str, *, effort: int = ...) -> Verdict: ...
@arguments_checked
def prove(
    system: System, law: Law | str | None = None, *, effort: int = EFFORT
) -> Verdict | tuple[Verdict, ...]:
    """Prove or refute a law of a system, or all of its laws.

    Parameters
    ----------
    system : System
    law : Law or str, optional
        One law, or the name of one of the system's; by default all of them.
    effort : int
        Term operations after which a law is left undecided; the same on every machine.

    Returns
    -------
    Verdict or tuple of Verdict

    Raises
    ------
    InputError
        If a law uses an unknown symbol, or its level is empty or annuls a denominator.

    Examples
    --------
    >>> import chaplygin as ch
    >>> ball = ch.from_catalogue("chaplygin-ball")
    >>> ch.prove(ball, "measure").decision
    'proven'
    >>> ch.prove(ball, ch.Integral("M_3", ball.symbols[2])).decision
    'refuted'
    """
    checked_effort(effort)
    if law is None:
        return tuple(prove(system, each, effort=effort) for each in system.laws)
    if isinstance(law, str):
        law = _by_name(system, law)
    _check_defaults(system)
    _check_formulas(system, law)
    name = fingerprint(system, law)
    kept = load_verdict(name, effort)
    if kept is not None:
        return kept
    started = time.monotonic()
    budget = Budget(effort=effort)
    try:
        with ball_precision():
            verdict = replace(_decided(system, law, budget), terms=budget.largest)
    except UnknownSymbolError as symbol:
        raise InputError(
            f"{system.name}: the law {law.name!r} uses {symbol}, which is neither a state variable "
            "nor a definition nor a parameter of the system"
        ) from None
    except OutOfReachError as reason:
        verdict = Verdict(law.name, "undecided", reason=str(reason))
    verdict = replace(verdict, effort=budget.used, seconds=time.monotonic() - started)
    store_verdict(name, verdict, effort)
    return verdict


def _check_defaults(system: System) -> None:
    """Points are drawn near the defaults of the parameters, which must be admissible numbers."""
    for parameter in system.parameters:
        if not math.isfinite(parameter.default):
            raise InputError(
                f"{system.name}: the default {parameter.default} of {parameter.symbol} is no number"
            )
    for parameter, condition in conditions(system.parameters):
        if condition.free_symbols <= set(system.defaults) and not satisfies(
            condition, system.defaults
        ):
            raise InputError(
                f"{system.name}: the default {parameter.symbol} = {parameter.default:g} is not "
                f"admissible; {condition} must hold"
            )


def _check_formulas(system: System, law: Law) -> None:
    """A law is made of formulas."""
    if not isinstance(law.on, tuple | list):
        raise InputError(
            f"{system.name}: the level of the law {law.name!r} is {law.on}; it must be a tuple of "
            "formulas that vanish, such as (x,)"
        )
    waiting = [
        (f.name, getattr(law, f.name)) for f in fields(law) if f.name in ("value", "on", "time")
    ]
    while waiting:
        name, value = waiting.pop()
        if isinstance(value, tuple | list):
            waiting += [(name, part) for part in value]
        elif not isinstance(value, int | float | sp.Basic | sp.MatrixBase):
            raise InputError(
                f"{system.name}: the law {law.name!r} has {value!r} in its {name!r}, which is no "
                "formula of SymPy"
            )


def _by_name(system: System, name: str) -> Law:
    for law in system.laws:
        if law.name == name:
            return law
    names = ", ".join(law.name for law in system.laws) or "none"
    raise InputError(f"{system.name} has no law {name!r}; its laws are {names}")


NOTHING = Proof(0)
NOWHERE = "no point was found at which the density is real"


@dataclass(frozen=True)
class _Part:
    """What is known of a law on one part of its level.

    Attributes
    ----------
    chosen : tuple of sympy.Expr
        What sets the part apart from the others.
    proof : Proof
    trial : Trial, optional
        A point where the law fails.
    point : mapping of str to str, optional
        State and parameters there.
    needs : tuple of (str, str)
        What must be positive for the law to make sense, where that is not known: in words, and as
        a formula.
    remark : str
        What is to be said of the law besides.
    witness : Witness, optional
        The same as the check of certificates found it.
    """

    chosen: tuple[Any, ...]
    proof: Proof = NOTHING
    trial: Trial | None = None
    point: dict[str, str] | None = None
    needs: tuple[tuple[str, str], ...] = ()
    remark: str = ""
    witness: Witness | None = None

    @property
    def where(self) -> str:
        """The part, as equations."""
        return " and ".join(f"{text(c)} = 0" for c in self.chosen)

    @property
    def elsewhere(self) -> str:
        """All but the part."""
        if len(self.chosen) == 1:
            return f"{text(self.chosen[0])} ≠ 0"
        return f"not ({self.where})"

    @property
    def formula(self) -> str:
        """The same as a formula of Python, if it is one."""
        return f"{self.chosen[0]} != 0" if len(self.chosen) == 1 else ""


def _decided(system: System, law: Law, budget: Budget) -> Verdict:
    parts: list[_Part] = []
    empty: list[EmptyGroundError] = []
    for alternative in alternatives(system, law):
        # what fails on a part fails on the whole
        checked = _Checked(alternative.system, alternative.law)
        try:
            parts += _of_alternative(alternative, budget, checked)
        except EmptyGroundError as nothing:
            empty.append(nothing)
    if empty and not parts:
        raise empty[0]
    if failed := [part for part in parts if part.trial is not None]:
        return _refuted(law, failed[0], parts)
    open_parts = [part for part in parts if part.proof.failure]
    proven = [part for part in parts if part.proof.residuals and not part.proof.failure]
    nowhere = all(part.proof.failure == NOWHERE for part in open_parts)
    if not nowhere and (not proven or any(not part.chosen for part in open_parts)):
        return Verdict(law.name, "undecided", reason=open_parts[0].proof.failure)
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
        shown=_words(law, count, len(proven)) + "".join({p.remark: 0 for p in proven}),
        conditions=tuple(conditions),
        formulas=tuple(conditions.values()),
    )


@dataclass(frozen=True)
class _Checked:
    """A law as the check of certificates reads it, which has to agree with every refutation."""

    system: System
    law: Law

    @cached_property
    def read(self) -> CheckedClaim:
        return read_claim(claim_text(self.system, self.law), "the claim")

    def refutation(self, claim: Claim, ground: LevelSet, trial: Trial) -> _Part | None:
        """That the law fails at a point; None where the check does not find so."""
        try:
            found = witness(self.read, claim, ground, trial.values)
            if found is None and not self._beyond(claim, ground, trial):
                return None
        except (CheckError, UndefinedError):
            return None
        return _Part((), trial=trial, point=ground.point_shown(trial.field), witness=found)

    def _beyond(self, claim: Claim, ground: LevelSet, trial: Trial) -> bool:
        """Whether the check has the point, but not the residual, which it does not know.

        It knows rates of the conditions as they are given, not of the equations of a component;
        nor does it know that quantities separate, or that time runs forward.
        """
        what = trial.witness[0] if trial.witness else ""
        if not (isinstance(self.law, Separation) or what.startswith(("invariance", "dτ/dt"))):
            return False
        made = witness_point(claim, ground, trial.values)
        if made is not None:
            located(self.read, made)
        return made is not None


def _of_alternative(alternative: Alternative, budget: Budget, checked: _Checked) -> Iterator[_Part]:
    """The law on the components of one alternative of its level."""
    try:
        claims = polynomial_problems(alternative.system, alternative.law)
    except OutOfReachError as reason:
        yield _Part(alternative.chosen, Proof(0, failure=str(reason)))
        return
    for claim in claims:
        grounds = LevelSet(claim.system, claim.law.on).components
        for ground in grounds:
            part = _on(ground, claim, budget, checked)
            yield replace(part, chosen=(*alternative.chosen, *ground.chosen))
            if part.trial is not None or (part.proof.failure and not ground.chosen):
                return
        for excluded in claim.excluded:
            yield _Part((*alternative.chosen, excluded), Proof(0, failure="not decided"))


def _on(ground: LevelSet, claim: Claim, budget: Budget, checked: _Checked) -> _Part:
    """The law on one component."""
    # motions may leave a part on which an initial vanishes for the rest of the component
    points = replace(ground, inner=True) if ground.parent else ground
    law = claim.law
    sample: dict[str, float] | None = None
    first: Trial | None = None
    # a rank is that at almost all points, not the one where an initial vanishes
    attained = ground.parent is not None
    for trial in trials(law, points):
        if trial.witness is not None:
            refuted = checked.refutation(claim, points, trial)
            if refuted is not None:
                return refuted
            continue
        if trial.lack is not None and trial.lack[0] == DIMENSION:
            failed = replace(trial, witness=trial.lack)
            return _Part((), trial=failed, point=points.point_shown(trial.field))
        first = first or trial
        sample = sample or {name: float(value) for name, value in trial.field.values.items()}
        attained = attained or trial.lack is None
    if first is None:
        last = backwards(law, points)
        if last is not None and last.witness is not None:
            refuted = checked.refutation(claim, points, last)
            if refuted is not None:
                return refuted
        if isinstance(law, Measure) and positives(law, ground):
            return _Part((), Proof(0, failure=NOWHERE))
    found = proof(law, ground, sample, budget, attained)
    if found.lack is not None and first is not None:
        failed = replace(first, witness=found.lack)
        return _Part((), trial=failed, point=points.point_shown(first.field))
    if found.failure or found.conditions:
        for trial in trials(law, points, FURTHER):
            refuted = trial.witness and checked.refutation(claim, points, trial)
            if refuted:
                return refuted
    return _Part((), found, needs=_needs(law, ground), remark=_remark(law, ground, first))


def _needs(law: Law, ground: LevelSet) -> tuple[tuple[str, str], ...]:
    """Time must run forward: rates of time not known to be positive, in words and as formulas."""
    if not isinstance(law, Isomorphism) or ground.sign(to_components(law.time)) is Sign.POSITIVE:
        return ()
    return tuple(
        (f"{what} > 0", f"{formula} > 0")
        for what, formula in positives(law, ground)
        if ground.sign(formula) is not Sign.POSITIVE
    )


def _remark(law: Law, ground: LevelSet, first: Trial | None) -> str:
    """What is to be said of a law that holds: where a density is real, what is trivial."""
    if isinstance(law, Measure):
        return _of_density(law, ground)
    try:
        said = first is not None and remark(law, ground, first.field)
        return f"; {said}" if said and said == remark(law, ground, _symbols(ground)) else ""
    except (NotExactError, OutOfReachError, NeedMoreGeneratorsError, ZeroDivisionError):
        return ""


def _symbols(ground: LevelSet) -> FunctionField:
    return ground.fractions(FunctionField, 32, None, Budget())


def _of_density(law: Measure, ground: LevelSet) -> str:
    real = [
        f"{text(formula)} > 0"
        for _, formula in positives(law, ground)
        if ground.sign(formula) is not Sign.POSITIVE
        # an even power is positive where the density is defined at all
        and not (formula.is_Pow and formula.exp.is_even)
    ]
    signed = [
        f"({text(formula)})"
        for _, formula in orienting(law, ground)
        if abs(ground.sign(formula)) != Sign.POSITIVE
    ]
    return (f"; ρ is real where {', '.join(real)}" if real else "") + (
        f"; a signed measure, with the sign of {' · '.join(signed)}" if signed else ""
    )


def _refuted(law: Law, failed: _Part, parts: list[_Part]) -> Verdict:
    assert failed.trial is not None and failed.trial.witness is not None
    what, residual = failed.trial.witness
    place = f"a point where {failed.where}" if failed.chosen else "a point"
    holds = [
        part.where
        for part in parts
        if part.chosen
        and part.proof.residuals
        and not part.proof.failure
        and not part.proof.conditions
    ]
    besides = f"; it holds where {', and where '.join(dict.fromkeys(holds))}" if holds else ""
    found = {"point": failed.point, "what": what, "residual": str(residual)}
    return Verdict(
        law.name,
        "refuted",
        shown=f"{what} fails at {place}{besides}",
        witness=found | (vars(failed.witness) if failed.witness is not None else {}),
    )


def _words(law: Law, count: int, parts: int) -> str:
    kind = {Isomorphism: "carried onto the target", PoissonStructure: "Jacobi identity"}
    extra = next((words for cls, words in kind.items() if isinstance(law, cls)), "")
    many = "1 residual is" if count == 1 else f"{count} residuals are"
    on = f" on {parts} components" if parts > 1 else ""
    return f"{many} zero modulo the relations{on}" + (f" ({extra})" if extra else "")
