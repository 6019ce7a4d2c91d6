"""``chaplygin find``: search for laws from the equations alone."""

from __future__ import annotations

import textwrap
import time
from typing import TYPE_CHECKING, Any

import typer

from ..interruption import EXIT_CODE, print_interruption, results_on_interrupt
from .terminal.options import inform, operations, print_json, study_of
from .terminal.progress import progress

if TYPE_CHECKING:
    from collections.abc import Iterable

    import sympy as sp

    from flowlanes.system.system import Parameter, System
    from lawproof.search import SearchResult, SearchSpace
    from nonholonomic.invariant_measures.equilibria import EquilibriumObstruction
    from nonholonomic.invariant_measures.result import MeasureExistence

    from ..experiment.study import Study

_TITLES = {
    "integrals": "First integrals",
    "measure": "Invariant measures",
    "symmetries": "Symmetry fields",
}
#: Texts for no result, and for results that were found.
_NOTHING = "none of this form"
_NOTHING_ELSE = {
    "integrals": "Everything else of this form is a function of these and of the parameters.",
    "symmetries": "Everything else of this form follows from these, the flow and the integrals.",
}


def command(
    kind: str,
    what: str,
    overrides: list[str] | None = None,
    degree: int = 2,
    gamma_degree: int = 2,
    momenta: str = "",
    coordinates: str = "",
    at: list[str] | None = None,
    on: list[str] | None = None,
    divisors: list[str] | None = None,
    bases: list[str] | None = None,
    power: int = 1,
    parameter_degree: int = 3,
    effort: float = 1.0,
    json: bool = False,
) -> None:
    """Search for first integrals, invariant measures or symmetries, and prove those found."""
    allowed = operations(effort)
    study = study_of(what, overrides)
    from lawproof.search import search_space

    from ..experiment.single_system import single_system

    system = single_system(study)
    began = time.monotonic()
    conditions = special(system) if at is None else tuple(c for c in at if c.strip() != "none")
    question = search_space(
        system,
        degree=degree,
        gamma_degree=gamma_degree,
        momenta=momenta,
        coordinates=coordinates,
        at=conditions,
        level=on or (),
        divisors=None if divisors is None else [d for d in divisors if d.strip() != "1"],
        bases=bases,
        powers=power,
        parameter_degree=parameter_degree,
        effort=allowed,
    )
    with results_on_interrupt("the results found so far are about to be printed"):
        results, complete = _results(kind, question)
        asked = kind == "measure" and complete
        decision = _existence(study) if asked else None
        excluded = _obstruction(system) if asked and not results and decision is None else None
        elapsed = time.monotonic() - began
        if json:
            print_json(
                _as_json(kind, question, results, complete, elapsed)
                | {"at": list(conditions)}
                | ({} if decision is None else {"existence": _existence_json(decision)})
                | ({} if excluded is None else {"excluded": str(excluded)})
            )
        else:
            if at is None and conditions:
                inform(
                    f"searched where {', '.join(conditions)}, as the parameters are; --at none "
                    "searches for arbitrary parameters"
                )
            typer.echo(_as_text(kind, question, results, complete))
            if decision is not None:
                lines = str(decision).splitlines()
                typer.echo("\n" + "\n".join(_paragraph(line) for line in lines))
            if excluded is not None:
                typer.echo("\n" + _paragraph(str(excluded)))
    if not complete:
        raise typer.Exit(EXIT_CODE)
    raise typer.Exit(0 if results or decision else 1)


def special(system: System) -> tuple[str, ...]:
    """Special values of the parameters: equal moments or semi-axes, and zeros."""
    values = {p: p.default for p in system.parameters}
    factors = []
    for words in ("moment of inertia", "semi-axis"):
        first: dict[float, Parameter] = {}
        for parameter in (p for p in values if p.meaning.startswith(words) and values[p]):
            earlier = first.setdefault(values[parameter], parameter)
            if earlier is not parameter:
                factors.append(f"{earlier.symbol} = {parameter.symbol}")
    return (*factors, *(f"{p.symbol} = 0" for p in values if values[p] == 0))


def _results(kind: str, question: SearchSpace) -> tuple[list[SearchResult], bool]:
    """The results, and whether the search was completed."""
    from lawproof.search import SEARCHES

    results: list[SearchResult] = []
    try:
        with progress(f"searching for {kind}") as report:

            def update(fraction: float, words: str) -> None:
                report.say(f"searching for {kind}: {words}" if words else f"searching for {kind}")
                report(fraction)

            results.extend(SEARCHES[kind](question, update))
    except KeyboardInterrupt:
        print_interruption("the results found up to then follow")
        return results, False
    return results, True


def _existence(study: Study) -> MeasureExistence | None:
    """Result on a density on the configuration space, if the mechanical model is known."""
    from flowlanes.errors import InputError
    from flowlanes.formulas.errors import OutOfReachError
    from nonholonomic.invariant_measures.existence import invariant_measure

    model = study.subject.model
    if model is None:
        return None
    try:
        with progress("deciding whether a density on the configuration exists"):
            return invariant_measure(model, study.system.title)
    except (InputError, OutOfReachError, ZeroDivisionError):
        # Constraints of another kind, or numbers for which the derivation fails.
        return None


