"""Many cases, each judged in a process that may be ended."""

from __future__ import annotations

import multiprocessing
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from typing import Any

from flowlanes.errors import InputError
from fuzz.case import Case
from fuzz.judge import judged
from fuzz.planter import planted_case
from lawproof.proof.prover import prove

__all__ = ["Outcome", "run", "tried"]


@dataclass(frozen=True)
class Outcome:
    """What came of a case.

    `told` is the decision of the prover, or the name and text of an exception.
    """

    number: int
    family: str
    truth: str
    why: str
    outcome: str
    told: str
    seconds: float


def tried(case: Case) -> tuple[str, str]:
    """The outcome of a case, and what the prover said."""
    made = None
    try:
        made = case.make()
        verdict: Any = prove(*made)
    except InputError as error:
        verdict = error
    except Exception as error:
        verdict = error
    outcome = judged(case, verdict, made)
    if isinstance(verdict, Exception):
        return outcome, f"{type(verdict).__name__}: {verdict}"
    conditions = f" where {', '.join(verdict.conditions)}" if verdict.conditions else ""
    return outcome, f"{verdict.decision}{conditions}" + f" ({verdict.reason})" * bool(
        verdict.reason
    )


def _work(pipe: Connection, seed: int) -> None:
    with suppress(EOFError):
        while True:
            number = pipe.recv()
            case = planted_case(seed, number)
            started = time.monotonic()
            outcome, told = tried(case)
            spent = time.monotonic() - started
            pipe.send(Outcome(number, case.family, case.truth, case.why, outcome, told, spent))


class _Worker:
    """A process, and the case it works at."""

    def __init__(self, seed: int) -> None:
        context = multiprocessing.get_context("spawn")
        self.pipe, theirs = context.Pipe()
        self.process = context.Process(target=_work, args=(theirs, seed), daemon=True)
        self.process.start()
        theirs.close()
        self.number: int | None = None
        self.started = 0.0

    def give(self, number: int) -> None:
        self.number, self.started = number, time.monotonic()
        self.pipe.send(number)

    def end(self) -> None:
        self.process.kill()
        self.process.join()
        self.pipe.close()


def run(
    seed: int, numbers: Iterator[int], seconds: float, processes: int = 2, grace: float = 20.0
) -> Iterator[Outcome]:
    """The outcomes of cases as they come.

    Parameters
    ----------
    seed : int
    numbers : iterator of int
        Which cases.
    seconds : float
        What the prover is given for each; a process that takes longer by more than `grace`
        seconds is ended.
    processes : int
    """

    def start() -> _Worker:
        return _Worker(seed)

    workers = [start() for _ in range(processes)]
    try:
        yield from _outcomes(workers, numbers, start, seed, seconds + grace)
    finally:
        for worker in workers:
            worker.end()


def _outcomes(
    workers: list[_Worker],
    numbers: Iterator[int],
    start: Callable[[], _Worker],
    seed: int,
    limit: float,
) -> Iterator[Outcome]:
    for worker in workers:
        _give(worker, numbers)
    while busy := [w for w in workers if w.number is not None]:
        ready = wait([w.pipe for w in busy], timeout=1.0)
        for worker in busy:
            spent = time.monotonic() - worker.started
            if worker.pipe in ready:
                try:
                    yield worker.pipe.recv()
                    _give(worker, numbers)
                    continue
                except EOFError:
                    end = ("crash", "the process ended")
            elif spent > limit:
                end = ("too long", "")
            else:
                continue
            assert worker.number is not None
            case = planted_case(seed, worker.number)
            yield Outcome(worker.number, case.family, case.truth, case.why, *end, spent)
            worker.end()
            workers[workers.index(worker)] = fresh = start()
            _give(fresh, numbers)


def _give(worker: _Worker, numbers: Iterator[int]) -> None:
    worker.number = None
    for number in numbers:
        worker.give(number)
        return
