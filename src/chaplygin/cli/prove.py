"""``chaplygin prove``: the laws of a system, each with its verdict."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from .common import (
    Effort,
    Force,
    Json,
    Override,
    What,
    inform,
    operations,
    print_json,
    progress,
    study_of,
)

if TYPE_CHECKING:
    from ..laws.verdict import Verdict
    from ..statements import Law
    from ..system import System

__all__ = ["command", "styled"]

COLOURS = {"proven": "green", "proven where": "cyan", "refuted": "red", "undecided": "yellow"}


def command(
    what: What,
    overrides: Override = None,
    only: Annotated[
        list[str] | None, typer.Option("--law", metavar="LAW", help="Only this law, by its name.")
    ] = None,
    effort: Effort = 1.0,
    certificate: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Write certificates (JSON) that a program can check."),
    ] = None,
    force: Force = False,
    json: Json = False,
) -> None:
    """Prove or refute the laws of a system; exit 1 unless all are proven without conditions.

    A law that is proven where some condition holds, undecided or refuted makes the exit status 1.
    """
    from ..study.files import check_target

    allowed = operations(effort)
    if certificate is not None:
        check_target(certificate, force)
    claims = _chosen(_claims(what, overrides), only or [], what)
    done: list[tuple[System, Law, Verdict]] = []
    interrupted = False
    try:
        with progress("Proving") as report:
            for count, (system, law) in enumerate(claims):
                report(count / len(claims))
                done.append((system, law, _verdict(system, law, allowed, certificate)))
    except KeyboardInterrupt:
        interrupted = True
    if json:
        print_json([_record(*row, allowed) for row in done])
    else:
        _print(done, allowed)
    if certificate is not None:
        _write(certificate, [verdict for _, _, verdict in done])
    if interrupted:
        inform(f"interrupted: {len(claims) - len(done)} of {len(claims)} laws were not tried")
    if interrupted or not all(verdict for _, _, verdict in done):
        raise typer.Exit(1)


def _claims(what: str, overrides: list[str] | None) -> list[tuple[System, Law]]:
    """The laws of the system, and those of its general form where the catalogue has one."""
    from ..systems import CATALOGUE

    system = study_of(what, overrides).system
    found = [(system, law) for law in system.laws]
    general = CATALOGUE[what].general if what in CATALOGUE else None
    if general is not None:
        wide = general()
        found += [(wide, law) for law in wide.laws]
    return found


def _chosen(
    claims: list[tuple[System, Law]], only: list[str], what: str
) -> list[tuple[System, Law]]:
    from ..errors import InputError

    names = [law.name for _, law in claims]
    for name in only:
        if name not in names:
            listed = ", ".join(dict.fromkeys(names)) or "none"
            raise InputError(f"no law {name!r} of {what}; its laws are {listed}")
    return [pair for pair in claims if not only or pair[1].name in only]


def _verdict(system: System, law: Law, effort: int, certificate: Path | None) -> Verdict:
    from ..laws.certificate import certified
    from ..laws.prove import prove

    if certificate is None:
        return prove(system, law, effort=effort)
    return certified(system, law, effort)


def _record(system: System, law: Law, verdict: Verdict, effort: int) -> dict[str, Any]:
    from ..claims import level
    from ..laws.prove import prove
    from ..typeset import latex, law_latex

    printed = law.as_printed
    record = {
        "source": law.source,
        "statement": _words(law),
        "printed": verdict.decision
        if printed is None
        else prove(system, printed, effort=effort).decision,
        "corrected": law_latex(law, system),
        "verdict": verdict.decision,
        "conditions": list(verdict.conditions),
        "note": law.misprint,
        "seconds": round(verdict.seconds, 3),
        "effort": verdict.effort,
        "system": system.name,
        "law": law.name,
        "level": level(law, system, latex),
        "shown": verdict.shown,
        "reason": verdict.reason,
        "terms": verdict.terms,
    }
    if verdict.witness is not None:
        record["witness"] = verdict.witness
    return record


def _words(law: Law) -> str:
    """Kind and meaning of a law, without saying the same twice."""
    from ..claims import heading

    kind, meaning = heading(law), str(getattr(law, "meaning", ""))
    if kind.lower() in meaning.lower():
        return meaning[0].upper() + meaning[1:]
    return f"{kind}: {meaning}" if meaning else kind


def styled(decision: str) -> str:
    """A verdict in its colour, for the terminal."""
    return f"[{COLOURS[decision]}]{decision}[/]"


def _print(done: list[tuple[System, Law, Verdict]], effort: int) -> None:
    from rich import box
    from rich.console import Console
    from rich.markup import escape
    from rich.table import Table

    from ..claims import level
    from ..laws.prove import prove
    from ..typeset import text

    console = Console()
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, show_edge=False)
    table.add_column("Law", style="bold", no_wrap=True)
    table.add_column("What it states")
    table.add_column("Source", style="dim")
    table.add_column("Verdict", no_wrap=True)
    table.add_column("Terms", justify="right")
    table.add_column("Time", justify="right", no_wrap=True)
    previous = None
    for system, law, verdict in done:
        if previous is not None and system.title != previous:
            table.add_section()
            table.add_row("", f"[italic]{escape(system.title)}[/]")
        previous = system.title
        where = level(law, system, text)
        table.add_row(
            escape(law.name),
            escape(f"{_words(law)} {where}".strip()),
            escape(law.source),
            styled(verdict.decision),
            f"{verdict.terms:,}" if verdict.terms else "",
            f"{verdict.seconds:.2f} s",
        )
        if law.as_printed is not None:
            wrong = prove(system, law.as_printed, effort=effort)
            table.add_row("", escape(f"as printed: {law.misprint}"), "", styled(wrong.decision))
    console.print(table)
    if len(done) > 1:
        console.print(f"\n{_counted([verdict for _, _, verdict in done])}")
    for _, law, verdict in done:
        if verdict.witness is not None:
            point = ", ".join(f"{n} = {v}" for n, v in verdict.witness["point"].items())
            console.print(
                f"\n{law.name}: {verdict.witness['what']} = {verdict.witness['residual']} at "
                f"{point}",
                markup=False,
            )
        elif verdict.conditions:
            console.print(f"\n{law.name}: {verdict.stated}", markup=False)
        elif verdict.reason:
            console.print(f"\n{law.name}: {verdict.reason}", markup=False)


def _counted(verdicts: list[Verdict]) -> str:
    """How many laws there are of each verdict."""
    decisions = [verdict.decision for verdict in verdicts]
    found = (f"{decisions.count(d)} {d}" for d in COLOURS if d in decisions)
    return f"{len(verdicts)} laws: {', '.join(found).replace('where', 'where a condition holds')}"


def _write(path: Path, verdicts: list[Verdict]) -> None:
    import json

    from ..study.files import completed

    made = [verdict.certificate for verdict in verdicts if verdict.certificate is not None]
    with completed(path) as place:
        place.write_text(json.dumps(made, ensure_ascii=False))
    inform(f"certificates of {len(made)} of {len(verdicts)} laws: {path}")
    for verdict in verdicts:
        if verdict.certificate is None:
            why = verdict.uncertified or "it is undecided"
            inform(f"no certificate of {verdict.law}: {why}")
