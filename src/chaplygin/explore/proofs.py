"""Verdicts within a given time, and the proven laws as facts that can be pointed to."""

from __future__ import annotations

import time
from dataclasses import dataclass, field

from ..claims import heading
from ..errors import InputError
from ..laws.memory import fingerprint, recall
from ..laws.prove import prove
from ..laws.verdict import Verdict
from ..statements import Law
from ..system import System

__all__ = ["HERE", "Fact", "Patience", "fact_of"]

HERE = "found here"
"""Source of a law that is not claimed of a system but was tried and proven."""


@dataclass(frozen=True)
class Fact:
    """A proven law on which a statement rests.

    Attributes
    ----------
    law : str
        Its name.
    words : str
        What it is, in a few words.
    source : str
        Where it is stated.
    system : str
        Title of the system whose law it is, where that is not the system spoken of.
    functions : int
        How many independent functions it gives, where it gives several.
    """

    law: str
    words: str
    source: str = ""
    system: str = ""
    functions: int = 1

    @property
    def linked(self) -> bool:
        """Whether it is a law that the system itself states."""
        return not self.system and self.source != HERE

    def __str__(self) -> str:
        several = f"({self.functions} functions)" if self.functions > 1 else ""
        elsewhere = f"by the laws of: {self.system}" if self.system else ""
        return " ".join(filter(None, (self.law, self.source, several, elsewhere)))


def fact_of(law: Law, system: str = "") -> Fact:
    """A law as something to point to."""
    return Fact(law.name, str(getattr(law, "meaning", "")) or heading(law), law.source, system)


@dataclass
class Patience:
    """How long proofs may take: a verdict that is kept on disk costs nothing.

    Parameters
    ----------
    seconds : float
        For one law.
    altogether : float
        For all laws asked for, from the first to the last.
    """

    seconds: float
    altogether: float = float("inf")
    spent: float = field(default=0.0, init=False)

    def verdict(self, system: System, law: Law) -> Verdict:
        """What can be proven of a law in the time that is left."""
        allowed = min(self.seconds, self.altogether - self.spent)
        began = time.monotonic()
        try:
            if allowed > 0:
                return self._explained(prove(system, law, seconds=allowed))
            kept = recall(fingerprint(system, law))
        except InputError as problem:
            return Verdict(law.name, "undecided", reason=str(problem))
        finally:
            self.spent += time.monotonic() - began
        return kept or Verdict(law.name, "undecided", reason=self._over())

    def verdicts(self, system: System) -> dict[str, Verdict]:
        """The verdicts on all laws of a system, by name."""
        return {law.name: self.verdict(system, law) for law in system.laws}

    def _explained(self, verdict: Verdict) -> Verdict:
        if "the time given ran out" not in verdict.reason:
            return verdict
        reason = f"not proven within {self.seconds:g} s"
        return Verdict(verdict.law, "undecided", reason=reason, seconds=verdict.seconds)

    def _over(self) -> str:
        return f"not tried, as the {self.altogether:g} s for all proofs together were spent"
