"""Claims of the paper: the printed and the corrected form, and their decisions.

Every printed statement is read by these rules:

1. Words and formulas are checked exactly as printed. A missing "not", a wrong sign, index or
   letter is part of the statement.
2. The number of a formula, a theorem or a figure is not a statement. A wrong number is replaced
   by the one that is clear from the context, and is an *erratum*; so is a name or a mark without
   a meaning in its place. An erratum is reported together with the verdict; it refutes nothing.
3. A constant without further information, such as "h = const", is any number: its sign, its
   scale and its letter are not part of the statement. A constant with a given value or range has
   this value or range, and the statement must be valid in the whole range.
4. An error is reported where it is printed. Where a later statement depends on it, the corrected
   form is used; if the wrong formula is printed again, it is wrong again. If two statements
   contradict each other, the reading with the smallest number of errors is used.
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
        Printing error that changes no statement, and its correction: rules 2 and 3 above.
    argument : str
        Argument that extends the computation to the whole statement, such as any number of
        coordinates; empty if the computation itself is sufficient.
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
