"""Verdicts derived from a computation, from other verdicts, or from a contradicting statement."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from flowlanes.system.laws import Law
from flowlanes.system.system import System
from lawproof.proof.prover import prove
from lawproof.proof.verdict import Decision, Verdict


def computed_verdict(
    name: str,
    holds: object,
    finding: str = "",
    otherwise: str = "",
    *,
    decision: Decision = "proven",
    **details: Any,
) -> Verdict:
    """The verdict of a computation: `decision` if it holds, otherwise undecided, with a reason."""
    result: Decision = decision if holds else "undecided"
    return Verdict(name, result, finding=finding, reason="" if holds else otherwise, **details)


def conclusion_verdict(
    name: str, finding: str, rests_on: Iterable[Verdict | tuple[System, Law]]
) -> Verdict:
    """Proven if all premises of a conclusion are proven.

    Parameters
    ----------
    name : str
    finding : str
        The conclusion, in a few words.
    rests_on : verdicts, or laws with their systems

    Returns
    -------
    Verdict
        Undecided if some premise is not proven: a false premise does not prove the opposite.
    """
    verdicts = [v if isinstance(v, Verdict) else prove(*v) for v in rests_on]
    missing = [v for v in verdicts if not v]
    reasons = "; ".join(
        f"{v.law}: {v.reason or ', '.join((v.decision, *v.conditions))}" for v in missing
    )
    return Verdict(
        name,
        "undecided" if missing else "proven",
        finding="" if missing else finding,
        reason=reasons,
        terms=max((v.terms for v in verdicts), default=0),
        seconds=sum(v.seconds for v in verdicts),
    )


_OPPOSITE: dict[Decision, Decision] = {
    "proven": "refuted",
    "refuted": "proven",
    "undecided": "undecided",
}


def contrary(verdict: Verdict) -> Verdict:
    """The verdict on the negation of a statement.

    The text and the witness, if there is one, are kept. A statement proven only under conditions
    does not decide its negation.
    """
    if verdict.decision == "proven where":
        where = ", ".join(verdict.conditions)
        return replace(
            verdict, decision="undecided", conditions=(), reason=f"excluded only where {where}"
        )
    witness = verdict.witness or {"shown": verdict.finding}
    return replace(verdict, decision=_OPPOSITE[verdict.decision], witness=witness)
