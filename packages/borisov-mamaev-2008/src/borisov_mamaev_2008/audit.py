"""Audit of the paper: every claim is checked as printed, and as corrected.

Claims are checked in parallel processes.  Verdicts are stored, so an interrupted audit can be
resumed, and a second one takes seconds.
"""

from __future__ import annotations

import html
import os
import re
import time
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass, replace
from multiprocessing import get_context
from typing import Any

from flowlanes.arguments import arguments_checked
from flowlanes.child_processes import follow_parent, signals_blocked
from flowlanes.errors import InputError
from flowlanes.files.cache import entry_name
from flowlanes.files.source_digest import package_digest
from flowlanes.flow.ensembles.task import IncompleteError
from flowlanes.printing.mathml import mathml
from lawproof.proof.fields.budget import EFFORT
from lawproof.proof.prover import prove
from lawproof.proof.verdict import Decision, Verdict
from lawproof.proof.verdict_cache import load_verdict, store_verdict

from . import Case, Claim, Finding, Remark, claims, remarks
from ._version import __version__

THOROUGH = 4 * EFFORT
"""Term operations that the proof of one claim may take."""

#: Possible outcomes of a claim, in the order in which they are counted.
DECISIONS: tuple[Decision, ...] = ("proven", "proven where", "refuted", "undecided")


@dataclass(frozen=True)
class Judgement:
    """A claim with the verdicts on its printed and its corrected form.

    `corrected` is None if the printed form holds, or if no correct form is known.
    """

    section: int
    claim: Claim
    printed: Verdict
    corrected: Verdict | None
    seconds: float

    @property
    def conditions(self) -> tuple[str, ...]:
        """Conditions of what is proven, in the printed or the corrected form."""
        conditions = (v.conditions for v in (self.printed, self.corrected) if v is not None)
        return tuple(dict.fromkeys(text for texts in conditions for text in texts))

    @property
    def reason(self) -> str:
        """Why something is undecided; empty otherwise."""
        reasons = (v.reason for v in (self.printed, self.corrected) if v is not None)
        return "; ".join(dict.fromkeys(reason for reason in reasons if reason))

    def record(self) -> dict[str, Any]:
        """The judgement as data; formulas in LaTeX between dollar signs."""
        table: dict[str, Any] = {
            "source": self.claim.source,
            "statement": self.claim.statement,
            "printed": self.printed.decision,
        }
        if self.corrected is not None:
            table["corrected"] = self.claim.correction
            table["verdict"] = self.corrected.decision
        if self.claim.note:
            table["note"] = self.claim.note
        if self.claim.erratum:
            table["erratum"] = self.claim.erratum
        if self.claim.argument:
            table["argument"] = self.claim.argument
        if self.conditions:
            table["conditions"] = list(self.conditions)
        if self.reason:
            table["reason"] = self.reason
        table["seconds"] = round(self.seconds, 3)
        return table


def _joint_verdict(case: Case) -> Verdict:
    """The verdict on a case: all of its parts must hold, under all of their conditions."""
    if isinstance(case, Verdict):
        return case
    if isinstance(case[0], tuple):
        verdicts = [prove(system, law, effort=THOROUGH) for system, law in case]
    else:
        verdicts = [prove(case[0], case[1], effort=THOROUGH)]
    weakest = next(
        decision
        for decision in ("refuted", "undecided", "proven where", "proven")
        if any(v.decision == decision for v in verdicts)
    )
    chosen = next(v for v in verdicts if v.decision == weakest)
    conditions = tuple(dict.fromkeys(text for v in verdicts for text in v.conditions))
    return replace(
        chosen,
        conditions=conditions if weakest == "proven where" else (),
        terms=max(v.terms for v in verdicts),
        seconds=sum(v.seconds for v in verdicts),
    )


def _program() -> str:
    """The digest of the claims themselves; that of what computes is part of every name."""
    return package_digest("borisov_mamaev_2008")


def _stored_verdict(claim: Claim, form: str) -> Verdict | None:
    """The verdict on a form of a claim from an earlier audit, if there is one."""
    stored = load_verdict(_name(claim, form))
    return None if stored is None else claim.under_conditions(stored)


def _verdict_from_cache(name: str, decide: Callable[[], Case]) -> Verdict:
    """A verdict from an earlier audit, or a new one, which is stored."""
    stored = load_verdict(name)
    if stored is not None:
        return stored
    started = time.monotonic()
    verdict = replace(_joint_verdict(decide()), seconds=time.monotonic() - started)
    store_verdict(name, verdict)
    return verdict


