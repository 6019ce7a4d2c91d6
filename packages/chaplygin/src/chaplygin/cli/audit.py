"""``chaplygin audit``: every claim of the paper, as printed and as corrected."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from ..interruption import EXIT_CODE, print_interruption, results_on_interrupt
from .terminal.options import console, inform, print_json
from .terminal.output_destination import STANDARD_OUTPUT, beside, check_output, name_of, output_file
from .terminal.progress import progress, waiting
from .terminal.stores import require_processes

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

    from rich.console import RenderableType

    from ..audits import Audit, Judgement, Remark

#: Citation of the paper.
SECTIONS = range(1, 13)


def command(
    section: int | None = None,
    output: Path | None = None,
    workers: int | None = None,
    remarks_alone: bool = False,
    force: bool = False,
    json: bool = False,
) -> None:
    """Check every claim of Borisov and Mamaev (2008); exit 1 if a corrected one is refuted."""
    from flowlanes.errors import InputError

    if remarks_alone and (output is not None or workers is not None):
        raise InputError("--remarks checks no claims: leave out --output and --workers")
    if workers is not None:
        require_processes(workers)
    if output is not None:
        check_output("--output", output, force, json, binary=False)
        if output.suffix != ".html" and output != STANDARD_OUTPUT:
            raise InputError(f"--output {output}: its name must end in .html")
    if section is not None and section not in SECTIONS:
        raise InputError(
            f"--section {section}: the audit covers sections {SECTIONS[0]} to {SECTIONS[-1]}"
        )
    with waiting("reading the claims of the paper"):
        from ..audits import installed_audit

        audit = installed_audit()
        remarks = audit.remarks_by_section(section)
    if remarks_alone:
        if json:
            print_json({"remarks": _remark_records(audit, remarks)})
        else:
            _print_remarks(audit, remarks)
        return

    with results_on_interrupt("the verdicts reached so far are about to be printed"):
        with progress("checking the claims of the paper") as report:
            done = audit.audit(section, workers, report)
        judgements, left = done.judgements, done.unjudged
        with beside(output):
            if json:
                records = [judgement.record() for judgement in judgements]
                print_json({"claims": records, "remarks": _remark_records(audit, remarks)})
            else:
                _print(audit, judgements)
                _print_number_of_remarks(remarks, section)
        # A page with some of the claims would block the command that resumes.
        if output is not None and not left:
            with output_file(output) as place:
                place.write_text(audit.page(judgements, section), encoding="utf-8")
            inform(f"page: {name_of(output)}")
    if left:
        page_too = "" if output is None else " and no page was written"
        print_interruption(
            f"{left} claims were not checked{page_too}; verdicts are saved, and the same command "
            "resumes"
        )
        raise typer.Exit(EXIT_CODE)
    if any(j.corrected is not None and j.corrected.decision == "refuted" for j in judgements):
        raise typer.Exit(1)


def _print(audit: Audit, judgements: Sequence[Judgement]) -> None:
    from itertools import groupby

    shown = console()
    for section, section_judgements in groupby(judgements, key=lambda j: j.section):
        shown.print(f"\n[bold]§{section} {audit.TITLES[section]}[/]\n")
        for judgement in section_judgements:
            shown.print(_claim_block(judgement, shown.is_terminal))
    numbers = audit.counts(judgements)
    shown.print(f"\n{len(judgements)} claims")
    for form, label in (("printed", "as printed"), ("corrected", "corrected")):
        listed = ", ".join(f"{n} {decision}" for decision, n in numbers[form].items())
        shown.print(f"{label}: {listed}")


def _print_number_of_remarks(remarks: Mapping[int, Sequence[Remark]], section: int | None) -> None:
    """Print the number of remarks that are not computed, and how to see them."""
    number = sum(len(found) for found in remarks.values())
    chosen = "" if section is None else f" --section {section}"
    if number:
        console().print(
            f"{number} further statements, of literature or opinion, were not computed: "
            f"chaplygin audit{chosen} --remarks"
        )


def _print_remarks(audit: Audit, remarks: Mapping[int, Sequence[Remark]]) -> None:
    from rich.markup import escape
    from rich.padding import Padding

    from flowlanes.printing.plain_text import plain_words

    from .prove import coloured_decision

    shown = console()
    for section, found in remarks.items():
        shown.print(f"\n[bold]§{section} {audit.TITLES[section]}[/]")
        for remark in found:
            words = [plain_words(text) for text in (remark.statement, remark.reason)]
            shown.print(f"\n[bold]{escape(plain_words(remark.source))}[/]")
            shown.print(Padding(escape(words[0]), (0, 0, 0, 2), expand=False))
            shown.print(Padding(f"[dim]{escape(words[1])}[/]", (0, 0, 0, 2), expand=False))
            for finding, verdict in audit.judged_findings(remark):
                text = f"{coloured_decision(verdict.decision)} here: {escape(finding.statement)}"
                place = f" (borisov-mamaev-2008/docs/open-problems.md, {finding.key})"
                shown.print(Padding(text + place, (0, 0, 0, 2), expand=False))


def _remark_records(audit: Audit, remarks: Mapping[int, Sequence[Remark]]) -> list[dict[str, Any]]:
    """Remarks as data, with the decisions on open questions."""
    return [
        {
            "section": section,
            "source": remark.source,
            "statement": remark.statement,
            "reason": remark.reason,
            "findings": [
                {"row": finding.key, "statement": finding.statement, "verdict": verdict.statement}
                for finding, verdict in audit.judged_findings(remark)
            ],
        }
        for section, found in remarks.items()
        for remark in found
    ]


def _claim_block(judgement: Judgement, wide: bool) -> RenderableType:
    """Location of a claim, its verdicts, and the remarks below it.

    With `wide`, verdicts are right-aligned in the terminal.
    """
    from rich.console import Group
    from rich.markup import escape
    from rich.table import Table

    from flowlanes.printing.plain_text import plain_words

    from .prove import coloured_decision

    head = Table.grid(padding=(0, 2), expand=wide)
    head.add_column(ratio=1 if wide else None)
    head.add_column(justify="right", no_wrap=True)
    head.add_column(justify="right", no_wrap=True, min_width=8)
    verdicts = [v for v in (judgement.printed, judgement.corrected) if v is not None]
    shown = " → ".join(coloured_decision(verdict.decision) for verdict in verdicts)
    head.add_row(
        f"[bold]{escape(plain_words(judgement.claim.source))}[/]",
        shown,
        f"{judgement.seconds:.2f} s",
    )
    text = Table.grid(padding=(0, 2, 0, 0))
    text.add_column(no_wrap=True, style="dim", min_width=11)
    text.add_column()
    for label, words in _remarks(judgement):
        text.add_row(f"  {label}", escape(words))
    return Group(head, text) if text.rows else head


def _remarks(judgement: Judgement) -> Iterator[tuple[str, str]]:
    """Labels and texts of the remarks on a claim; both forms if the printed one fails."""
    from flowlanes.printing.plain_text import plain_words

    claim = judgement.claim
    if not judgement.printed:
        yield "printed", plain_words(claim.statement)
    if judgement.corrected is not None:
        yield "corrected", plain_words(claim.correction)
    if claim.note:
        yield "note", plain_words(claim.note)
    if claim.erratum:
        yield "erratum", plain_words(claim.erratum)
    if claim.argument:
        yield "argument", plain_words(claim.argument)
    if judgement.conditions:
        yield "where", plain_words(", ".join(judgement.conditions))
    if judgement.reason:
        yield "undecided", judgement.reason
