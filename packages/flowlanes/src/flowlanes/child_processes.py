"""Worker processes that always end together with their parent."""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from multiprocessing import parent_process
from multiprocessing.process import BaseProcess

#: Seconds that a process has to remove its partial files before it is killed.
LAST_SECONDS = 2.0


def follow_parent() -> None:
    """Initialize a new process: it ignores Ctrl-C, and ends when the parent ends or requests it.

    Ctrl-C is sent to all processes of a terminal.  SIGTERM and the end of the parent raise
    SystemExit, so partial files are removed; a process that does not end is killed.
    """
    # A forked process would pass its own signals to the parent.
    signal.set_wakeup_fd(-1)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, lambda number, _: sys.exit(128 + number))
    if sys.platform != "win32":
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT, signal.SIGTERM})
    threading.Thread(target=_watch_parent, daemon=True).start()


def _watch_parent() -> None:
    parent = parent_process()
    if parent is not None:
        parent.join()
        if sys.platform != "win32":
            os.kill(os.getpid(), signal.SIGTERM)
            time.sleep(LAST_SECONDS)
        os._exit(1)


@contextmanager
def signals_blocked() -> Iterator[None]:
    """Context for starting processes: no signal is delivered to them before `follow_parent`.

    Windows has no equivalent, so there it has no effect.
    """
    if sys.platform == "win32":
        yield
    else:
        before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGTERM})
        try:
            yield
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)


def end_processes(processes: Iterable[BaseProcess], seconds: float = LAST_SECONDS) -> None:
    """Request that processes end, and kill those that are still running after some seconds."""
    asked = list(processes)
    for process in asked:
        process.terminate()
    deadline = time.monotonic() + seconds
    for process in asked:
        process.join(max(0.0, deadline - time.monotonic()))
        if process.is_alive():
            process.kill()
            process.join()
