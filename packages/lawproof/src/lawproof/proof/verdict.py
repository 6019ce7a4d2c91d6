"""Verdicts: the outcomes of proof attempts."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

from flowlanes.system.overview import Overview, WithOverview

Decision = Literal["proven", "proven where", "refuted", "undecided", "refused"]


NOT_TRIED = "not tried"
"""The beginning of the reason of a verdict for which no work was allowed."""


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
        What the points covered satisfy, such as ``"x > 0"`` or ``"not y = 0"``; empty unless the
        decision is "proven where".
    formulas : tuple of str
        The conditions in the words of Python, such as ``"x > 0"`` or ``"y != 0"``; an empty text
        for one that says more than a formula does.
    finding : str
        What was shown, in a few words.
    reason : str
        Why it is undecided or refused; empty otherwise.
    terms : int
        Size of the largest polynomial met.
    seconds : float
        Time that it took, on the machine that decided it.
    effort : int
        Term operations that it took; with fewer allowed it stays undecided.
    witness : mapping, optional
        Of a refutation: the ``"point"`` (name ↦ exact number or ball), ``"what"`` fails there
        and the ``"residual"``; and for its check the point as a certificate gives it
        (``"place"``), the number of the residual (``"index"``) and its ``"value"``.
    certificate : mapping, optional
        What another program needs in order to check the verdict.
    no_certificate : str
        Why there is no certificate, where one was asked for.
    identities : tuple of mappings
        Of a law without a certificate of its own that follows from a theorem: the certificates of
        the identities that the theorem leaves to be proven; of one whose parameters have several
        ranges (`in_ranges`) those in each range.
    in_ranges : bool
        Whether the law is certified in each range of its parameters by itself.

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
        """Whether it is undecided because nothing was tried."""
        return self.reason.startswith(NOT_TRIED)

    @property
    def statement(self) -> str:
        """The decision, with the conditions under which it holds."""
        if self.is_untried:
            return NOT_TRIED
        return " ".join((self.decision, ", ".join(self.conditions))).rstrip()

    @property
    def words(self) -> str:
        """The decision, with its conditions and with the reason for leaving it open."""
        if self.is_untried:
            return self.reason
        return f"{self.statement}: {self.reason}" if self.reason else self.statement

    def overview(self) -> Overview:
        """Law and decision, what was shown or why not, and what it cost."""
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
