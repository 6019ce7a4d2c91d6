"""Verdicts on a statement from verdicts on what contradicts it."""

from __future__ import annotations

from dataclasses import replace

from ...proof.verdict import Decision, Verdict

_OPPOSITE: dict[Decision, Decision] = {
    "proven": "refuted",
    "refuted": "proven",
    "undecided": "undecided",
}


def contrary(verdict: Verdict) -> Verdict:
    """The verdict on the opposite statement.

    The text and the witness, if there is one, are kept.  A statement proven only under conditions
    does not decide the opposite.
    """
    if verdict.decision == "proven where":
        where = ", ".join(verdict.conditions)
        return replace(
            verdict, decision="undecided", conditions=(), reason=f"excluded only where {where}"
        )
    witness = verdict.witness or {"shown": verdict.finding}
    return replace(verdict, decision=_OPPOSITE[verdict.decision], witness=witness)
