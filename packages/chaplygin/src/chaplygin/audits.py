"""The audit of a paper that ``chaplygin audit`` prints: found by its entry point.

A distribution offers one as an entry point of the group ``chaplygin.audits``, whose object (a
module may be one) has what `Audit` asks for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from importlib.metadata import entry_points
from typing import Any, Protocol, cast

from flowlanes.errors import InputError
from lawproof.proof.verdict import Decision, Verdict

GROUP = "chaplygin.audits"


class Claim(Protocol):
    """A statement of the paper, with its correction where it is wrong."""

    @property
    def source(self) -> str:
        """Where it stands in the paper."""
        ...

    @property
    def statement(self) -> str:
        """What is stated."""
        ...

    @property
    def correction(self) -> str:
        """The right statement."""
        ...

    @property
    def note(self) -> str:
        """What was wrong, in one phrase."""
        ...

    @property
    def erratum(self) -> str:
        """A slip of the print that changes no statement."""
        ...

    @property
    def argument(self) -> str:
        """What carries the computation over to all that is stated."""
        ...


class Judgement(Protocol):
    """A claim with the verdicts on it as printed and as corrected."""

    @property
    def section(self) -> int:
        """The section of the paper."""
        ...

    @property
    def claim(self) -> Claim:
        """The claim."""
        ...

    @property
    def printed(self) -> Verdict:
        """The verdict on the printed form."""
        ...

    @property
    def corrected(self) -> Verdict | None:
        """The verdict on the corrected form, where there is one."""
        ...

    @property
    def seconds(self) -> float:
        """The time that the proofs took."""
        ...

    @property
    def conditions(self) -> tuple[str, ...]:
        """Conditions of what is proven."""
        ...

    @property
    def reason(self) -> str:
        """Why something is undecided, or not computed."""
        ...

    def record(self) -> dict[str, Any]:
        """The judgement for another program."""
        ...


class Finding(Protocol):
    """What is decided here of a question that the paper leaves open."""

    @property
    def key(self) -> str:
        """Its row in the table of findings."""
        ...

    @property
    def statement(self) -> str:
        """What is stated."""
        ...


class Remark(Protocol):
    """A statement of the paper that is not computed."""

    @property
    def source(self) -> str:
        """Where it stands in the paper."""
        ...

    @property
    def statement(self) -> str:
        """What is stated."""
        ...

    @property
    def reason(self) -> str:
        """Why something is undecided, or not computed."""
        ...


class Judgements(Protocol):
    """What came of judging the claims."""

    @property
    def judgements(self) -> Sequence[Judgement]:
        """The judgements in reading order."""
        ...

    @property
    def unjudged(self) -> int:
        """The number of claims that an interruption left unjudged."""
        ...


class Audit(Protocol):
    """The audit of a paper: its claims judged, counted and put on a page."""

    #: Headings of the sections of the paper, by number.
    TITLES: Mapping[int, str]

    def audit(
        self,
        section: int | None = None,
        workers: int | None = None,
        progress: Callable[[float], None] = ...,
    ) -> Judgements:
        """The claims judged in several processes."""
        ...

    def page(self, judgements: Sequence[Judgement], section: int | None = None) -> str:
        """The judgements as an HTML page."""
        ...

    def counts(self, judgements: Iterable[Judgement]) -> dict[str, dict[Decision, int]]:
        """Numbers of decisions, as printed and as corrected."""
        ...

    def remarks_by_section(self, section: int | None = None) -> Mapping[int, Sequence[Remark]]:
        """Statements that are not computed, by section."""
        ...

    def judged_findings(self, remark: Remark) -> Sequence[tuple[Finding, Verdict]]:
        """Findings of a remark, each with its verdict."""
        ...


def installed_audit() -> Audit:
    """The audit that is installed; the first by name if there are several.

    Raises
    ------
    InputError
        If none is installed.
    """
    for entry in sorted(entry_points(group=GROUP), key=lambda entry: entry.name):
        return cast(Audit, entry.load())
    raise InputError(
        "no audit of a paper is installed: pip install borisov-mamaev-2008, or another "
        f"distribution with an entry point in {GROUP}"
    )
