"""Claims about invariant measures, decided by `invariant_measure` and its theorems.

The theorems and their proofs are in nonholonomic/docs/measures.md: a measure with a smooth density
that is positive up to rest exists only if there is one whose density depends on the configuration
alone.
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
        With numerical parameters, or with parameters outside the conditions of its theorem.
    name : str
        Name of the system.

    Returns
    -------
    Verdict
        Proven if `invariant_measure` excludes a measure, or excludes it outside certain values of
        the parameters, which its finding names; otherwise undecided.
    """
    found = invariant_measure(source, name)
    excluded = found.decision == "none" or (found.decision == "conditional" and found.complete)
    return computed_verdict(
        "no measure",
        excluded,
        f"{found}".replace("\n", "; "),
        f"invariant_measure: {found.decision}",
    )
