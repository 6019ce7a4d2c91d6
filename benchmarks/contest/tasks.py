"""The five tasks for a body, with exact results and programs."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from importlib.util import find_spec

import numpy as np

from . import arrays, compiled, interpreted, ours, rigid, taylor
from .bodies import Body, deviation
from .programs import TOLERANCES, Program, Result, Trial, compare, contest

__all__ = ["QUICK", "TASKS", "THOROUGH", "Effort", "Outcome", "Task", "ball"]

#: Seeds of the starts for the choice of settings, for errors and for times.
REHEARSED, SCORED, TIMED = 1, 2, 3
FAST: Mapping[str, bool] = {"fast_math": True}
COMPACT: Mapping[str, bool] = {"compact_mode": True}


@dataclass(frozen=True)
class Effort:
    """Amount of measurement.

    Attributes
    ----------
    states, few : int
        Number of starts with exact results for the choice of settings, and the same number for
        errors; `few` for tasks with expensive exact results.
    many : int
        Number of starts of a timed ensemble.
    turns : int
        Number of alternating repetitions for medians.
    thorough : bool
        True for all variants of every program, False for the known best ones.
    """

    states: int
    few: int
    many: int
    turns: int
    thorough: bool

    def long(self, body: Body) -> float:
        """Duration of single motions."""
        return body.long if self.thorough else min(body.long, 200.0)


QUICK = Effort(states=5, few=2, many=320, turns=3, thorough=False)
THOROUGH = Effort(states=16, few=4, many=1024, turns=5, thorough=True)


@dataclass(frozen=True)
class Outcome:
    """Results of one task, body and target.

    Attributes
    ----------
    each : float
        Divisor of times: number of section points, seconds of a rolling ball, or 1.
    rival : str
        Program with which this engine is compared.
    """

    task: str
    body: str
    target: float
    results: Mapping[str, Result]
    each: float = 1.0
    rival: str = "heyoka"

    @property
    def own(self) -> Result:
        """Result of this engine."""
        return self.results[ours.NAME]

    @property
    def best(self) -> Result:
        """Best result of the rival on one thread."""
        rivals = [
            r
            for name, r in self.results.items()
            if name.startswith(self.rival) and "threads" not in name
        ]
        return min((r for r in rivals if np.isfinite(r.core)), key=lambda r: r.core)

    @property
    def ratio(self) -> float:
        """Ratio of the best time of the rival to that of this engine."""
        return self.best.core / self.own.core


@dataclass(frozen=True)
class Task:
    """One kind of task, for every body."""

    name: str
    targets: Sequence[float]
    run: Callable[[Body, float, Effort], Outcome]


def ensemble(body: Body, target: float, effort: Effort) -> Outcome:
    """Final states of many motions."""
    trial = _trial(body, effort.states, effort.many, lambda x: body.ends(x, body.span))
    rivals = [taylor.batch(body, body.span), taylor.batch(body, body.span, **FAST)]
    if effort.thorough:
        rivals += [
            taylor.batch(body, body.span, 4, **FAST),
            taylor.batch(body, body.span, 16, **FAST),
            taylor.batch(body, body.span, **COMPACT),
            taylor.batch(body, body.span, high_accuracy=True),
            _part(taylor.scalar(body, body.span), 0.2),
            _part(taylor.scalar(body, body.span, **FAST), 0.2),
            taylor.batch(body, body.span, threads=2, **FAST),
            ours.ensemble(body, body.span, threads=2),
            *_others(body),
        ]
    programs = [ours.ensemble(body, body.span), *rivals]
    return Outcome("ensemble", body.name, target, contest(programs, trial, target, effort.turns))


def by_hand(body: Body, target: float, effort: Effort) -> Outcome:
    """The same, with hand-written loops whose median and worst errors are as small."""
    trial = _trial(body, max(effort.states, 16), effort.many, lambda x: body.ends(x, body.span))
    own, other = ours.ensemble(body, body.span), compiled.numba_fixed(body, body.span)
    starts, exact = trial.rehearsal, trial.rehearsal_exact
    setting = own.calibrate(starts, exact, target)
    assert setting is not None
    worst = float(np.nanmax(deviation(own.ready(setting, starts)(starts), exact)))
    steps = other.calibrate(starts, exact, target, worst)
    settings = {own.name: setting} | ({} if steps is None else {other.name: steps})
    able = {program.name: program for program in (own, other) if program.name in settings}
    results = compare(able, settings, trial, effort.turns)
    return Outcome("numba", body.name, target, results, rival="numba")


def _others(body: Body) -> list[Program]:
    """SciPy, and numba, JAX and diffrax if they are installed."""
    made = [interpreted.scipy_method(body, body.span, name) for name in ("DOP853", "LSODA")]
    if find_spec("numba"):
        made += [compiled.numba_fixed(body, body.span), compiled.numba_adaptive(body, body.span)]
    if find_spec("jax"):
        made.append(arrays.jax_fixed(body, body.span))
    if find_spec("diffrax"):
        made.append(arrays.diffrax_adaptive(body, body.span))
    return made


def ball(body: Body, effort: Effort) -> Outcome:
    """Rolling ball in a program for rigid bodies, and one and many motions of this engine."""
    until = body.short
    trial = _trial(body, effort.few, 0, lambda x: body.ends(x, until))
    programs = {"chaplygin, one motion": ours.single(body, until)}
    settings = {"chaplygin, one motion": 16.0}
    for step in (5e-3, 1e-3, 2e-4):
        name = f"MuJoCo, steps of {1e3 * step:g} ms"
        programs[name], settings[name] = rigid.mujoco_ball(body, until), step
    alone = compare(programs, settings, trial, effort.turns)
    many = _trial(body, effort.few, effort.many, lambda x: body.ends(x, until))
    own = {ours.NAME: ours.ensemble(body, until)}
    together = compare(own, {ours.NAME: TOLERANCES[6 * 8]}, many, effort.turns)
    return Outcome("ball", body.name, np.nan, alone | together, each=until)


def single(body: Body, target: float, effort: Effort) -> Outcome:
    """Final state of one long motion, as accurate as possible in doubles."""
    until = effort.long(body)
    trial = _trial(body, effort.few, 0, lambda x: body.ends(x, until))
    programs = [ours.single(body, until), taylor.scalar(body, until)]
    if effort.thorough:
        programs += [
            taylor.scalar(body, until, **FAST),
            taylor.scalar(body, until, high_accuracy=True),
        ]
    for rival in programs[1:]:
        rival.settings = taylor.ORDERS[-4:-1]  # rounding dominates
    return Outcome("single", body.name, target, _finest(programs, trial, target, effort.turns))


def section(body: Body, target: float, effort: Effort) -> Outcome:
    """Crossings of γ₃ = 0 with increasing γ₃."""
    trial = _trial(body, effort.states, effort.many, lambda x: body.crossings(x, body.span))
    points = np.isfinite(trial.scored_exact[:, :, 0]).sum(axis=1)
    programs = [
        ours.crossings(body, body.span, most=64),
        taylor.batch_section(body, body.span),
    ]
    if effort.thorough:
        programs.append(taylor.batch_section(body, body.span, **FAST))
        programs.append(_part(taylor.scalar_section(body, body.span), 0.2))
    results = contest(programs, trial, target, effort.turns)
    return Outcome("section", body.name, target, results, each=float(points.mean()))


def tangent(body: Body, target: float, effort: Effort) -> Outcome:
    """Final states of motions with six tangent vectors."""
    until = body.short
    trial = _trial(body, effort.few, effort.many, lambda x: body.tangents(x, until))
    programs = [
        ours.tangents(body, until),
        _part(taylor.batch_tangent(body, until, **COMPACT), 0.125),
    ]
    if effort.thorough:
        programs.append(_part(taylor.scalar_tangent(body, until, **COMPACT), 0.03))
    return Outcome("tangent", body.name, target, contest(programs, trial, target, effort.turns))


def digits30(body: Body, target: float, effort: Effort) -> Outcome:
    """Final state of one motion with 30 digits."""
    trial = _trial(body, effort.few, 0, lambda x: body.thirty(x, body.short))
    programs = [ours.thirty(body, body.short), taylor.thirty(body, body.short)]
    return Outcome("digits30", body.name, target, _finest(programs, trial, target, effort.turns))


def _finest(
    programs: Sequence[Program], trial: Trial, target: float, turns: int
) -> dict[str, Result]:
    """Programs at the target or, if no setting attains it, with the smallest error."""
    settings = {p.name: p.finest(trial.rehearsal, trial.rehearsal_exact, target) for p in programs}
    return compare({p.name: p for p in programs}, settings, trial, turns)


def _trial(body: Body, states: int, many: int, exact: Callable[[np.ndarray], np.ndarray]) -> Trial:
    rehearsal, scored = body.starts(REHEARSED, states), body.starts(SCORED, states)
    timed = body.starts(TIMED, many) if many else scored
    return Trial(rehearsal, exact(rehearsal), scored, exact(scored), timed)


def _part(program: Program, share: float) -> Program:
    """Slow program, timed on a fraction of the starts."""
    program.share = share
    return program


#: With two targets, the smaller ratio is reported.
TASKS = (
    Task("ensemble", (1e-10, 1e-12), ensemble),
    *((Task("numba", (1e-10, 1e-12), by_hand),) if find_spec("numba") else ()),
    Task("single", (1e-15,), single),
    Task("section", (1e-10, 1e-12), section),
    Task("tangent", (1e-10, 1e-12), tangent),
    Task("digits30", (1e-30,), digits30),
)
