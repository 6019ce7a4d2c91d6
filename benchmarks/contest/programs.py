"""Program with the coarsest setting that attains a target, and alternating measurements."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from .bodies import deviation

#: Function from starts (n, size) to results for comparison with the exact ones, first axis n.
Run = Callable[[np.ndarray], np.ndarray]

#: Tolerances for the choice of settings, eight per decade.
TOLERANCES = tuple(10.0 ** (-k / 8) for k in range(6 * 8, 16 * 8 + 1))


@dataclass
class Program:
    """One method to compute many motions.

    Attributes
    ----------
    build : callable
        Function from a setting to the compiled program.
    settings : sequence of float
        Settings from the coarsest to the finest.
    rehearse : callable, optional
        Program with the same errors and shorter compilation, for the choice of the setting.
    share : float
        Fraction of the starts for the timing of a slow program.
    """

    name: str
    build: Callable[[float], Run]
    settings: Sequence[float] = TOLERANCES
    rehearse: Callable[[float], Run] | None = None
    share: float = 1.0
    compiled: dict[float, tuple[Run, float]] = field(default_factory=dict)

    def ready(self, setting: float, starts: np.ndarray) -> Run:
        """Program compiled for a setting."""
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
        """Processor time of the compilation in seconds; it often depends on the setting."""
        return max(seconds for _, seconds in self.compiled.values())

    def calibrate(
        self, starts: np.ndarray, exact: np.ndarray, target: float, worst: float = np.inf
    ) -> float | None:
        """Coarsest setting with median and worst error within bounds; None if there is none."""

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
        """Coarsest setting that attains the target, or an error within half of the best one."""
        errors = [
            float(np.nanmedian(deviation(self.ready(setting, starts)(starts), exact)))
            for setting in self.settings
        ]
        enough = max(target, 1.5 * min(errors))
        return next(s for s, e in zip(self.settings, errors, strict=True) if e <= enough)


@dataclass(frozen=True)
class Result:
    """Results of a program on held-out starts.

    Attributes
    ----------
    setting : float or None
        None if no setting attains the target; then the other values have no meaning.
    error, worst : float
        Median and largest relative error of a motion.
    core : float
        Processor time in seconds for each motion, summed over all threads.
    wall : float
        Wall-clock time in seconds for each motion.
    compile : float
        Processor time of the compilation in seconds.
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
    """Starts for the choice of settings and for measurements, with their exact results."""

    rehearsal: np.ndarray
    rehearsal_exact: np.ndarray
    scored: np.ndarray
    scored_exact: np.ndarray
    timed: np.ndarray


def contest(
    programs: Sequence[Program], trial: Trial, target: float, turns: int
) -> dict[str, Result]:
    """Results of all programs at the target error, measured alternately; medians."""
    chosen = {p.name: p.calibrate(trial.rehearsal, trial.rehearsal_exact, target) for p in programs}
    able = {p.name: p for p in programs if chosen[p.name] is not None}
    return {p.name: Result(p.name, None) for p in programs} | compare(able, chosen, trial, turns)


def compare(
    programs: Mapping[str, Program], settings: Mapping[str, Any], trial: Trial, turns: int
) -> dict[str, Result]:
    """Results of programs at given settings: errors on held-out starts, and alternating times."""
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
    """Median processor and wall-clock seconds of several works, measured alternately."""
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
