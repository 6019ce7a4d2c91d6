"""``chaplygin show``: the equations of motion."""

from __future__ import annotations

import sys
import textwrap
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from .terminal.options import NO_LAWS, print_json, study_of

if TYPE_CHECKING:
    from flowlanes.system.laws import Law
    from flowlanes.system.system import System

    from ..experiment.study import Study


def _print_schema(now: bool) -> None:
    """Print the schema and end, ignoring all other arguments."""
    if now:
        from ..experiment.models.schema import experiment_schema

        print_json(experiment_schema())
        raise typer.Exit


def command(
    what: str,
    overrides: list[str] | None = None,
    form: str = "text",
    laws: bool = False,
    json: bool = False,
    schema: Annotated[
        bool,
        typer.Option(
            "--schema",
            is_eager=True,
            callback=_print_schema,
            help="Print the JSON Schema of experiment files, for editors; needs no NAME|FILE.",
        ),
    ] = False,
) -> None:
    """Print equations, parameters, laws and source of a system, and its place in the hierarchy.

    The place in the hierarchy of dynamics says what is proven (integrals, an
    invariant measure, a Hamiltonian form), how integrable that makes the system,
    and which motions can occur.
    """
    from flowlanes.errors import InputError

    if json and form != "text":
        raise InputError(f"--as {form} and --json both print the system: choose one of them")
    if laws and (form != "text" or json):
        raise InputError("--laws prints a text: leave out --as and --json, which has all laws")
    if form == "wasm":
        _require_no_terminal(what)
    study = study_of(what, overrides)
    if form in ("javascript", "wasm"):
        _write_module(study, form)
        return
    from flowlanes.printing.code import source_code
    from flowlanes.printing.system import motion_text
    from nonholonomic.classification.classifier import classify_quickly

    from ..experiment.catalogue_text import catalogue_text

    system = study.system
    # Laws of a single mode do not place a motion through several modes in the hierarchy.
    place = (
        None
        if study.subject.changes_equations or not (json or form == "text") or laws
        else classify_quickly(system, study.subject.model)
    )
    if laws:
        from flowlanes.printing.system import laws_text

        typer.echo(system.title)
        for each in _systems_with_laws(study):
            if study.subject.changes_equations:
                typer.echo(f"\n{each.title}")
            typer.echo(f"\n{laws_text(each)}")
        known = f"chaplygin prove {what} proves them." if study.claims else NO_LAWS
        typer.echo(f"\n{known}")
        return
    if json:
        from flowlanes.printing.formula import latex
        from flowlanes.printing.laws import condition_text
        from flowlanes.printing.system import law_latex

        print_json(
            {
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
        )
        return
    texts: dict[str, Callable[[], str]] = {
        "text": lambda: str(system),
        "latex": system.latex,
        "julia": lambda: source_code(system, "julia"),
        "c": lambda: source_code(system, "c"),
        "toml": lambda: catalogue_text(study),
    }
    typer.echo(texts[form]().rstrip())
    if form == "text" and study.subject.has_own_reconstruction and (lines := motion_text(system)):
        typer.echo("\n".join(("\nReconstruction equations", *lines)))
    for words in filter(
        None, (study.subject.legend, *study.subject.derivation_notes) if form == "text" else ()
    ):
        typer.echo("\n" + textwrap.fill(words, 100))
    if form == "text" and place is not None:
        typer.echo(f"\n{place}")
        if any("effort" in entry.why for entry in place.ignored_laws):
            typer.echo(f"\nMore effort may decide the undecided laws: chaplygin prove {what}")


def _systems_with_laws(study: Study) -> list[System]:
    """Systems with provable laws, each with those laws."""
    laws: dict[System, list[Law]] = {}
    for system, law in study.claims:
        laws.setdefault(system, []).append(law)
    return [replace(system, laws=tuple(of_it)) for system, of_it in laws.items()]


def _require_no_terminal(what: str) -> None:
    """Raise an error instead of writing machine code to a terminal."""
    from flowlanes.errors import InputError

    if sys.stdout.isatty():
        raise InputError(
            "--as wasm: machine code cannot be shown as text; write it to a file, as with "
            f"chaplygin show {what} --as wasm > {Path(what).stem}.wasm"
        )


def _write_module(study: Study, form: str) -> None:
    """Write a module that computes motions to standard output: JavaScript, or its machine code."""
    if form == "javascript":
        from ..page.javascript import javascript_module

        typer.echo(javascript_module(study).rstrip())
        return
    from ..page.wasm_module import page_module

    sys.stdout.buffer.write(page_module(study).code)
    sys.stdout.flush()
