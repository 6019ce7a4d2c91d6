"""``chaplygin list``: the catalogue."""

from __future__ import annotations

from typing import Annotated

import typer

from .terminal.options import Json, console, print_json
from .terminal.progress import waiting

#: Columns of a terminal that has room for names, titles and sources.
WIDE = 110

CONTACTS = ("marble", "rubber", "none")


def command(
    contact: Annotated[
        str | None,
        typer.Option(
            help="Only this contact: marble (no slipping; spinning allowed), rubber (neither "
            "slipping nor spinning) or none (nothing rolls)."
        ),
    ] = None,
    section: Annotated[
        str | None,
        typer.Option(
            metavar="N", help="Only systems from this section of Borisov and Mamaev (2008)."
        ),
    ] = None,
    integrable: Annotated[
        bool,
        typer.Option(
            "--integrable", help="Only systems proven integrable at their default parameters."
        ),
    ] = False,
    json: Json = False,
) -> None:
    """List the systems of the catalogue by groups.

    Bruns' field, in some titles, is the quadratic potential U = ½ K (γ, I γ).
    """
    from flowlanes.errors import InputError
    from nonholonomic.catalogue.groups import GROUPS, INTEGRABLE, in_section, sections

    if contact is not None and contact not in CONTACTS:
        raise InputError(f"--contact {contact}: it must be one of {', '.join(CONTACTS)}")
    with waiting("reading the catalogue"):
        from nonholonomic.catalogue import CATALOGUE
    if section is not None and not any(in_section(i, section) for i in CATALOGUE.values()):
        known = ", ".join(sections(CATALOGUE))
        raise InputError(f"--section {section}: nothing is from there; there are {known}, 6.1, …")
    groups = {
        group: [
            CATALOGUE[name]
            for name in group.names
            if (section is None or in_section(CATALOGUE[name], section))
            and (name in INTEGRABLE or not integrable)
        ]
        for group in GROUPS
        if contact in (None, group.contact)
    }
    if json:
        chosen = {item.name: group for group, items in groups.items() for item in items}
        print_json(
            [
                {
                    "name": name,
                    "title": item.title,
                    "summary": item.summary,
                    "source": item.source,
                    "parameters": dict(item.defaults),
                    "group": chosen[name].title,
                    "contact": chosen[name].contact,
                    "integrable": name in INTEGRABLE,
                }
                for name, item in CATALOGUE.items()
                if name in chosen
            ]
        )
        return
    if not any(groups.values()):
        raise InputError("no system of the catalogue is of all these kinds: leave out a filter")
    from rich import box
    from rich.table import Table

    shown = console()
    # beside the names there is no room for the sources on a narrow terminal
    wide = shown.width >= WIDE
    width = max(len(item.name) for items in groups.values() for item in items) + 2
    for group, items in groups.items():
        table = Table(
            box=box.SIMPLE_HEAD, pad_edge=False, show_edge=False, show_header=False, padding=(0, 1)
        )
        table.add_column(no_wrap=True, min_width=width)
        table.add_column(ratio=3)
        if wide:
            table.add_column(style="dim", ratio=2)
        for item in items:
            mark = " [dim](integrable)[/]" if item.name in INTEGRABLE else ""
            row = (f"  {item.name}", f"{item.title}{mark}", item.source)
            table.add_row(*row[: 3 if wide else 2])
        if items:
            shown.print(f"\n[bold]{group.title}[/]")
            shown.print(table)
    shown.print(
        "\nchaplygin show NAME prints the equations; chaplygin study NAME writes a report of a "
        "motion."
    )
