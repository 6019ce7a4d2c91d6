"""The command ``chaplygin``, also as ``python -m chaplygin``."""

from __future__ import annotations

import os
import signal
import sys
from types import FrameType


def main() -> None:
    """Run the command line; see :func:`chaplygin.cli.main`."""
    heard = signal.getsignal(signal.SIGINT) is signal.default_int_handler
    if heard:
        signal.signal(signal.SIGINT, _end)
    import gc
    import threading

    # Formulas and modules are many small objects that stay alive: scanning all of them for garbage
    # after every 700 allocations takes a tenth of the time of a study.
    gc.set_threshold(100_000, 20, 100)
    from .interruption import GRACE_PERIOD, exit_code, interruptible

    if heard:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with interruptible():
            from .cli import main as command

            command()
    except SystemExit as end:
        if end.code == exit_code():
            # Do not wait for threads whose results are no longer needed.
            timer = threading.Timer(GRACE_PERIOD, os._exit, (end.code,))
            timer.daemon = True
            timer.start()
        raise
    finally:
        # All output is written: the interpreter needs a moment to end.
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        # Skip the final garbage collection, which takes about a second.
        gc.freeze()


def _end(number: int, frame: FrameType | None) -> None:
    """End if an interruption arrives while its handler is still being imported.

    Uses default messages.
    """
    sys.stderr.write("interrupted: nothing was saved; the same command starts from the beginning\n")
    sys.stderr.flush()
    os._exit(128 + number)


if __name__ == "__main__":
    main()
