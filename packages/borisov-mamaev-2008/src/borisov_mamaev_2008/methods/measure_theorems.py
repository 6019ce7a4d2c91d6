"""Claims about invariant measures, decided by `invariant_measure` and its theorems.

nonholonomic/docs/measures.md has the theorems with their proofs: a measure whose density is
smooth, and positive up to rest, exists only if one with a density of the configuration does.
"""

from __future__ import annotations

from lawproof.proof.verdict import Verdict
from nonholonomic.invariant_measures import invariant_measure
from nonholonomic.mechanics.lagrangian.mechanism import Mechanism
from nonholonomic.mechanics.rolling.equations import RollingBody

from .derived_verdicts import computed_verdict


def has_no_measure(source: RollingBody | Mechanism, name: str) -> Verdict:
    """The verdict on the claim that there is no measure with a smooth positive density.

    Parameters
    ----------
    source : RollingBody or Mechanism
        With numbers, or with parameters outside the conditions of its theorem.
    name : str
        Of the system.

    Returns
    -------
    Verdict
        Proven where `invariant_measure` says that there is none, or none outside certain levels of
        the parameters, which its finding names; else undecided.
    """
    found = invariant_measure(source, name)
    excluded = found.decision == "none" or (found.decision == "conditional" and found.complete)
    return computed_verdict(
        "no measure",
        excluded,
        f"{found}".replace("\n", "; "),
        f"invariant_measure: {found.decision}",
    )
