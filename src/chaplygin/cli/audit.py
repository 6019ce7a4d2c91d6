"""``chaplygin audit``: every claim of the paper, as printed and as corrected."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from .common import Force, Json, inform, print_json, progress

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from rich.console import RenderableType

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
    from itertools import groupby

    from rich.console import Console

    from ..study.audit import TITLES, counts

    console = Console(highlight=False)
    for section, found in groupby(judgements, key=lambda j: j.section):
        console.print(f"\n[bold]§{section} {TITLES[section]}[/]\n")
        for judgement in found:
            console.print(_claim(judgement))
    numbers = counts(judgements)
    console.print(f"\n{len(judgements)} claims")
    for form, label in (("printed", "as printed"), ("corrected", "corrected")):
        listed = ", ".join(f"{n} {decision}" for decision, n in numbers[form].items())
        console.print(f"{label}: {listed}")


def _claim(judgement: Judgement) -> RenderableType:
    """Where a claim stands, what came of it, and below that what there is to say."""
    from rich.console import Group
    from rich.markup import escape
    from rich.table import Table

    from ..plain import plain_words
    from .prove import styled

    head = Table.grid(padding=(0, 2), expand=True)
    head.add_column(ratio=1)
    head.add_column(justify="right", no_wrap=True)
    head.add_column(justify="right", no_wrap=True, min_width=8)
    verdicts = [v for v in (judgement.printed, judgement.corrected) if v is not None]
    shown = " → ".join(styled(verdict.decision) for verdict in verdicts)
    head.add_row(
        f"[bold]{escape(plain_words(judgement.claim.source))}[/]",
        shown,
        f"{judgement.seconds:.2f} s",
    )
    told = Table.grid(padding=(0, 2, 0, 0))
    told.add_column(no_wrap=True, style="dim", min_width=11)
    told.add_column()
    for label, words in _told(judgement):
        told.add_row(f"  {label}", escape(words))
    return Group(head, told) if told.rows else head


def _told(judgement: Judgement) -> Iterator[tuple[str, str]]:
    """What is said of a claim, each with its label: both forms where the printed one fails."""
    from ..plain import plain_words

    claim = judgement.claim
    if not judgement.printed:
        yield "printed", plain_words(claim.statement)
    if judgement.corrected is not None:
        yield "corrected", plain_words(claim.correction)
    if claim.note:
        yield "note", plain_words(claim.note)
    if judgement.conditions:
        yield "where", ", ".join(judgement.conditions)
    if judgement.reason:
        yield "undecided", judgement.reason
