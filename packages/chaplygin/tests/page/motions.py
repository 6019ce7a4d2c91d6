"""Motions as Python computes them, to compare with those of pages."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np

import chaplygin as ch
from chaplygin.page.page_systems import page_system
from chaplygin.page.wasm_module import TOLERANCE
from flowlanes.flow.batch import batch_integrator

EXAMPLES = Path(__file__).parents[4] / "examples"

#: States agree to this share of their size, or to so many roundings times their growth.
CLOSE, ROUNDINGS = 1e-12, 4


@cache
def study_of(name):
    if name.endswith(".toml"):
        return ch.Study.from_experiment(ch.load_experiment(EXAMPLES / name))
    return ch.Study.from_experiment(ch.parse_experiment(f'system = {{name = "{name}"}}'))


def whole_system(study):
    system = page_system(study)
    return system.lifted() if system.reconstruction else system


def motion_in_python(study, times):
    """The states, and how far a change of the start in its last digit moves them."""
    backward = study.experiment.run.direction == "backward"
    start = np.array([float(x) for x in study.start])
    flow = batch_integrator(whole_system(study), tolerance=TOLERANCE, backward=backward)
    nudged = replace_relations(flow)
    starts = np.stack([start, start * (1 + 2.0**-52)])
    moments = -times if backward else times
    run = nudged.propagate(starts, moments)
    return run.states[0], np.abs(run.states[1] - run.states[0]).max(axis=1), run


def rounding_growth(study, states, times):
    """How far roundings so far may have moved each of the states, which follow the start.

    The rounding of one state, times the sum over earlier times s of the norms of the tangent map
    from s to t, by differences of neighbouring motions.
    """
    backward = study.experiment.run.direction == "backward"
    system = whole_system(study)
    flow = replace_relations(batch_integrator(system, tolerance=TOLERANCE, backward=backward))
    size, count = np.abs(states).max(), states.shape[1]
    nearby = 1e-7 * size * np.eye(count)
    growth = np.ones(len(states))
    for k, state in enumerate(states[:-1]):
        later = np.concatenate([[0.0], times])[k + 1 : len(states)] - (times[k - 1] if k else 0.0)
        starts = np.concatenate([state + nearby, state - nearby])
        run = flow.propagate(starts, -later if backward else later)
        maps = (run.states[:count] - run.states[count:]) / (2e-7 * size)
        growth[k + 1 :] += np.linalg.norm(maps.transpose(1, 0, 2), 2, axis=(1, 2))
    return 2.0**-52 * size * growth[1:]


def allowed_difference(study, times, expected, moved):
    """By how much two computations of the states may differ, at each time.

    1e-12 of their size; more where rounding grows to more: no more than a few roundings times the
    growth of what they change, nor than a hundred times what the last digit of the start does.
    """
    start = np.array([[float(x) for x in study.start]])
    size = np.abs(expected).max(initial=1e-300)
    nudged = 100 * np.maximum.accumulate(moved[: len(expected)])
    if not np.any(nudged > CLOSE * size):
        return np.full(len(expected), CLOSE * size)
    grown = rounding_growth(study, np.concatenate([start, expected]), times)
    grown = ROUNDINGS * np.maximum.accumulate(np.nan_to_num(grown, nan=np.inf))
    return np.maximum(CLOSE * size, np.minimum(nudged, grown))


def motion_by_series(study, times):
    """The states by Taylor series, as far as they go."""
    system = page_system(study)
    sign = -1.0 if study.experiment.run.direction == "backward" else 1.0
    try:
        motion = ch.integrate(system, list(study.start), [0.0, *(sign * times)])
    except ch.RunError as error:
        motion = error.partial
    reached = np.isin(np.abs(np.asarray(motion.times, float)), times)
    return np.asarray(motion.states, dtype=np.float64)[reached]


def replace_relations(flow):
    """The same flow, which asks for no relations: a last digit more or less is on none."""
    return replace(flow, system=replace(flow.system, relations=()))
