"""Laws found from the equations alone, sent one by one."""

from __future__ import annotations

from collections.abc import Iterator

from flowlanes.printing.formula import latex, text
from flowlanes.printing.mathml import mathml
from flowlanes.system.vectors import real_symbol
from lawproof.search import SEARCHES, SearchResult, search_space

from ..experiment.single_system import single_system
from ..experiment.study import Study
from .requests import Search
from .workers import Message


def search_messages(study: Study, request: Search) -> Iterator[Message]:
    """Messages on the progress of a search, and a message for each law found.

    Parameters
    ----------
    study : Study
    request : Search

    Raises
    ------
    InputError
        If the system cannot be searched.
    """
    question = search_space(
        single_system(study), degree=request.degree, gamma_degree=request.gamma_degree
    )
    said: list[Message] = []

    def update(fraction: float, words: str) -> None:
        said.append({"doing": f"searching: {words}" if words else "searching"})

    for result in SEARCHES[request.kind](question, update):
        yield from said[-1:]
        said.clear()
        yield {"found": _law(result)}


def _law(result: SearchResult) -> Message:
    law, verdict = result.law, result.verdict
    if law is None or verdict is None:
        return {"name": "", "mathml": "", "text": "", "stated": f"only observed: {result.remark}"}
    if result.kind == "symmetry":
        shown = ",  ".join(f"{text(name)} ↦ {text(value)}" for name, value in result.formula)
        formula = ""
    else:
        name = "ρ" if result.kind == "measure" else text(real_symbol(law.name))
        shown = f"{name} = {text(result.formula)}"
        formula = mathml(latex(result.formula))
    return {
        "name": law.name,
        "mathml": formula,
        "text": shown,
        "stated": verdict.statement,
        "repeats": result.catalogue_law or "",
    }
