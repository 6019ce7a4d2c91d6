"""Programs of this engine."""

from __future__ import annotations

import heyoka as hy
import numpy as np

from flowlanes import batch_integrator, gauss_integrator, poincare_section

from .bodies import Body
from .programs import Program, Run

__all__ = ["NAME", "crossings", "ensemble", "single", "tangents", "thirty"]

NAME = "chaplygin"


def ensemble(body: Body, until: float, threads: int = 1) -> Program:
    """One lane for each trajectory."""

    def build(tolerance: float) -> Run:
        made = batch_integrator(body.system, tolerance=tolerance)

        def run(starts: np.ndarray) -> np.ndarray:
            return np.asarray(made.propagate(starts, [until], threads=threads).states[:, -1])

        return run

    return Program(NAME if threads == 1 else f"{NAME}, {threads} threads", build)


def crossings(body: Body, until: float, most: int) -> Program:
    """Crossings of γ₃ = 0 with increasing γ₃; no trajectory has more than `most` of them."""
    where = poincare_section(body.system, body.system.symbols[-1])

    def build(tolerance: float) -> Run:
        made = batch_integrator(body.system, tolerance=tolerance, section=where)

        def run(starts: np.ndarray) -> np.ndarray:
            return np.asarray(made.crossings(starts, most, t_end=until, threads=1).states)

        return run

    return Program(NAME, build)


def tangents(body: Body, until: float) -> Program:
    """State and derivative with respect to the start, as tangent vectors in lanes."""
    identity = np.eye(body.size)

    def build(tolerance: float) -> Run:
        made = batch_integrator(body.system, tolerance=tolerance, deviations=body.size)

        def run(starts: np.ndarray) -> np.ndarray:
            carried = np.repeat(identity[None], len(starts), axis=0)
            found = made.propagate(starts, [until], deviations=carried, threads=1)
            # a row for each component, as in heyoka
            slopes = np.swapaxes(found.deviations[:, -1], 1, 2).reshape(len(starts), -1)
            return np.hstack([found.states[:, -1], slopes])

        return run

    return Program(NAME, build)


def single(body: Body, until: float) -> Program:
    """Collocation with one lane for each stage; the only setting is the number of digits."""

    def build(_: float) -> Run:
        made = gauss_integrator(body.system, body.starts(0, 1)[0])

        def run(starts: np.ndarray) -> np.ndarray:
            return np.asarray(made.propagate(starts, [until], threads=1).states[:, -1])

        return run

    return Program(NAME, build, (16.0,))


def thirty(body: Body, until: float) -> Program:
    """The same with two doubles for each number."""

    def build(_: float) -> Run:
        made = gauss_integrator(body.system, body.starts(0, 1)[0], precision="quad")

        def run(starts: np.ndarray) -> np.ndarray:
            found = made.propagate(starts, [until], threads=1)
            high, low = (part[:, -1].astype(hy.real128) for part in (found.states, found.rest))
            return np.asarray(high + low)

        return run

    return Program(NAME, build, (30.0,))
