"""Do work in the background, on a second core.

The process is a fork of this one, so that nothing is sent to it, and its result does not depend on
when it is requested. If processes cannot be forked, and in a thread of a server, where other
threads may hold locks, the work is done when its result is requested.
"""

from __future__ import annotations

import sys
import threading
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from functools import cache
from multiprocessing import get_context
from multiprocessing.connection import Connection
from typing import TypeVar

from flowlanes.child_processes import end_processes, follow_parent, signals_blocked

T = TypeVar("T")


@contextmanager
def beside(work: Callable[[], T]) -> Iterator[Callable[[], T]]:
    """Start the work in the background; the returned function waits for its result.

    Parameters
    ----------
    work : callable
        A function without side effects except files; its result or exception must be picklable.

    Examples
    --------
    >>> with beside(lambda: 6 * 7) as result:
    ...     result()
    42
    """
    if sys.platform == "linux" and threading.current_thread() is threading.main_thread():
        context = get_context("fork")
        receiver, sender = context.Pipe(duplex=False)
        process = context.Process(target=_send_result, args=(work, receiver, sender), daemon=True)
        with signals_blocked(), warnings.catch_warnings():
            # Threads of this program hold no lock that the fork needs.
            warnings.simplefilter("ignore", DeprecationWarning)
            process.start()
        sender.close()

        @cache
        def result() -> T:
            try:
                answer: tuple[T] | Exception = receiver.recv()
            except EOFError:
                # It was killed from outside, for example when memory was short.
                return work()
            if isinstance(answer, Exception):
                raise answer
            return answer[0]

        try:
            yield result
        finally:
            receiver.close()
            end_processes([process])
    else:
        yield cache(work)


def _send_result(work: Callable[[], T], receiver: Connection, sender: Connection) -> None:
    """Send the result of work, or its exception.

    Interruptions are handled by the parent process.
    """
    # A fork has both ends of the pipe: with its own reading end open it would wait forever.
    receiver.close()
    follow_parent()
    # The parent may hold the lock of the object that replaces a terminal.
    sys.stdout, sys.stderr = sys.__stdout__, sys.__stderr__
    answer: tuple[T] | Exception
    try:
        answer = (work(),)
    except Exception as error:
        answer = error
    # The parent has ended, so nobody reads the result.
    with suppress(BrokenPipeError):
        sender.send(answer)
    sender.close()
