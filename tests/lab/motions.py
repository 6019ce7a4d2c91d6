"""Motions as Python computes them, to compare with those of pages."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np

import chaplygin as ch
from chaplygin.flow.batch import batch_integrator
from chaplygin.lab.page_model import TOLERANCE
from chaplygin.lab.page_systems import page_system

EXAMPLES = Path(__file__).parents[2] / "examples"

#: States agree to this share of their size, times what a last digit of the start does.
CLOSE = 1e-12


@cache
def study_of(name):
    if name.endswith(".toml"):
        return ch.prepare(ch.load(EXAMPLES / name))
    return ch.prepare(ch.loads(f'system = {{name = "{name}"}}'))


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
