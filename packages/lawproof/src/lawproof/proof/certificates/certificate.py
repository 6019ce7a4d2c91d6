"""Certificates: the data from which an independent program can check a verdict.

A certificate of a proof contains the complete claim, a ring with the meanings of its generators,
every residual as a fraction of polynomials, and a tree of identities which shows that the
numerators vanish; a certificate of a refutation contains a point. The format is defined by
:mod:`certificate_checker`, which shares no code with the prover; every certificate is checked
before it is returned.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from certificate_checker import FORMAT, BadInputError, CheckError, check
from certificate_checker.certificate_points import point_of_level
from certificate_checker.claim.claim import Claim as CheckedClaim, read_claim
from certificate_checker.claim.errors import UndefinedError
from certificate_checker.claim.formulas import name
from certificate_checker.claim.parsing import parse_condition
from certificate_checker.claim.power import IDENTITIES
from flowlanes.arguments import arguments_checked
from flowlanes.formulas.errors import OutOfReachError
from flowlanes.formulas.number_fields import ball_precision
from flowlanes.system.laws import Law
from flowlanes.system.system import System

from ..claim_text import Text, claim_text
from ..fields.budget import EFFORT, Budget
from ..fields.quotient_ring import Poly
from ..fields.unreduced_fields import UnreducedField, UnreducedFormal
from ..level.alternatives import alternatives, ranges_of_parameters
from ..level.level_set import LevelSet
from ..level.polynomial_problems import polynomial_problems
from ..power_theorem import PowerTheorem
from ..prover import judgement_of, prove
from ..random_test import FIRST, FURTHER, trials
from ..symbolic_proof import MOST_RUNS, flipped_decisions
from ..theorems import identities_of, rates_text, theorem_of
from ..verdict import Verdict
from ..witness_points import witness_point
from .identities import ExclusionOf, proof_text
from .proof_setting import ProofSetting

#: Divisor of the effort for the direct certificate of a law that a theorem proves already.
BESIDE_THEOREM = 50


@arguments_checked
def prove_with_certificate(system: System, law: Law, effort: int = EFFORT) -> Verdict:
    """Prove or refute a law and return the verdict with a checked certificate.

    Parameters
    ----------
    system : System
    law : Law
    effort : int
        Term operations allowed for the verdict, and as many again for the certificate.

    Returns
    -------
    Verdict
        Without a certificate if the law is undecided or no certificate could be made; then
        `no_certificate` gives the reason, and `identities` holds the certificates of the
        identities to which a theorem reduces the law.

    Raises
    ------
    InputError
        As for :func:`lawproof.proof.prover.prove`.

    Examples
    --------
    >>> import flowlanes
    >>> import lawproof
    >>> import sympy as sp
    >>> a, b, c = sp.symbols("a b c", real=True)
    >>> top = flowlanes.System("top", "Euler's top", {a: -b * c, b: 4 * a * c, c: -3 * a * b})
    >>> square = flowlanes.Integral("square", a**2 + b**2 + c**2)
    >>> verdict = lawproof.proof.prove_with_certificate(top, square)
    >>> verdict.decision, verdict.certificate is not None
    ('proven', True)
    """
    theorem = theorem_of(system, law)
    verdict = prove(system, law, effort=effort)
    if verdict.decision == "undecided":
        return verdict
    law = law.basic(system)
    ranges = ranges_of_parameters(system)
    if len(ranges) > 1:
        each = [judgement_of(prove_with_certificate, part, law, effort) for part in ranges]
        return _in_ranges(verdict, each)
    try:
        if isinstance(theorem, PowerTheorem):
            certificate = _by_power(system, law, theorem, verdict, effort)
        else:
            own = effort if theorem is None else effort // BESIDE_THEOREM
            certificate = _certificate(system, law, verdict, own)
        check(certificate)
    except OutOfReachError as reason:
        verdict = replace(verdict, no_certificate=str(reason))
    except (BadInputError, CheckError) as reason:
        verdict = replace(verdict, no_certificate=f"the certificate does not check: {reason}")
    else:
        return replace(verdict, certificate=certificate)
    if theorem is None or not verdict:
        return verdict
    parts = [
        prove_with_certificate(whole, identity, effort).certificate
        for whole in identities_of(theorem, system, law)
        for identity in whole.laws
    ]
    return replace(verdict, identities=tuple(p for p in parts if p is not None))


def _in_ranges(verdict: Verdict, each: list[Verdict]) -> Verdict:
    """The verdict with one certificate for each range of the parameters."""
    if verdict.decision == "refuted":
        failed = next((one for one in each if one.decision == "refuted"), verdict)
        return replace(failed, effort=verdict.effort, seconds=verdict.seconds)
    return replace(
        verdict,
        no_certificate="; ".join(
            one.no_certificate or one.reason for one in each if one.certificate is None
        ),
        identities=tuple(one.certificate for one in each if one.certificate is not None),
        in_ranges=True,
    )


def _certificate(system: System, law: Law, verdict: Verdict, effort: int) -> Text:
    claim = claim_text(system, law)
    content: Text = {"format": FORMAT, "verdict": verdict.decision, "claim": claim}
    if verdict.decision == "refuted":
        return content | {"witness": _witness(verdict)}
    if verdict.decision == "proven where":
        content["conditions"] = list(_condition_texts(verdict))
    read = read_claim(claim, "the claim")
    with ball_precision():
        sample = _sample(system, law, read, verdict.formulas)
    content["sample"] = sample
    return content | {"proofs": _proofs(system, law, read, sample, verdict, Budget(effort=effort))}


def _by_power(
    system: System, law: Law, theorem: PowerTheorem, verdict: Verdict, effort: int
) -> Text:
    """The certificate of an integral by the energy theorem; a direct one if the theorem fails."""
    wholes = identities_of(theorem, system, law) if verdict else ()
    parts = [prove_with_certificate(whole, whole.laws[0], effort) for whole in wholes]
    if not parts or not all(parts):
        return _certificate(system, law, verdict, effort)
    certificates = [_certificate_of(part) for part in parts]
    claim = claim_text(system, law)
    with ball_precision():
        sample = _sample(system, law, read_claim(claim, "the claim"), ())
    return {
        "format": FORMAT,
        "verdict": "proven",
        "claim": claim,
        "sample": sample,
        "rates": rates_text(theorem, system),
        "identities": {
            word: {"sample": part["sample"], "proofs": part["proofs"]}
            for word, part in zip(IDENTITIES, certificates, strict=True)
        },
    }


def _certificate_of(identity: Verdict) -> Mapping[str, Any]:
    if identity.certificate is None:
        raise OutOfReachError(f"{identity.law}: {identity.no_certificate}")
    return identity.certificate


def _witness(verdict: Verdict) -> Text:
    witness = verdict.witness or {}
    if "place" not in witness:
        raise OutOfReachError(
            "what is refuted is no residual that the check knows, but a dimension on the whole "
            "level, or the equation of a component"
        )
    return {
        "point": witness["place"],
        "what": witness["what"],
        "index": witness["index"],
        "residual": witness["value"],
    }


def _condition_texts(verdict: Verdict) -> tuple[str, ...]:
    if not verdict.formulas or not all(verdict.formulas):
        raise OutOfReachError("its conditions are not those of single formulas")
    return verdict.formulas


def _sample(system: System, law: Law, read: CheckedClaim, conditions: Sequence[str]) -> Text:
    """A point of the level, as text, at which the law is defined and the conditions hold."""
    for alternative in alternatives(system, law):
        claim = polynomial_problems(alternative.system, alternative.law)[-1]
        for level in LevelSet(claim.system, claim.law.level).components:
            points = replace(level, inner=True) if level.parent else level
            for trial in trials(claim.law, points, FURTHER if conditions else FIRST):
                point = None if trial.witness else witness_point(claim, points, trial.values)
                if point is not None and _is_located(read, point, conditions):
                    return point
    raise OutOfReachError("no point of its level was found with coordinates that can be written")


def _is_located(read: CheckedClaim, point: Text, conditions: Sequence[str]) -> bool:
    try:
        numbers = point_of_level(read, point)
        stated = [parse_condition(words, "a condition")[0] for words in conditions]
        return all(numbers(f) > 0 if sign == ">" else numbers(f) != 0 for f, sign in stated)
    except (CheckError, UndefinedError):
        return False


def _proofs(
    system: System,
    law: Law,
    read: CheckedClaim,
    sample: Mapping[str, object],
    verdict: Verdict,
    budget: Budget,
) -> list[Text]:
    level = LevelSet(system, law.level)
    numbers = point_of_level(read, sample)
    point = {str(s): float(numbers(name(str(s))).mid()) for s in level.generators}
    conditions = [
        (words, parse_condition(words, "a condition")[0][0]) for words in verdict.formulas
    ]

    def excluding_condition(setting: ProofSetting, poly: Poly) -> str | None:
        """The condition of the verdict that excludes the zeros of a polynomial, or None."""
        return next((words for words, formula in conditions if setting.states(formula, poly)), None)

    def setting_for(kind: type[UnreducedField], signs: Mapping[str, int]) -> ProofSetting:
        return ProofSetting(kind, read, law, level, point, budget, signs)

    first = setting_for(UnreducedField, {})
    if not first.field.decisions:
        if first.void:
            raise OutOfReachError("the law is not defined with the signs of its sample point")
        return [proof_text(first, excluding_condition, with_decisions=False)]
    with contextlib.suppress(OutOfReachError):
        formal = setting_for(UnreducedFormal, {})
        if not formal.void and not formal.field.decisions:
            return [proof_text(formal, excluding_condition, with_decisions=False)]
    return _by_signs(first, setting_for, excluding_condition)


def _by_signs(
    first: ProofSetting,
    setting_for: Callable[[type[UnreducedField], Mapping[str, int]], ProofSetting],
    excluding_condition: ExclusionOf,
) -> list[Text]:
    """One proof for every choice of signs for which the law is defined and holds."""
    proofs = []
    if not first.void:
        proofs.append(proof_text(first, excluding_condition, with_decisions=True))
    waiting = flipped_decisions(first.field, 0)
    runs = 1
    while waiting:
        signs, size, _ = waiting.pop()
        runs += 1
        if runs > MOST_RUNS:
            raise OutOfReachError(f"its roots have signs in more than {MOST_RUNS} ways")
        setting = setting_for(UnreducedField, signs)
        # A choice without a proof is skipped: the checker accepts that only if a condition
        # excludes it.
        with contextlib.suppress(OutOfReachError):
            if not setting.void:
                proofs.append(proof_text(setting, excluding_condition, with_decisions=True))
        waiting += flipped_decisions(setting.field, size)
    return proofs
