"""What `show` says of a system: its equations, parameters, laws and place in the hierarchy."""

from __future__ import annotations

import textwrap
from collections.abc import Callable
from dataclasses import replace
from typing import Any

from flowlanes.printing.formula import latex
from flowlanes.printing.laws import condition_text
from flowlanes.printing.system import law_latex, laws_text, motion_text
from flowlanes.system.laws import Law
from flowlanes.system.system import System
from nonholonomic.classification.classification import Classification
from nonholonomic.classification.classifier import classify_quickly

from ..experiment.study import Study

NO_LAWS = "No laws of it are known."


def text_of(study: Study, what: str) -> str:
    """Equations, parameters, laws and source, and the place in the hierarchy, as text."""
    system = study.system
    parts = [str(system).rstrip()]
    if study.subject.has_own_reconstruction and (lines := motion_text(system)):
        parts.append("\n".join(("\nReconstruction equations", *lines)))
    parts += [
        "\n" + textwrap.fill(words, 100)
        for words in (study.subject.legend, *study.subject.derivation_notes)
        if words
    ]
    place = _place(study)
    if place is not None:
        parts.append(f"\n{place}")
        if any("effort" in entry.why for entry in place.ignored_laws):
            parts.append(f"\nMore effort may decide the undecided laws: chaplygin prove {what}")
    return "\n".join(parts)


def laws_of(study: Study, what: str) -> str:
    """The laws alone, as text; of a motion through several modes those of each mode."""
    parts = [study.system.title]
    for system in _systems_with_laws(study):
        if study.subject.changes_equations:
            parts.append(f"\n{system.title}")
        parts.append(f"\n{laws_text(system)}")
    parts.append(f"\nchaplygin prove {what} proves them." if study.claims else f"\n{NO_LAWS}")
    return "\n".join(parts)


def record_of(study: Study, what: str) -> dict[str, Any]:
    """All of it for programs, with formulas in LaTeX."""
    system, place = study.system, _place(study)
    return {
        "name": system.name,
        "title": system.title,
        "summary": system.summary,
        "source": system.source,
        "state": [str(s) for s in system.symbols],
        "parameters": [
            {
                "symbol": str(p.symbol),
                "meaning": p.meaning,
                "default": p.default,
                "unit": p.unit,
            }
            for p in system.parameters
        ],
        "equations": system.latex(),
        "laws": [
            {
                "kind": type(law).__name__,
                "heading": law.heading,
                "name": getattr(law, "name", ""),
                "meaning": getattr(law, "meaning", ""),
                "value": law_latex(law, system),
                "level": condition_text(law, system, latex),
                "source": law.source,
                "misprint": law.misprint,
            }
            for law in system.laws
        ],
        "notes": list(study.subject.derivation_notes),
        "place": None if place is None else place.record,
    }


SHEETS: dict[str, Callable[[Study, str], Any]] = {
    "show text": text_of,
    "show laws": laws_of,
    "show json": record_of,
}
"""The forms by the command that asks for them: a study and its name or file ↦ the answer."""


def _place(study: Study) -> Classification | None:
    # Laws of a single mode do not place a motion through several in the hierarchy.
    if study.subject.changes_equations:
        return None
    return classify_quickly(study.system, study.subject.model)


def _systems_with_laws(study: Study) -> list[System]:
    """The systems with provable laws, each with those laws."""
    laws: dict[System, list[Law]] = {}
    for system, law in study.claims:
        laws.setdefault(system, []).append(law)
    return [replace(system, laws=tuple(of_it)) for system, of_it in laws.items()]
