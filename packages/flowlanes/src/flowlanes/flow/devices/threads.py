"""The motions of one call shared between threads."""

from __future__ import annotations

import itertools
import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextvars import ContextVar, copy_context
from typing import TypeVar

import numpy as np

T = TypeVar("T")

#: Threads that a section of a program may use at most; set by code that runs several at once.
THREADS: ContextVar[int] = ContextVar("THREADS", default=2**31)

#: Motions of a piece at least: fewer are done sooner than a thread begins.
_PIECE = 32


def available_threads() -> int:
    """Processors that this section of the program may use."""
    if hasattr(os, "sched_getaffinity"):
        processors = len(os.sched_getaffinity(0))
    else:
        processors = os.cpu_count() or 1
    return min(processors, THREADS.get())


def map_in_threads(compute: Callable[[int, int], T], count: int) -> list[T]:
    """Results of ``compute(first, last)`` on ranges that together are 0, …, count − 1.

    There is a range for each processor that may be used, or fewer; what a range computes may use
    its share of them.  For work whose parts of NumPy leave other processors idle.
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
    """Call ``compute(first, last)`` on ranges that together are 0, …, count − 1.

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
