"""``chaplygin lab``: the laboratory in a browser."""

from __future__ import annotations

import os
from pathlib import Path

import typer

from ..interruption import exit_code, message_on_interrupt
from .terminal.options import is_name, study_of
from .terminal.progress import waiting

#: Default port of the server.
PORT = 8714

#: System opened by default.
FIRST = "rattleback"


def command(
    what: str = FIRST,
    port: int = PORT,
    show: bool = False,
    overrides: list[str] | None = None,
) -> None:
    r"""Serve the laboratory to the browser of this machine until Ctrl-C.

    The page plays and computes by itself; the server adds what needs Python:
    proofs, the search for laws, closed forms, periodic orbits, long charts, files.
    It reads and writes experiment files in the folder of FILE, or else in the
    current one, and nothing elsewhere. Needs the extra: pip install
    'chaplygin\[lab]'.
    """
    from flowlanes.errors import InputError

    if not 0 <= port < 65536:
        raise InputError(f"--port {port}: it must be a number from 0 to 65535")
    named = is_name(what)
    try:
        import starlette  # noqa: F401
        import uvicorn  # noqa: F401
    except ImportError:
        raise InputError(
            "the laboratory needs Starlette and uvicorn: pip install 'chaplygin[lab]'"
        ) from None
    with waiting("preparing the laboratory"):
        from ..page.element import front_end
        from ..server.folder import Folder
        from ..server.serve import serve

        front_end()
    if named and not overrides:
        folder, name = Folder(Path.cwd()), what
    else:
        study = study_of(what, overrides)
        path = Path(what)
        place = path.resolve().parent if path.is_file() else Path.cwd()
        name = path.name
        folder = Folder(place, {name: study.complete_toml()})

    def announce(address: str) -> None:
        text = f"the laboratory is open at\n\n    {address}\n\nfor this machine, until Ctrl-C"
        typer.echo(text, err=True)
        if show:
            import webbrowser

            webbrowser.open(address)

    try:
        with message_on_interrupt(
            "the laboratory is closed; experiments and charts that were saved stay"
        ):
            serve(folder, name, port, announce)
    except KeyboardInterrupt:
        # No worker is left, and unloading the libraries would take a second.
        os._exit(exit_code())
