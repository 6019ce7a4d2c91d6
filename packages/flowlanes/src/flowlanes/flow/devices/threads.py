"""Share the motions of one call between threads."""

from __future__ import annotations

import itertools
import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextvars import ContextVar, copy_context
from typing import TypeVar

import numpy as np

T = TypeVar("T")

#: Number of threads that the current context may use; set by code that runs several tasks at once.
THREADS: ContextVar[int] = ContextVar("THREADS", default=2**31)

#: Smallest number of motions per thread: for fewer, starting a thread does not pay.
_PIECE = 32


def available_threads() -> int:
    """Number of processors that the current context may use."""
    if hasattr(os, "sched_getaffinity"):
        processors = len(os.sched_getaffinity(0))
    else:
        processors = os.cpu_count() or 1
    return min(processors, THREADS.get())


def map_in_threads(compute: Callable[[int, int], T], count: int) -> list[T]:
    """Apply ``compute(first, last)`` to ranges that partition 0, …, count − 1; return the results.

    There is at most one range per available processor; within a range, the rest of the processors
    may be used.  This is for work whose NumPy parts leave other processors idle.
    """
    processors = available_threads()
    edges = np.linspace(0, count, max(1, min(processors, count)) + 1).astype(int).tolist()
    ranges = list(itertools.pairwise(edges))
    if len(ranges) == 1:
        return [compute(0, count)]

    def alone(first: int, last: int) -> T:
        THREADS.set(processors // len(ranges))
        return compute(first, last)

    with ThreadPoolExecutor(len(ranges)) as pool:
        jobs = [pool.submit(copy_context().run, alone, *ends) for ends in ranges]
        return [job.result() for job in jobs]


def run_in_threads(compute: Callable[[int, int], None], count: int, threads: int | None) -> None:
    """Call ``compute(first, last)`` on ranges that partition 0, …, count − 1.

    Parameters
    ----------
    compute : callable
    count : int
        Number of motions.
    threads : int or None
        All processors that may be used if None.
    """
    threads = available_threads() if threads is None else threads
    pieces = 1 if threads == 1 else min(4 * threads, count // _PIECE)
    if pieces <= 1:
        compute(0, count)
        return
    edges = np.linspace(0, count, pieces + 1).astype(int)
    with ThreadPoolExecutor(threads) as pool:
        jobs = [pool.submit(compute, int(a), int(b)) for a, b in itertools.pairwise(edges)]
        for job in jobs:
            job.result()
