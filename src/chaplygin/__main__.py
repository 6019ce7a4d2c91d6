"""The command ``chaplygin``, also as ``python -m chaplygin``."""

from __future__ import annotations

import os
import signal
import threading

from .interruption import CODE, GRACE, interruptible


def main() -> None:
    """Run the command line; see :func:`chaplygin.cli.main`."""
    try:
        with interruptible():
            from .cli import main as command

            command()
    except SystemExit as end:
        if end.code == CODE:
            # do not wait for threads that compute what nobody wants any more
            timer = threading.Timer(GRACE, os._exit, (CODE,))
            timer.daemon = True
            timer.start()
        raise
    finally:
        # all is said and written: the interpreter needs a moment to end
        signal.signal(signal.SIGINT, signal.SIG_IGN)


if __name__ == "__main__":
    main()
