"""Computation of blocks on the workers of a Dask cluster.

Workers only compute; only this process writes.  So no file system is shared, and the loss of a
worker costs only its current block, which is computed again by another worker.
"""

from __future__ import annotations

import functools
import logging
import os
from collections import Counter, deque
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np

from ...errors import InputError
from .task import Arrays, Divisible, IncompleteError, Work

if TYPE_CHECKING:
    from distributed import Client, Future

#: Number of blocks queued per worker thread, besides the current one.
_WAITING = 1

#: Number of times that Dask may retry a block before the computation stops.
_MOST_FAILURES = 3

#: Time within which a scheduler must answer.
CONNECTION_TIMEOUT = "10s"


def results(
    client: Client | str | int, work: Work, blocks: Mapping[int, tuple[int, int]]
) -> Iterator[tuple[int, Arrays]]:
    """Blocks in the order in which they are ready.

    Parameters
    ----------
    client : dask.distributed.Client, str or int
        A client, the address of a scheduler, a number of processes of this machine, or ``"local"``
        for one process per processor.
    work : callable
    blocks : mapping of int to (int, int)
        First member of every block, and the next member after its last one.

    Raises
    ------
    InputError
        If Dask is not installed, the client is not one of these, the scheduler cannot be reached,
        or its workers lack a module.
    IncompleteError
        If a block terminates one worker after another, or the cluster is lost.
    """
    try:
        import cloudpickle
        import distributed
    except ImportError:
        raise InputError(
            "a computation on a cluster needs Dask: pip install cloudpickle dask distributed"
        ) from None
    if not blocks:
        return
    with _client(client) as connected:
        waiting = deque(blocks)
        blamed: Counter[int] = Counter()
        under_way: dict[Future[Any], int] = {}
        ready = distributed.as_completed(loop=connected.loop)

        def send() -> None:
            threads = sum(connected.nthreads().values())
            while waiting and len(under_way) < (1 + _WAITING) * max(1, threads):
                block = waiting.popleft()
                members = blocks[block]
                share = work.part(*members) if isinstance(work, Divisible) else work
                packed = cloudpickle.dumps(share)
                future = connected.submit(_compute, packed, *members, pure=False)
                under_way[future] = block
                ready.add(future)

        send()
        for future in ready:
            block = under_way.pop(future)
            try:
                arrays: Arrays = future.result()
            except distributed.KilledWorker:
                # Dask blames all blocks of a lost worker, not only its current one.
                blamed[block] += 1
                if blamed[block] == _MOST_FAILURES:
                    first, last = blocks[block]
                    raise IncompleteError(
                        f"the block of members {first} to {last - 1} brought down one worker after "
                        "another: it may need more memory than they have"
                    ) from None
                waiting.append(block)
                send()
                continue
            except ModuleNotFoundError as problem:
                raise InputError(
                    f"the Dask workers cannot import {problem.name}: install there what is "
                    "installed here, in the same versions"
                ) from problem
            except distributed.client.FutureCancelledError:
                raise IncompleteError(
                    "the Dask cluster has gone; what was written stays: run the same again"
                ) from None
            send()
            yield block, arrays


def _compute(pickle: bytes, first: int, last: int) -> Arrays:
    """Compute a block in a worker thread, on FLOWLANES_THREADS processors (default 1)."""
    from ..devices.threads import THREADS

    before = THREADS.set(int(os.environ.get("FLOWLANES_THREADS", "1")))
    try:
        return _work_of(pickle)(first, last)
    finally:
        THREADS.reset(before)


@functools.lru_cache(maxsize=2)
def _work_of(pickle: bytes) -> Work:
    """Work, unpickled once per worker instead of once per block."""
    import cloudpickle

    work: Work = cloudpickle.loads(pickle)
    return work


@contextmanager
def _client(client: Client | str | int) -> Iterator[Client]:
    """Connection to a cluster; a client that is opened here is closed at the end."""
    import dask
    import distributed

    if isinstance(client, distributed.Client):
        yield client
        return
    whole = isinstance(client, int | np.integer)
    if not isinstance(client, str) and not (whole and client >= 1):
        raise InputError(
            f"there is no cluster {client!r}: a Dask client, an address such as "
            "'tcp://host:8786', 'local' or a number of processes from 1 on is needed"
        )
    if whole or client == "local":
        number = int(client) if whole else None
        # A worker that is killed while it is being restarted is restarted again.
        patient = {"distributed.deploy.lost-worker-timeout": "1 day"}
        with (
            dask.config.set(patient),
            distributed.LocalCluster(
                n_workers=number,
                threads_per_worker=1,
                dashboard_address=":0",
                # Failures are reported with the futures; a failed heartbeat to a closing scheduler
                # is harmless.
                silence_logs=logging.CRITICAL,
            ) as cluster,
            distributed.Client(cluster, set_as_default=False) as connected,
        ):
            yield connected
    else:
        try:
            # Otherwise a client that fails in its constructor would remain the default of the
            # process.
            connected = distributed.Client(client, timeout=CONNECTION_TIMEOUT, set_as_default=False)
        except (OSError, ValueError) as problem:
            raise InputError(
                f"there is no Dask scheduler at {client!r} ({problem}); an address such as "
                "'tcp://host:8786' or 'local' is needed"
            ) from problem
        with connected:
            yield connected
