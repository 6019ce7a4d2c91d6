"""Claims of the paper: the printed and the corrected form, and their decisions.

Rules by which every printed statement is read:

1. Words and formulas are judged as they stand. A lost "not", a sign, an index, another letter:
   what they state is what is decided.
2. The number of a formula, a theorem or a figure states nothing itself. A wrong one is read as
   the one that the context leaves no doubt of, and is an *erratum*; so is a name or a mark that
   stands for nothing where it is printed. An erratum is told beside the verdict; it refutes
   nothing.
3. A constant of which nothing is said but that it is constant, such as "h = const", is any
   number: its sign, its scale and its letter are no part of the statement. A constant whose value
   or range is given is that one, and the statement must hold for all of the range.
4. A slip counts where it is printed. What a statement takes from an earlier one is taken as put
   right there; if the wrong formula is printed again, it is wrong again. Where two statements
   contradict each other, the reading with the fewest slips is taken.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import NoReturn, TypeAlias

from flowlanes.system.laws import Law
from flowlanes.system.system import System
from lawproof.proof.verdict import Decision, Verdict

#: A system with one of its laws, several such pairs that must all hold, or a verdict computed
#: directly.
Case: TypeAlias = tuple[System, Law] | tuple[tuple[System, Law], ...] | Verdict


_NOT_PICKLED = (
    "what decides a claim is a function, which cannot be pickled: pickle the source and the "
    "statement, or the record() of a judgement"
)


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
    erratum : str
        A slip of the print that changes no statement, and how it is read: rules 2 and 3 above.
    argument : str
        What carries the computation over to all that the statement speaks of, such as any number
        of coordinates; empty where the computation covers it.
    where : tuple of str
        Conditions under which the form that holds is proven, and which the statement lacks. With
        any of them the verdict is "proven where" at best.

    Examples
    --------
    >>> import borisov_mamaev_2008
    >>> section, claim = borisov_mamaev_2008.claims(6)[0]
    >>> section, claim.source
    (6, '(6.1)')
    """

    source: str
    statement: str
    printed: Callable[[], Case] = field(repr=False)
    corrected: Callable[[], Case] | None = field(default=None, repr=False)
    correction: str = ""
    note: str = ""
    erratum: str = ""
    argument: str = ""
    where: tuple[str, ...] = ()

    def __reduce__(self) -> NoReturn:
        raise TypeError(_NOT_PICKLED)

    def under_conditions(self, verdict: Verdict) -> Verdict:
        """A verdict on a form of the claim, subject to the conditions of the claim.

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
        >>> from borisov_mamaev_2008 import Claim
        >>> from lawproof.proof.verdict import Verdict
        >>> proven = Verdict("law", "proven")
        >>> Claim("(1)", "$x$", lambda: proven, where=("n = 3",)).under_conditions(proven).statement
        'proven where n = 3'
        """
        if not self.where or verdict.decision not in ("proven", "proven where"):
            return verdict
        conditions = (*verdict.conditions, *self.where)
        return replace(verdict, decision="proven where", conditions=conditions, formulas=())


@dataclass(frozen=True)
class Finding:
    """A statement about an open question, with its decision.

    Parameters
    ----------
    key : str
        The row in the table of docs/open-problems.md.
    statement : str
        Plain words with formulas in Unicode.
    decision : str
        As the page quotes it; the audit computes it anew.
    decide : callable
        The laws that decide it, or the verdict.

    Examples
    --------
    >>> import borisov_mamaev_2008
    >>> {f.key for remark in borisov_mamaev_2008.remarks(12) for f in remark.findings} >= {"lift"}
    True
    """

    key: str
    statement: str
    decision: Decision
    decide: Callable[[], Case] = field(repr=False)

    def __reduce__(self) -> NoReturn:
        raise TypeError(_NOT_PICKLED)


@dataclass(frozen=True)
class Remark:
    """A statement of the paper that was not computed: literature, history or opinion.

    Parameters
    ----------
    source : str
        The section or formula.
    statement : str
    reason : str
        Why it was not computed.
    findings : tuple of Finding
        What is decided here of an open question.

    Examples
    --------
    >>> import borisov_mamaev_2008
    >>> borisov_mamaev_2008.remarks(6)[0].reason
    'a comparison'
    """

    source: str
    statement: str
    reason: str
    findings: tuple[Finding, ...] = ()
