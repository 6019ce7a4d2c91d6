"""Claims of the paper: the printed and the corrected form, and their decisions."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
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
