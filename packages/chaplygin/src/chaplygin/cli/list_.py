"""``chaplygin list``: the catalogue."""

from __future__ import annotations

from .terminal.options import console, print_json

#: Number of columns of a terminal with room for names, titles and sources.
WIDE = 110


def command(
    contact: str | None = None,
    section: str | None = None,
    integrable: bool = False,
    json: bool = False,
) -> None:
    """List the systems of the catalogue by groups.

    Bruns' field, in some titles, is the quadratic potential U = ½ K (γ, I γ).
    """
    from flowlanes.errors import InputError
    from nonholonomic.catalogue.entry_files import entry_files
    from nonholonomic.catalogue.groups import GROUPS, in_section, sections

    if section is not None and not any(in_section(file, section) for file in entry_files()):
        known = ", ".join(sections(entry_files()))
        raise InputError(f"--section {section}: nothing is from there; there are {known}, 6.1, …")
    groups = {
        group: [
            file
            for file in group.files
            if (section is None or in_section(file, section))
            and (file.integrable or not integrable)
        ]
        for group in GROUPS
        if contact in (None, group.contact)
    }
    if json:
        print_json(
            [
                {
                    "name": file.name,
                    "title": file.title,
                    "summary": file.summary,
                    "source": file.source,
                    "parameters": file.parameters,
                    "group": group.title,
                    "contact": group.contact,
                    "integrable": file.integrable,
                }
                for file in entry_files()
                for group, files in groups.items()
                if file in files
            ]
        )
        return
    if not any(groups.values()):
        raise InputError("no system of the catalogue is of all these kinds: leave out a filter")
    from rich import box
    from rich.table import Table

    shown = console()
    # On a narrow terminal there is no room for the sources beside the names.
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
            mark = " [dim](integrable)[/]" if item.integrable else ""
            row = (f"  {item.name}", f"{item.title}{mark}", item.source)
            table.add_row(*row[: 3 if wide else 2])
        if items:
            shown.print(f"\n[bold]{group.title}[/]")
            shown.print(table)
    shown.print(
        "\nchaplygin show NAME prints the equations; chaplygin study NAME writes a report of a "
        "motion."
    )
