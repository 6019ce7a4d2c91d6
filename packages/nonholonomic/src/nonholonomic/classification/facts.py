"""Verdicts within a given effort, and proven laws as citable facts."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from flowlanes.arguments import arguments_checked
from flowlanes.system.laws import Law
from flowlanes.system.system import System
from lawproof.proof.prover import judgement_of, prove
from lawproof.proof.verdict import NOT_TRIED, Verdict

EFFORT_SPENT = f"{NOT_TRIED}, as the effort for all laws together was spent"
"""Reason of an undecided law for which no effort was left."""
LEFT_OUT = f"{NOT_TRIED}, as proofs were left out"
"""Reason of an undecided law if no proofs were wanted."""
HERE = "found here"
"""Source of a law that was proven here and is not stated with the system."""


@dataclass(frozen=True)
class Fact:
    """A proven law on which a statement is based.

    Attributes
    ----------
    law : str
        Name of the law.
    words : str
        The fact in a few words.
    source : str
        The place in the literature.
    system : str
        Title of the system of the law, if it is not the classified one.
    functions : int
        Number of independent functions, if there are several.
    """

    law: str
    words: str
    source: str = ""
    system: str = ""
    functions: int = 1

    @property
    def is_own_law(self) -> bool:
        """Whether the law belongs to the system itself; used by the page of a report."""
        return not self.system and self.source != HERE

    def __str__(self) -> str:
        several = f"({self.functions} functions)" if self.functions > 1 else ""
        elsewhere = f"by the laws of: {self.system}" if self.system else ""
        return " ".join(filter(None, (self.law, self.source, several, elsewhere)))


def fact_of(law: Law, system: str = "") -> Fact:
    """A law as a citable fact."""
    return Fact(law.name, str(getattr(law, "meaning", "")) or law.heading, law.source, system)


@arguments_checked
@dataclass
class ProofBudget:
    """The effort that proofs may take, measured identically on every machine.

    The cost of a verdict is that of its proof, whether the proof is new or read from the cache.  A
    proof that took more than is allowed here does not count: the result depends neither on the
    machine nor on earlier proofs.

    Parameters
    ----------
    effort : int
        Term operations for one law.
    total_budget : int, optional
        Term operations after which no further law is tried; with 0 none is.
    progress : callable
        Called with a description of the next attempt.

    Examples
    --------
    >>> import nonholonomic
    >>> from nonholonomic.classification.facts import ProofBudget
    >>> budget = ProofBudget(effort=10**8)
    >>> budget.verdict(
    ...     nonholonomic.from_catalogue("suslov"), nonholonomic.from_catalogue("suslov").laws[0]
    ... ).decision
    'proven'
    >>> budget.over
    False
    """

    effort: int
    total_budget: int | None = None
    progress: Callable[[str], object] = field(default=lambda _: None, compare=False)
    effort_used: int = field(default=0, init=False)

    @property
    def over(self) -> bool:
        """Whether no further law is tried."""
        return self.total_budget is not None and self.effort_used >= self.total_budget

    @arguments_checked
    def verdict(self, system: System, law: Law) -> Verdict:
        """The verdict on a law within the allowed effort."""
        if self.over:
            reason = EFFORT_SPENT if self.total_budget else LEFT_OUT
            return Verdict(law.name, "undecided", reason=reason)
        self.progress(f"{law.name} of {system.title}")
        verdict = judgement_of(prove, system, law, self.effort)
        self.effort_used += verdict.effort
        return verdict

    @arguments_checked
    def verdicts(self, system: System) -> dict[str, Verdict]:
        """The verdicts on all laws of a system, by name."""
        return {law.name: self.verdict(system, law) for law in system.laws}
