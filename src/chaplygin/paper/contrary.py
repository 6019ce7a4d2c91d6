"""Verdicts on a statement from verdicts on what contradicts it."""

from __future__ import annotations

from dataclasses import replace

from ..laws.verdict import Decision, Verdict

__all__ = ["contrary"]

_OPPOSITE: dict[Decision, Decision] = {
    "proven": "refuted",
    "refuted": "proven",
    "undecided": "undecided",
}


def contrary(verdict: Verdict) -> Verdict:
    """The verdict on the opposite statement.

    What was shown, and the witness if there is one, are kept.
    """
    witness = verdict.witness or {"shown": verdict.shown}
    return replace(verdict, decision=_OPPOSITE[verdict.decision], witness=witness)
