"""What a proof attempt came to."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Literal

__all__ = ["Decision", "Verdict"]

Decision = Literal["proven", "refuted", "undecided"]


@dataclass(frozen=True)
class Verdict:
    """The outcome of an attempt to prove a law.

    Attributes
    ----------
    law : str
        Name of the law.
    decision : ``"proven"``, ``"refuted"`` or ``"undecided"``
        Proven: an exact computation; refuted: an exact or ball-arithmetic witness; undecided:
        neither, for the `reason` given.
    shown : str
        What was shown, in a few words.
    reason : str
        Why it is undecided; empty otherwise.
    terms : int
        Size of the largest polynomial met.
    seconds : float
    witness : mapping, optional
        Of a refutation: the point (name ↦ exact number or ball) and the residual there.
    certificate : mapping, optional
        What another program needs in order to check the verdict.
    """

    law: str
    decision: Decision
    shown: str = ""
    reason: str = ""
    terms: int = 0
    seconds: float = 0.0
    witness: dict[str, Any] | None = None
    certificate: dict[str, Any] | None = field(default=None, repr=False)

    def __bool__(self) -> bool:
        return self.decision == "proven"
