"""Work done beside other work, on a second core.

The process is a copy of this one, so that nothing is sent to it, and what it returns does not
depend on when it is asked for.  Where processes cannot be copied, and in a thread of a server,
where others may hold locks, the work is done when its result is asked for.
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
    """A function that waits for the result of work, which is done meanwhile.

    Parameters
    ----------
    work : callable
        Without effects but for files; its result, or what it raises, must be such as can be
        pickled.

    Examples
    --------
    >>> with beside(lambda: 6 * 7) as result:
    ...     result()
    42
    """
    if sys.platform == "linux" and threading.current_thread() is threading.main_thread():
        context = get_context("fork")
        receiver, sender = context.Pipe(duplex=False)
        process = context.Process(target=_do, args=(work, receiver, sender), daemon=True)
        with signals_blocked(), warnings.catch_warnings():
            # of other threads: those of this program hold no lock that the copy asks for
            warnings.simplefilter("ignore", DeprecationWarning)
            process.start()
        sender.close()

        @cache
        def result() -> T:
            try:
                answer: tuple[T] | Exception = receiver.recv()
            except EOFError:
                # it was ended from outside, such as for want of memory
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


def _do(work: Callable[[], T], receiver: Connection, sender: Connection) -> None:
    """Send the result of work, or what it raises; interruptions are for the first process."""
    # a copy has both ends: with its own end for reading it would wait for itself for ever
    receiver.close()
    follow_parent()
    # the other process may hold the lock of what stands in place of a terminal
    sys.stdout, sys.stderr = sys.__stdout__, sys.__stderr__
    answer: tuple[T] | Exception
    try:
        answer = (work(),)
    except Exception as error:
        answer = error
    # nobody reads it where the first process has ended
    with suppress(BrokenPipeError):
        sender.send(answer)
    sender.close()
