"""Worker processes for the computations of pages: one task at a time each, cancellable."""

from __future__ import annotations

import asyncio
import contextlib
import sys
from collections.abc import AsyncGenerator, Callable, Iterator
from dataclasses import dataclass, field
from multiprocessing import get_context
from multiprocessing.context import SpawnProcess
from typing import TypeAlias

from flowlanes.child_processes import follow_parent, signals_blocked

if sys.platform == "win32":
    from multiprocessing.connection import PipeConnection as Connection
else:
    from multiprocessing.connection import Connection

#: A part of an answer; the last one is None.
Message: TypeAlias = dict[str, object]

#: Computes the parts of an answer to a task; called in a worker.
Answer: TypeAlias = Callable[[object], Iterator[Message]]

#: Maximum number of waiting computations.
WAITING = 200

#: Seconds that a cancelled computation has to end by itself.
GRACE = 0.5


class BusyError(Exception):
    """Too many computations are already waiting."""


@dataclass(eq=False)
class _Worker:
    process: SpawnProcess
    pipe: Connection


@dataclass
class Pool:
    """A pool of workers, started on demand.

    Parameters
    ----------
    answer : callable
        The function that a worker calls; it must be importable from a module.
    size : int
        Number of workers.
    longest : float, optional
        Maximum number of seconds between two parts of an answer; a slower computation is ended.
    """

    answer: Answer
    size: int
    longest: float | None = None
    _free: list[_Worker] = field(default_factory=list)
    _all: set[_Worker] = field(default_factory=set)
    _waiting: int = 0
    _turn: asyncio.Semaphore | None = None
    _clearing: set[asyncio.Task[None]] = field(default_factory=set)

    async def ask(self, task: object) -> AsyncGenerator[Message, None]:
        """The parts of an answer, as they are computed.

        If the iteration is abandoned, the computation is cancelled.

        Raises
        ------
        BusyError
            If too many wait already.
        """
        if self._turn is None:
            self._turn = asyncio.Semaphore(self.size)
        if self._waiting >= WAITING:
            raise BusyError
        self._waiting += 1
        try:
            if self._turn.locked():
                yield {"doing": "waiting for other computations"}
            await self._turn.acquire()
        finally:
            self._waiting -= 1
        making = asyncio.create_task(self._worker())
        reading: asyncio.Task[Message | None] | None = None
        finished = False
        try:
            worker = await asyncio.shield(making)
            await asyncio.to_thread(worker.pipe.send, task)
            while True:
                reading = asyncio.create_task(asyncio.to_thread(worker.pipe.recv))
                try:
                    async with asyncio.timeout(self.longest):
                        message = await asyncio.shield(reading)
                except TimeoutError:
                    yield {"error": f"it took longer than {self.longest:g} s and was stopped"}
                    return
                except (EOFError, OSError):
                    yield {"error": "the computation ended the process that was doing it"}
                    return
                if message is None:
                    finished = True
                    return
                yield message
        finally:
            if finished:
                self._free.append(making.result())
                self._turn.release()
            else:
                clearing = asyncio.ensure_future(self._clear(making, reading))
                self._clearing.add(clearing)
                clearing.add_done_callback(self._clearing.discard)

    async def _worker(self) -> _Worker:
        while self._free:
            worker = self._free.pop()
            # A waiting worker may have been killed, for example when memory was short.
            if worker.process.is_alive():
                return worker
            self._end(worker)
        return await asyncio.to_thread(self._new)

    async def _clear(
        self, making: asyncio.Task[_Worker], reading: asyncio.Task[Message | None] | None
    ) -> None:
        """Cancel a computation, and give its slot to the next one."""
        assert self._turn is not None
        try:
            worker = await making
            if reading is not None and await self._drained(worker, reading):
                self._free.append(worker)
            else:
                self._end(worker)
        finally:
            self._turn.release()

    async def _drained(self, worker: _Worker, reading: asyncio.Task[Message | None]) -> bool:
        """Whether the worker finished its answer within a moment."""
        try:
            async with asyncio.timeout(GRACE):
                while await asyncio.shield(reading) is not None:
                    reading = asyncio.create_task(asyncio.to_thread(worker.pipe.recv))
                return True
        except (TimeoutError, EOFError, OSError):
            # Once the process is gone, so is the thread that reads from it.
            reading.add_done_callback(_hear)
            return False

    def _new(self) -> _Worker:
        context = get_context("spawn")
        ours, theirs = context.Pipe()
        process = context.Process(target=work, args=(theirs, self.answer), daemon=True)
        with signals_blocked():
            process.start()
        theirs.close()
        worker = _Worker(process, ours)
        self._all.add(worker)
        return worker

    def _end(self, worker: _Worker) -> None:
        self._all.discard(worker)
        worker.process.kill()
        worker.process.join(2.0)

    def close(self) -> None:
        """End all workers."""
        for worker in list(self._all):
            self._end(worker)
        self._free.clear()


def _hear(task: asyncio.Task[Message | None]) -> None:
    """Retrieve the result of a task that nobody awaits."""
    if not task.cancelled():
        task.exception()


def work(pipe: Connection, answer: Answer) -> None:
    """The main function of a worker: compute answers until the other end of the pipe is closed."""
    follow_parent()
    with contextlib.suppress(EOFError, OSError):
        while True:
            task = pipe.recv()
            for message in answer(task):
                pipe.send(message)
            pipe.send(None)
