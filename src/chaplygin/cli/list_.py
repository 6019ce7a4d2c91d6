"""``chaplygin list``: the catalogue."""

from __future__ import annotations

from .common import Json, console, print_json

__all__ = ["command"]


def command(json: Json = False) -> None:
    """List the systems of the catalogue."""
    from ..systems import CATALOGUE

    if json:
        print_json(
            [
                {
                    "name": item.name,
                    "title": item.title,
                    "summary": item.summary,
                    "source": item.source,
                    "parameters": dict(item.defaults),
                }
                for item in CATALOGUE.values()
            ]
        )
        return
    from rich import box
    from rich.table import Table

    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, show_edge=False)
    table.add_column("Name", style="bold", no_wrap=True)
    table.add_column("What it is")
    table.add_column("Source", style="dim")
    for item in CATALOGUE.values():
        table.add_row(item.name, item.title, item.source)
    shown = console()
    shown.print(table)
    shown.print("\nchaplygin show NAME prints the equations; chaplygin study NAME follows them.")
