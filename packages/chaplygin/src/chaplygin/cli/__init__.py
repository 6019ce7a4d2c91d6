"""Command line: one module per command, imported on first use."""

from __future__ import annotations

import logging
import os
import sys

import typer

from ..interruption import interruptible
from . import (
    animate,
    audit,
    bifurcation,
    chart,
    ensemble,
    find,
    lab,
    list_,
    lyapunov,
    orbit,
    prove,
    run,
    section,
    show,
    solve,
    study,
    sweep,
)
from .messages.usage import sentence
from .terminal.command import Command
from .terminal.option_table import with_options
from .terminal.options import complain
from .terminal.progress import LOGGERS

__all__ = ["app", "main"]

app = typer.Typer(
    name="chaplygin",
    help="A laboratory for nonholonomic mechanics: say what rolls on what.\n\n"
    "A body rolls in marble contact (no slipping; spinning allowed) or in rubber contact (neither "
    "slipping nor spinning). The paper is Borisov and Mamaev, 2008 (Regul. Chaotic Dyn. 13, "
    "443–490).",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)
for name, module in {
    "list": list_,
    "show": show,
    "run": run,
    "study": study,
    "solve": solve,
    "find": find,
    "prove": prove,
    "ensemble": ensemble,
    "sweep": sweep,
    "section": section,
    "orbit": orbit,
    "bifurcation": bifurcation,
    "lyapunov": lyapunov,
    "chart": chart,
    "animate": animate,
    "lab": lab,
    "audit": audit,
}.items():
    app.command(name, cls=Command)(with_options(name, module.command))


@app.callback(invoke_without_command=True)
def _options(
    context: typer.Context,
    version: bool = typer.Option(False, "--version", help="Print the version and exit."),
    quiet: bool = typer.Option(False, "--quiet", help="Print only results and errors."),
    verbose: bool = typer.Option(
        False, "--verbose", help="Also print what is compiled and what is read from the cache."
    ),
) -> None:
    if quiet and verbose:
        complain("--quiet --verbose: only one of them can hold")
        raise typer.Exit(2)
    level = logging.WARNING if quiet else logging.DEBUG if verbose else logging.INFO
    handler = logging.StreamHandler(sys.stderr)
    for logger in LOGGERS:
        logger.handlers[:] = [handler]
        logger.setLevel(level)
    if version:
        from .._version import __version__

        typer.echo(f"chaplygin {__version__}")
        raise typer.Exit
    if context.invoked_subcommand is None:
        complain("a command is missing; chaplygin --help lists them")
        raise typer.Exit(2)


def main() -> None:
    """Run the command line.

    The exit status is 0 on success, 1 if the answer is no, 2 for bad input, 130 if interrupted and
    143 if ended by SIGTERM.
    """
    from flowlanes.errors import InputError, RunError

    with interruptible():
        try:
            try:
                # A completed command returns None, an early end its code.
                code = app(standalone_mode=False)
            finally:
                sys.stdout.flush()
            sys.exit(code or 0)
        except SystemExit as end:
            if isinstance(end.__context__, BrokenPipeError):
                _leave(0)
            raise
        except typer.TyperException as error:
            # Without any argument Typer has already printed the help.
            if len(sys.argv) > 1:
                complain(sentence(error))
            sys.exit(2)
        except InputError as error:
            complain(str(error))
            sys.exit(2)
        except RunError as error:
            complain(str(error))
            sys.exit(1)
        except BrokenPipeError:
            _leave(0)
        except OSError as error:
            place = error.filename or "the output"
            complain(f"{place} cannot be written: {error.strerror or error}")
            _leave(2)


def _leave(code: int) -> None:
    """End without a message if standard output is closed."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    sys.exit(code)
