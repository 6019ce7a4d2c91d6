"""Claims of the paper: the printed and the corrected form, and their decisions."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TypeAlias

from ..core.laws import Law
from ..core.system import System
from ..proof.verdict import Verdict

#: A system with a law of it, several such pairs that must all hold, or a verdict computed directly.
Case: TypeAlias = tuple[System, Law] | tuple[tuple[System, Law], ...] | Verdict


@dataclass(frozen=True)
class Claim:
    """One statement of the paper that a computation can decide.

    Parameters
    ----------
    source : str
        ``"(6.1)"``, ``"Theorem 7"``, ``"Remark 15"``, or section and a few words for an
        unnumbered claim, such as ``"§5, after (5.2)"``.
    statement : str
        What is printed: plain words with formulas in LaTeX between dollar signs, word for word
        in every sign that matters.
    printed : callable
        Makes the printed claim as a `Case`, or decides it.
    corrected : callable, optional
        The system and law of the right statement, where the printed one fails.
    correction : str
        The right statement, written as `statement` is.
    note : str
        What was wrong with the printed form, in one phrase; or how it had to be read.
    argument : str
        What carries the computation over to all that the statement speaks of, such as any number
        of coordinates; empty where the computation covers it.
    where : tuple of str
        Conditions under which the form that holds is proven, and which the statement lacks. With
        any of them the verdict is "proven where" at best.

    Examples
    --------
    >>> import chaplygin as ch
    >>> section, claim = ch.borisov_mamaev.claims(6)[0]
    >>> section, claim.source
    (6, '(6.1)')
    """

    source: str
    statement: str
    printed: Callable[[], Case]
    corrected: Callable[[], Case] | None = None
    correction: str = ""
    note: str = ""
    argument: str = ""
    where: tuple[str, ...] = ()

    def restricted(self, verdict: Verdict) -> Verdict:
        """A verdict on a form of the claim, under the conditions of the claim.

        Parameters
        ----------
        verdict : Verdict
            On the laws in which the form is cast.

        Returns
        -------
        Verdict
            "proven where" `where` holds, if the laws are proven; refuted and undecided stay.

        Examples
        --------
        >>> from chaplygin.borisov_mamaev import Claim
        >>> from chaplygin.proof.verdict import Verdict
        >>> proven = Verdict("law", "proven")
        >>> Claim("(1)", "$x$", lambda: proven, where=("n = 3",)).restricted(proven).statement
        'proven where n = 3'
        """
        if not self.where or verdict.decision not in ("proven", "proven where"):
            return verdict
        conditions = (*verdict.conditions, *self.where)
        return replace(verdict, decision="proven where", conditions=conditions, formulas=())


@dataclass(frozen=True)
class Remark:
    """A statement of the paper that was not computed: literature, history or judgement.

    Parameters
    ----------
    source : str
        The section or formula.
    statement : str
    reason : str
        Why it was not computed.

    Examples
    --------
    >>> import chaplygin as ch
    >>> ch.borisov_mamaev.remarks(6)[0].reason
    'a comparison'
    """

    source: str
    statement: str
    reason: str
