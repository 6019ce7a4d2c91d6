"""Verdicts: outcomes of proof attempts."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

from flowlanes.system.overview import Overview, WithOverview

Decision = Literal["proven", "proven where", "refuted", "undecided", "refused"]


NOT_TRIED = "not tried"
"""Prefix of the reason of a verdict for which no effort was allowed."""


@dataclass(frozen=True, repr=False)
class Verdict(WithOverview):
    """The outcome of an attempt to prove a law.

    Attributes
    ----------
    law : str
        Name of the law.
    decision : ``"proven"``, ``"proven where"``, ``"refuted"``, ``"undecided"`` or ``"refused"``
        Proven: an exact computation that covers the whole level; proven where: one that covers
        the points of the level that satisfy `conditions`; refuted: an exact or ball-arithmetic
        witness; undecided: none of these, for the `reason` given; refused: among several laws, one
        that states nothing, such as a density that is real nowhere: the `reason` says why.
    conditions : tuple of str
        Conditions on the points covered, such as ``"x > 0"`` or ``"not y = 0"``; empty unless the
        decision is "proven where".
    formulas : tuple of str
        The conditions as Python expressions, such as ``"x > 0"`` or ``"y != 0"``; an empty string
        for a condition that is not a single formula.
    finding : str
        Summary of the result.
    reason : str
        Why it is undecided or refused; empty otherwise.
    terms : int
        Number of terms of the largest polynomial.
    seconds : float
        Computing time on the machine that decided the law.
    effort : int
        Term operations used; a smaller effort would leave the law undecided.
    witness : mapping, optional
        For a refutation: the ``"point"`` (name ↦ exact number or ball), ``"what"`` fails there and
        the ``"residual"``; and, for the checker, the point in the format of a certificate
        (``"place"``), the index of the residual (``"index"``) and its ``"value"``.
    certificate : mapping, optional
        Data from which another program can check the verdict.
    no_certificate : str
        Why there is no certificate, if one was requested.
    identities : tuple of mappings
        For a law that follows from a theorem and has no certificate of its own: the certificates
        of the identities to which the theorem reduces it. For a law certified in several ranges of
        its parameters (`in_ranges`): the certificates for each range.
    in_ranges : bool
        Whether the law is certified separately in each range of its parameters.

    Examples
    --------
    >>> import flowlanes
    >>> import lawproof
    >>> import sympy as sp
    >>> a, b, c = sp.symbols("a b c", real=True)
    >>> top = flowlanes.System("top", "Euler's top", {a: -b * c, b: 4 * a * c, c: -3 * a * b})
    >>> verdict = lawproof.prove(top, flowlanes.Integral("a", a))
    >>> verdict.decision, bool(verdict), verdict.witness["what"]
    ('refuted', False, 'v(F)')
    """

    law: str
    decision: Decision
    finding: str = ""
    reason: str = ""
    conditions: tuple[str, ...] = ()
    formulas: tuple[str, ...] = ()
    terms: int = 0
    seconds: float = 0.0
    effort: int = 0
    witness: dict[str, Any] | None = None
    certificate: dict[str, Any] | None = None
    no_certificate: str = ""
    identities: tuple[dict[str, Any], ...] = ()
    in_ranges: bool = False

    @property
    def is_untried(self) -> bool:
        """True if it is undecided because no effort was allowed."""
        return self.reason.startswith(NOT_TRIED)

    @property
    def statement(self) -> str:
        """The decision with its conditions."""
        if self.is_untried:
            return NOT_TRIED
        return " ".join((self.decision, ", ".join(self.conditions))).rstrip()

    @property
    def words(self) -> str:
        """The decision with its conditions and the reason why it is open."""
        if self.is_untried:
            return self.reason
        return f"{self.statement}: {self.reason}" if self.reason else self.statement

    def overview(self) -> Overview:
        """Law and decision, the finding or reason, and the cost."""
        point = (self.witness or {}).get("point", {})
        return Overview(
            f"{self.law}: {self.statement}",
            (
                ("shown", self.finding),
                ("reason", self.reason),
                ("refuted at", ", ".join(f"{name} = {value}" for name, value in point.items())),
                ("no certificate", self.no_certificate),
                ("effort", f"{self.effort:,} term operations, {self.seconds:.3g} s"),
            ),
        )

    def __bool__(self) -> bool:
        return self.decision == "proven"
