"""What `prove` says of a law: its verdict in words and numbers, as JSON can hold them."""

from __future__ import annotations

from typing import Any, TypedDict

from flowlanes.printing.formula import latex, text
from flowlanes.printing.laws import condition_text
from flowlanes.printing.system import law_latex
from flowlanes.system.laws import Law
from flowlanes.system.system import System
from lawproof.proof.verdict import Verdict

from ..experiment.study import Study


class LawVerdict(TypedDict):
    """A law with its verdict.

    The table of `prove` has the title of the system, the level of the law as text, the sentence of
    the verdict, and the decision on the form that the paper prints (none if it prints this one);
    ``--json`` has the record alone.
    """

    title: str
    level: str
    sentence: str
    printed: str | None
    record: dict[str, Any]


def claims_of(study: Study, what: str) -> list[tuple[System, Law]]:
    """The laws of a system, and of its general form if the catalogue has one."""
    from nonholonomic.catalogue import CATALOGUE

    claims = list(study.claims)
    general = CATALOGUE[what].general if what in CATALOGUE else None
    if general is not None:
        wide = general()
        claims += [(wide, law) for law in wide.laws]
    return claims


def law_report_record(
    system: System, law: Law, verdict: Verdict, printed: Verdict | None
) -> LawVerdict:
    """Record of a law with its verdict, and the verdict on its printed form if that differs."""
    record = {
        "source": law.source,
        "statement": _law_description(law),
        "printed": (verdict if printed is None else printed).decision,
        "corrected": law_latex(law, system),
        "verdict": verdict.decision,
        "conditions": list(verdict.conditions),
        "note": law.misprint,
        "seconds": round(verdict.seconds, 3),
        "effort": verdict.effort,
        "system": system.name,
        "law": law.name,
        "level": condition_text(law, system, latex),
        "shown": verdict.finding,
        "reason": verdict.reason,
        "terms": verdict.terms,
    }
    if verdict.witness is not None:
        record["witness"] = verdict.witness
    return {
        "title": system.title,
        "level": condition_text(law, system, text),
        "sentence": verdict.statement,
        "printed": None if printed is None else printed.decision,
        "record": record,
    }


def _law_description(law: Law) -> str:
    """Kind and meaning of a law, without saying the same twice."""
    kind, meaning = law.heading, str(getattr(law, "meaning", ""))
    if kind.lower() in meaning.lower():
        return meaning[0].upper() + meaning[1:]
    return f"{kind}: {meaning}" if meaning else kind