def _verdict_on(claim: Claim, form: str, decide: Callable[[], Case]) -> Verdict:
    return claim.under_conditions(_verdict_from_cache(_name(claim, form), decide))


def judge(number: int, section: int | None) -> tuple[Verdict, Verdict | None]:
    """Judge the printed and the corrected form of one claim."""
    _, claim = claims(section)[number]
    printed = _verdict_on(claim, "printed", claim.printed)
    if claim.corrected is None:
        return printed, None
    return printed, _verdict_on(claim, "corrected", claim.corrected)


def _name(claim: Claim, form: str) -> str:
    return entry_name(claim.source, claim.statement, form, _program())


@dataclass(frozen=True)
class Audit:
    """The judgements of an audit.

    Attributes
    ----------
    judgements : tuple of Judgement
        In the order of the paper; after an interruption, those that were finished.
    unjudged : int
        Number of claims without a decision because of an interruption.

    Examples
    --------
    >>> import borisov_mamaev_2008
    >>> print(borisov_mamaev_2008.audit.audit(section=11, workers=1))
    16 claims judged
    """

    judgements: tuple[Judgement, ...]
    unjudged: int = 0

    def __str__(self) -> str:
        left = f", {self.unjudged} not judged" if self.unjudged else ""
        return f"{len(self.judgements)} claims judged{left}"


@arguments_checked
def audit(
    section: int | None = None,
    workers: int | None = None,
    progress: Callable[[float], None] = lambda _: None,
) -> Audit:
    """Judge the claims of one section, or of the whole paper.

    Several processes import the script that calls this, so that the call must stand there below
    ``if __name__ == "__main__":``; with ``workers=1`` there is no other process.

    Parameters
    ----------
    section : int, optional
        1 to 12; by default all of them.
    workers : int, optional
        Processes; by default one for each processor, but not more than claims.
    progress : callable
        Function that is called with the completed fraction.

    Returns
    -------
    Audit

    Raises
    ------
    InputError
        If the paper has no such section, or `workers` is less than one.
    IncompleteError
        If a process ended before it had an answer.

    Examples
    --------
    >>> import borisov_mamaev_2008.audit
    >>> audit = borisov_mamaev_2008.audit.audit(section=11, workers=1)
    >>> sorted({judgement.printed.decision for judgement in audit.judgements}), audit.unjudged
    (['proven', 'proven where', 'refuted'], 0)
    """
    if workers is not None and workers < 1:
        raise InputError(f"workers = {workers}: there must be one at least")
    chosen = claims(section)
    if not chosen:
        sections = sorted({number for number, _ in claims(None)})
        raise InputError(
            f"section {section}: the audit covers sections {sections[0]} to {sections[-1]}"
        )
    verdicts: dict[int, tuple[Verdict, Verdict | None]] = {}
    waiting = []
    for number, (_, claim) in enumerate(chosen):
        printed = _stored_verdict(claim, "printed")
        corrected = _stored_verdict(claim, "corrected") if claim.corrected else None
        if printed is None or (claim.corrected is not None and corrected is None):
            waiting.append(number)
        else:
            verdicts[number] = printed, corrected
    workers = min(workers or os.cpu_count() or 1, len(waiting))
    if workers > 1:
        left = _judge_in_processes(waiting, section, workers, verdicts, len(chosen), progress)
    else:
        left = _judge_in_turn(waiting, section, verdicts, len(chosen), progress)
    done = tuple(_judgement(*chosen[n], *verdicts[n]) for n in sorted(verdicts))
    return Audit(done, left)


def _judge_in_turn(
    waiting: Sequence[int],
    section: int | None,
    verdicts: dict[int, tuple[Verdict, Verdict | None]],
    total: int,
    progress: Callable[[float], None],
) -> int:
    """Fill `verdicts`; return the number left by an interruption."""
    try:
        for number in waiting:
            verdicts[number] = judge(number, section)
            progress(len(verdicts) / total)
    except KeyboardInterrupt:
        return total - len(verdicts)
    return 0