def _obstruction(system: System) -> EquilibriumObstruction | None:
    """Equilibrium that excludes a measure, if only the equations are known."""
    from nonholonomic.invariant_measures.equilibria import equilibrium_obstruction

    return equilibrium_obstruction(system)


def _paragraph(line: str) -> str:
    return textwrap.fill(line, 100, initial_indent="  ", subsequent_indent="      ")


def _existence_json(decision: MeasureExistence) -> dict[str, object]:
    return {"decision": decision.decision, "statement": str(decision)}


def _names(symbols: Iterable[object]) -> list[str]:
    from flowlanes.printing.formula import text

    return [text(s) for s in symbols]


def _equation(vanishing: sp.Expr) -> str:
    """A vanishing formula as an equation without minus signs, with its number on the right."""
    from sympy import Add

    from flowlanes.printing.formula import text

    number, remainder = vanishing.as_coeff_Add()
    terms = remainder.as_ordered_terms()
    negative = [term for term in terms if term.could_extract_minus_sign()]
    left = Add(*(term for term in terms if term not in negative))
    return f"{text(left)} = {text(Add(-number, *(-term for term in negative)))}"


def _setting(question: SearchSpace) -> str:
    ansatz = question.ansatz
    lines = [
        f"of degree ≤ {ansatz.degree} in "
        + " or ".join(", ".join(_names(a.momenta)) for a in (ansatz, *question.also))
        + (
            f" and ≤ {ansatz.gamma_degree} in {', '.join(_names(ansatz.coordinates))}"
            if ansatz.coordinates
            else ""
        )
    ]
    if question.stage.on:
        lines.append("where " + ", ".join(_equation(f) for f in question.stage.on))
    return "\n    ".join(lines)


def _result_lines(finding: SearchResult) -> list[str]:
    from flowlanes.printing.formula import text
    from flowlanes.system.vectors import real_symbol

    law, verdict = finding.law, finding.verdict
    if law is None or verdict is None:
        return [f"  only observed, modulo a prime: {finding.remark}"]
    status = (
        verdict.statement
        if verdict.decision in ("proven", "proven where")
        else f"only observed, {verdict.words}"
    )
    known = f"; repeats {finding.catalogue_law}" if finding.catalogue_law else ""
    label = "ρ" if finding.kind == "measure" else text(real_symbol(law.name))
    if finding.kind == "symmetry":
        formula = ",  ".join(f"{text(name)} ↦ {text(value)}" for name, value in finding.formula)
    else:
        formula = text(finding.formula)
    return [f"  {label} = {formula}", f"      {status}{known}"]


def _factors(kind: str, question: SearchSpace) -> tuple[Any, ...]:
    """Divisors of integrals, or factors of densities, that are tried."""
    return {"integrals": question.divisors, "measure": question.bases}.get(kind, ())


def _as_text(kind: str, question: SearchSpace, results: list[SearchResult], complete: bool) -> str:
    from flowlanes.printing.formula import text

    lines = [f"{_TITLES[kind]} of {question.stage.system.title}"]
    if kind != "measure":
        lines.append(f"    {_setting(question)}")
    factors = _factors(kind, question)
    if factors:
        words = "possibly divided by" if kind == "integrals" else "products of powers of"
        lines.append(f"    {words} {', '.join(text(f) for f in factors)}")
    lines.append("")
    for finding in results:
        lines += _result_lines(finding)
    if not complete:
        lines.append("  interrupted: the search is incomplete")
    elif not results:
        lines.append(f"  {_NOTHING}")
    elif kind != "measure" and all(finding.law is not None for finding in results):
        lines.append(f"  {_NOTHING_ELSE[kind]}")
    return "\n".join(lines)


def _as_json(
    kind: str, question: SearchSpace, results: list[SearchResult], complete: bool, seconds: float
) -> dict[str, object]:
    from flowlanes.printing.formula import latex, text

    ansatz = question.ansatz
    return {
        "system": question.stage.system.name,
        "kind": kind,
        "momenta": [str(s) for s in ansatz.momenta],
        "coordinates": [str(s) for s in ansatz.coordinates],
        "degree": ansatz.degree,
        "gamma_degree": ansatz.gamma_degree,
        "factors": [text(f) for f in _factors(kind, question)],
        "on": [_equation(f) for f in question.stage.on],
        "complete": complete,
        "seconds": round(seconds, 3),
        "found": [_finding_json(finding, text, latex) for finding in results],
    }


def _finding_json(finding: SearchResult, text: Any, latex: Any) -> dict[str, object]:
    law, verdict = finding.law, finding.verdict
    if law is None or verdict is None:
        return {"formula": None, "verdict": "observed", "remark": finding.remark}
    pairs = finding.formula if finding.kind == "symmetry" else (("", finding.formula),)
    shown = {str(name): (text(value), latex(value)) for name, value in pairs}
    return {
        "name": law.name,
        "formula": {n: t for n, (t, _) in shown.items()} if len(shown) > 1 else shown[""][0],
        "latex": {n: v for n, (_, v) in shown.items()} if len(shown) > 1 else shown[""][1],
        "verdict": verdict.decision,
        "conditions": list(verdict.conditions),
        "reason": verdict.reason,
        "repeats": finding.catalogue_law,
        "seconds": round(verdict.seconds, 3),
    }
