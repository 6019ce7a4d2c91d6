"""``chaplygin audit``: every claim of the paper, as printed and as corrected."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from .common import Force, Json, inform, print_json, progress

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ..study.audit import Judgement

__all__ = ["command"]


def command(
    section: Annotated[
        int | None, typer.Option(help="Only this section of the paper, 1 to 12.")
    ] = None,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="FILE", help="Write a page (HTML).")
    ] = None,
    workers: Annotated[
        int | None, typer.Option(help="Processes; by default one for each processor.")
    ] = None,
    force: Force = False,
    json: Json = False,
) -> None:
    """Judge every claim of the paper; exit 1 when a corrected statement is refuted."""
    from ..errors import InputError
    from ..study.audit import TITLES, audit, page
    from ..study.files import check_target, completed

    if section is not None and section not in TITLES:
        raise InputError(
            f"--section {section}: the audit covers sections {min(TITLES)} to {max(TITLES)}"
        )
    if workers is not None and workers < 1:
        raise InputError(f"--workers {workers}: at least one process is needed")
    if output is not None:
        check_target(output, force)
    with progress("Auditing") as report:
        judgements, left = audit(section, workers, report)
    if json:
        print_json([judgement.record() for judgement in judgements])
    else:
        _print(judgements)
    if output is not None:
        with completed(output) as place:
            place.write_text(page(judgements, section))
        inform(f"page: {output}")
    if left:
        inform(f"interrupted: {left} claims were not judged; what is done is kept")
        raise typer.Exit(1)
    if any(j.corrected is not None and j.corrected.decision == "refuted" for j in judgements):
        raise typer.Exit(1)


def _print(judgements: Sequence[Judgement]) -> None:
    from rich import box
    from rich.console import Console
    from rich.markup import escape
    from rich.table import Table

    from ..study.audit import counts
    from .prove import styled

    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, show_edge=False)
    table.add_column("Where", style="bold")
    table.add_column("As printed", no_wrap=True)
    table.add_column("Corrected", no_wrap=True)
    table.add_column("Note")
    table.add_column("Time", justify="right", no_wrap=True)
    for judgement in judgements:
        corrected = judgement.corrected
        table.add_row(
            escape(judgement.claim.source),
            styled(judgement.printed.decision),
            styled(corrected.decision) if corrected is not None else "",
            escape(_plain(judgement.claim.note or judgement.printed.reason)),
            f"{judgement.seconds:.2f} s",
        )
    console = Console()
    console.print(table)
    numbers = counts(judgements)
    console.print(f"\n{len(judgements)} claims")
    for form, label in (("printed", "as printed"), ("corrected", "corrected")):
        found = ", ".join(f"{n} {decision}" for decision, n in numbers[form].items())
        console.print(f"{label}: {found}")


def _plain(note: str) -> str:
    """A note without the signs of formulas."""
    return note.replace("$", "").replace("\\", "")