def _judge_in_processes(
    waiting: Sequence[int],
    section: int | None,
    workers: int,
    verdicts: dict[int, tuple[Verdict, Verdict | None]],
    total: int,
    progress: Callable[[float], None],
) -> int:
    """Fill `verdicts`; return the number left by an interruption."""
    context = get_context("spawn")
    pool = ProcessPoolExecutor(workers, mp_context=context, initializer=follow_parent)
    try:
        with signals_blocked():
            tasks: dict[Future[tuple[Verdict, Verdict | None]], int] = {
                pool.submit(judge, n, section): n for n in waiting
            }
        open_tasks = set(tasks)
        while open_tasks:
            ended, open_tasks = wait(open_tasks, timeout=0.5, return_when=FIRST_COMPLETED)
            verdicts.update((tasks[task], task.result()) for task in ended)
            progress(len(verdicts) / total)
    except KeyboardInterrupt:
        pool.shutdown(wait=False, cancel_futures=True)
        return total - len(verdicts)
    except BrokenProcessPool:
        raise IncompleteError(
            f"a process ended before it had an answer, as it does when memory runs out; "
            f"{total - len(verdicts)} claims are not judged. Verdicts are kept: run the same "
            "again, with fewer --workers"
        ) from None
    pool.shutdown()
    return 0


def _judgement(
    section: int, claim: Claim, printed: Verdict, corrected: Verdict | None
) -> Judgement:
    seconds = printed.seconds + (corrected.seconds if corrected is not None else 0.0)
    return Judgement(section, claim, printed, corrected, seconds)


def counts(judgements: Iterable[Judgement]) -> dict[str, dict[Decision, int]]:
    """The number of claims with each of `DECISIONS`, as printed and as corrected."""
    table: dict[str, dict[Decision, int]] = {
        form: dict.fromkeys(DECISIONS, 0) for form in ("printed", "corrected")
    }
    for judgement in judgements:
        table["printed"][judgement.printed.decision] += 1
        if judgement.corrected is not None:
            table["corrected"][judgement.corrected.decision] += 1
    return table


def judged_findings(remark: Remark) -> tuple[tuple[Finding, Verdict], ...]:
    """The decisions on an open question, with their verdicts, which are stored."""
    return tuple(
        (
            finding,
            _verdict_from_cache(
                entry_name(finding.key, finding.statement, _program()), finding.decide
            ),
        )
        for finding in remark.findings
    )


def remarks_by_section(section: int | None = None) -> dict[int, tuple[Remark, ...]]:
    """The statements that were not computed, of one section or of all."""
    numbers = TITLES if section is None else (section,)
    return {number: found for number in numbers if (found := remarks(number))}


# --- the page ------------------------------------------------------------------------------


def typeset(statement: str) -> str:
    """Words with LaTeX between dollar signs as HTML."""
    parts = re.split(r"\$\$(.+?)\$\$|\$(.+?)\$", statement, flags=re.S)
    pieces = []
    for i in range(0, len(parts), 3):
        words = html.escape(parts[i])
        pieces.append(re.sub(r"\*(.+?)\*", r"<em>\1</em>", words))
        if i + 2 < len(parts):
            display, inline = parts[i + 1], parts[i + 2]
            pieces.append(mathml(display, "block") if display else mathml(inline))
    return "".join(pieces)


def page(judgements: Sequence[Judgement], section: int | None = None) -> str:
    """The audit as one HTML page that needs no network, ordered as the paper."""
    import jinja2
    from markupsafe import Markup

    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("borisov_mamaev_2008"),
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["findings"] = judged_findings
    environment.filters["typeset"] = lambda text: Markup(typeset(text))
    sections: dict[int, list[Judgement]] = {}
    for judgement in judgements:
        sections.setdefault(judgement.section, []).append(judgement)
    return environment.get_template("audit.html").render(
        version=__version__,
        titles=TITLES,
        decisions=DECISIONS,
        sections=sections,
        notes=remarks_by_section(section),
        counts=counts(judgements),
        counts_by_section={n: counts(judged) for n, judged in sections.items()},
        total=len(judgements),
        seconds=sum(j.seconds for j in judgements),
    )


TITLES = {
    1: "Equations of motion of nonholonomic systems",
    2: "Nonholonomy of constraints and some isomorphisms",
    3: "Conservation laws in nonholonomic mechanics",
    4: "Integrability and reduction",
    5: "Heavy rubber body of revolution on a plane",
    6: "The Veselova system",
    7: "The Chaplygin ball",
    8: "The Chaplygin ball on a sphere",
    9: "Rubber ball on a sphere",
    10: "Dynamically non-symmetric, unbalanced ball on a plane",
    11: "Discussion",
    12: "Open problems",
}
"""Sections of the paper, with the headings they have there."""
