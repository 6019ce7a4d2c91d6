"""``chaplygin show``: the equations of motion."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from .terminal.options import inform_remarks, is_name, print_json, study_of

if TYPE_CHECKING:
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
    again: bool = False,
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
    if form == "text":
        answer = _answer(what, overrides, "json" if json else "laws" if laws else "text", again)
        if json:
            print_json(answer)
        else:
            typer.echo(answer)
        return
    study = study_of(what, overrides)
    if form in ("javascript", "wasm"):
        _write_module(study, form)
        return
    from flowlanes.printing.code import source_code

    from ..experiment.catalogue_text import catalogue_text

    texts: dict[str, Callable[[], str]] = {
        "latex": study.system.latex,
        "julia": lambda: source_code(study.system, "julia"),
        "c": lambda: source_code(study.system, "c"),
        "toml": lambda: catalogue_text(study),
    }
    typer.echo(texts[form]().rstrip())


def _answer(what: str, overrides: list[str] | None, form: str, again: bool) -> Any:
    """The sheet of a system in a form, stored or computed; remarks on the input are printed."""
    from ..answers.stored import Answer, Question, keep, stored

    question = Question(f"show {form}", what, is_name(what), tuple(overrides or ()))
    answer = None if again else stored(question)
    if answer is not None:
        inform_remarks(answer.remarks)
        return answer.content
    study = study_of(what, overrides)
    from ..answers.sheet import SHEETS

    content = SHEETS[question.command](study, what)
    keep(question, Answer(study.remarks, content))
    return content


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
