"""The command ``chaplygin``, also as ``python -m chaplygin``."""

from __future__ import annotations

import contextlib
import os
import sys

from .interruption import CODE, watched

__all__ = ["main"]


def main() -> None:
    """Run the command line; see :func:`chaplygin.cli.main`."""
    try:
        with watched():
            from .cli import main as command

            command()
    except SystemExit as end:
        if end.code == CODE:
            # without waiting for threads that compute what nobody wants any more
            with contextlib.suppress(OSError):
                sys.stdout.flush()
            os._exit(CODE)
        raise


if __name__ == "__main__":
    main()
