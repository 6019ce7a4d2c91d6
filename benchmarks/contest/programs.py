"""A program at its loosest setting that meets a target, and turns taken by several."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from .bodies import deviation

#: From starts (n, size) to what is compared with the exact answer, first axis n.
Run = Callable[[np.ndarray], np.ndarray]

#: Tolerances to choose from, eight to a decade.
TOLERANCES = tuple(10.0 ** (-k / 8) for k in range(6 * 8, 16 * 8 + 1))


@dataclass
class Program:
    """One way to compute many motions.

    Attributes
    ----------
    build : callable
        From a setting to the compiled program.
    settings : sequence of float
        From the coarsest to the finest.
    rehearse : callable, optional
        A program with the same errors that takes less time to compile, to find the setting with.
    share : float
        The part of the starts on which a slow program is timed.
    """

    name: str
    build: Callable[[float], Run]
    settings: Sequence[float] = TOLERANCES
    rehearse: Callable[[float], Run] | None = None
    share: float = 1.0
    compiled: dict[float, tuple[Run, float]] = field(default_factory=dict)

    def ready(self, setting: float, starts: np.ndarray) -> Run:
        """The program compiled for a setting."""
        if setting not in self.compiled:
            began = time.process_time()
            run = self.build(setting)
            run(starts[:1])
            first = time.process_time() - began
            began = time.process_time()
            run(starts[:1])
            self.compiled[setting] = run, max(0.0, first - (time.process_time() - began))
        return self.compiled[setting][0]

    @property
    def compilation(self) -> float:
        """Seconds of processor time to compile; many programs do so for one setting only."""
        return max(seconds for _, seconds in self.compiled.values())

    def calibrate(
        self, starts: np.ndarray, exact: np.ndarray, target: float, worst: float = np.inf
    ) -> float | None:
        """The coarsest setting with median and worst error within bounds; None if none has."""

        def meets(place: int) -> bool:
            setting = self.settings[place]
            run = self.rehearse(setting) if self.rehearse else self.ready(setting, starts)
            missed = deviation(run(starts), exact)
            return bool(np.nanmedian(missed) <= target and np.nanmax(missed) <= worst)

        low, high = 0, len(self.settings) - 1
        if not meets(high):
            return None
        while low < high:
            middle = (low + high) // 2
            low, high = (low, middle) if meets(middle) else (middle + 1, high)
        return self.settings[high]

    def finest(self, starts: np.ndarray, exact: np.ndarray, target: float) -> float:
        """The coarsest setting that meets the target, or comes within half of the best it can."""
        errors = [
            float(np.nanmedian(deviation(self.ready(setting, starts)(starts), exact)))
            for setting in self.settings
        ]
        enough = max(target, 1.5 * min(errors))
        return next(s for s, e in zip(self.settings, errors, strict=True) if e <= enough)


@dataclass(frozen=True)
class Result:
    """What a program did on held-out starts.

    Attributes
    ----------
    setting : float or None
        None where no setting meets the target; the rest then means nothing.
    error, worst : float
        Median and largest error of a motion, relative.
    core : float
        Seconds of processor time for each motion, all threads together.
    wall : float
        Seconds that passed for each motion.
    compile : float
        Seconds of processor time to compile.
    """

    name: str
    setting: float | None
    error: float = np.nan
    worst: float = np.nan
    core: float = np.nan
    wall: float = np.nan
    compile: float = np.nan


@dataclass(frozen=True)
class Trial:
    """Starts to choose settings by, and others to measure by, with their exact answers."""

    rehearsal: np.ndarray
    rehearsal_exact: np.ndarray
    scored: np.ndarray
    scored_exact: np.ndarray
    timed: np.ndarray


def contest(
    programs: Sequence[Program], trial: Trial, target: float, turns: int
) -> dict[str, Result]:
    """Every program at the target error; programs take turns, medians are compared."""
    chosen = {p.name: p.calibrate(trial.rehearsal, trial.rehearsal_exact, target) for p in programs}
    able = {p.name: p for p in programs if chosen[p.name] is not None}
    return {p.name: Result(p.name, None) for p in programs} | compare(able, chosen, trial, turns)


def compare(
    programs: Mapping[str, Program], settings: Mapping[str, Any], trial: Trial, turns: int
) -> dict[str, Result]:
    """Programs at given settings: errors on held-out starts, and times by turns."""
    runs: dict[str, tuple[Run, np.ndarray]] = {}
    results: dict[str, dict[str, float]] = {}
    for name, program in programs.items():
        run = program.ready(settings[name], trial.rehearsal)
        missed = deviation(run(trial.scored), trial.scored_exact)
        results[name] = {
            "error": float(np.nanmedian(missed)),
            "worst": float(np.nanmax(missed)),
            "compile": program.compilation,
        }
        count = max(1, round(program.share * len(trial.timed)))
        runs[name] = run, trial.timed[:count]
    taken = alternate(
        {name: (lambda r=run, s=starts: r(s)) for name, (run, starts) in runs.items()}, turns
    )
    for name, (core, wall) in taken.items():
        count = len(runs[name][1])
        results[name] |= {"core": core / count, "wall": wall / count}
    return {name: Result(name, settings[name], **found) for name, found in results.items()}


def alternate(works: Mapping[str, Callable[[], Any]], turns: int) -> dict[str, tuple[float, float]]:
    """Median seconds of processor and of wall clock for each of several works, by turns."""
    spent: dict[str, list[tuple[float, float]]] = {name: [] for name in works}
    for _ in range(turns):
        for name, work in works.items():
            core, wall = time.process_time(), time.perf_counter()
            work()
            spent[name].append((time.process_time() - core, time.perf_counter() - wall))
    return {
        name: (statistics.median(c for c, _ in pairs), statistics.median(w for _, w in pairs))
        for name, pairs in spent.items()
    }
