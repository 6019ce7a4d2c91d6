"""heyoka: one motion at a time, and its batch mode with a loop of our own over blocks.

Its tolerance affects only the order, so there is one tolerance for each order.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from copy import deepcopy
from functools import lru_cache
from typing import Any

import heyoka as hy
import numpy as np

from .bodies import Body, rows
from .programs import Program, Run

__all__ = [
    "batch",
    "batch_section",
    "batch_tangent",
    "forget",
    "scalar",
    "scalar_section",
    "scalar_tangent",
    "thirty",
    "variants",
]

#: Largest tolerance for each order.
ORDERS = tuple(math.exp(2 * (1 - order)) * 1.0001 for order in range(7, 21))
WIDE_ORDERS = tuple(math.exp(2 * (1 - order)) * 1.0001 for order in range(32, 38))
RISING = hy.event_direction.positive


def forget() -> None:
    """Disable the disk cache of compiled code, so that compilation is measured."""
    hy.llvm_state.set_diskcache_enabled(False)


def scalar(body: Body, until: float, **options: Any) -> Program:
    """One trajectory after another; the options are those of the integrator of heyoka."""

    def build(tolerance: float) -> Run:
        motion = hy.taylor_adaptive(body.taylor, [1.0] * body.size, tol=tolerance, **options)

        def run(starts: np.ndarray) -> np.ndarray:
            ends = np.empty_like(starts)
            for start, end in zip(starts, ends, strict=True):
                motion.time, motion.state[:] = 0.0, start
                motion.propagate_until(until)
                end[:] = motion.state
            return ends

        return run

    return Program(f"heyoka{_said(options)}", build, ORDERS, _compact(scalar, body, until))


def batch(body: Body, until: float, lanes: int = 8, threads: int = 1, **options: Any) -> Program:
    """Blocks of trajectories, distributed over threads; lanes that end early wait."""

    def build(tolerance: float) -> Run:
        first = hy.taylor_adaptive_batch(
            body.taylor, np.ones((body.size, lanes)), tol=tolerance, **options
        )
        motions = [first, *(deepcopy(first) for _ in range(threads - 1))]

        def part(motion: Any, starts: np.ndarray, ends: np.ndarray) -> None:
            for block in _blocks(motion, starts, lanes):
                motion.propagate_until(until)
                ends[block] = motion.state[:, : len(starts[block])].T

        def run(starts: np.ndarray) -> np.ndarray:
            ends = np.empty_like(starts)
            share = -(-len(starts) // (threads * lanes)) * lanes
            parts = [slice(i * share, (i + 1) * share) for i in range(threads)]
            work = (motions, [starts[p] for p in parts], [ends[p] for p in parts])
            list(map(part, *work) if threads == 1 else _pool(threads).map(part, *work))
            return ends

        return run

    name = f"heyoka, batch of {lanes}{_said(options)}"
    name += f", {threads} threads" if threads > 1 else ""
    return Program(name, build, ORDERS, _compact(scalar, body, until))


def _blocks(motion: Any, starts: np.ndarray, lanes: int) -> Iterator[slice]:
    """Blocks of starts, each written to the state of a batch at time zero."""
    size = starts.shape[1]
    for begin in range(0, len(starts), lanes):
        block = slice(begin, begin + lanes)
        motion.set_time(0.0)
        motion.state[:size, : len(starts[block])] = starts[block].T
        yield block


@lru_cache
def _pool(threads: int) -> ThreadPoolExecutor:
    return ThreadPoolExecutor(threads)


# --- crossings of γ₃ = 0 -------------------------------------------------------------------


def scalar_section(body: Body, until: float, **options: Any) -> Program:
    """Events of one trajectory after another."""

    def build(tolerance: float) -> Run:
        found: list[np.ndarray] = []

        def seen(motion: Any, time: float, _: int) -> None:
            motion.update_d_output(time)
            found.append(motion.d_output.copy())

        event = hy.nt_event(body.height, seen, direction=RISING)
        motion = hy.taylor_adaptive(
            body.taylor, [1.0] * body.size, tol=tolerance, nt_events=[event], **options
        )

        def run(starts: np.ndarray) -> np.ndarray:
            points = []
            for start in starts:
                found.clear()
                motion.time, motion.state[:] = 0.0, start
                motion.propagate_until(until)
                points.append(np.array(found))
            return rows(points, body.size)

        return run

    return Program(
        f"heyoka, events{_said(options)}", build, ORDERS, _compact(scalar_section, body, until)
    )


def batch_section(body: Body, until: float, lanes: int = 8, **options: Any) -> Program:
    """Events of a batch."""

    def build(tolerance: float) -> Run:
        found: list[list[np.ndarray]] = [[] for _ in range(lanes)]

        def seen(motion: Any, time: float, _: int, lane: int) -> None:
            motion.update_d_output(np.full(lanes, time))
            found[lane].append(motion.d_output[:, lane].copy())

        event = hy.nt_event_batch(body.height, seen, direction=RISING)
        motion = hy.taylor_adaptive_batch(
            body.taylor, np.ones((body.size, lanes)), tol=tolerance, nt_events=[event], **options
        )

        def run(starts: np.ndarray) -> np.ndarray:
            points: list[np.ndarray] = []
            for block in _blocks(motion, starts, lanes):
                for lane in found:
                    lane.clear()
                motion.propagate_until(until)
                points += [np.array(lane) for lane in found[: len(starts[block])]]
            return rows(points, body.size)

        return run

    return Program(
        f"heyoka, events in batch of {lanes}{_said(options)}",
        build,
        ORDERS,
        _compact(scalar_section, body, until),
    )


# --- tangent vectors -----------------------------------------------------------------------


def scalar_tangent(body: Body, until: float, **options: Any) -> Program:
    """State and derivative with respect to the start, from the variational system of heyoka."""
    identity = np.eye(body.size).ravel()

    def build(tolerance: float) -> Run:
        motion = hy.taylor_adaptive(_varied(body), [1.0] * body.size, tol=tolerance, **options)

        def run(starts: np.ndarray) -> np.ndarray:
            ends = np.empty((len(starts), body.size + len(identity)))
            for start, end in zip(starts, ends, strict=True):
                motion.time = 0.0
                motion.state[: body.size], motion.state[body.size :] = start, identity
                motion.propagate_until(until)
                end[:] = motion.state
            return ends

        return run

    return Program(f"heyoka, variational{_said(options)}", build, ORDERS)


def batch_tangent(body: Body, until: float, lanes: int = 8, **options: Any) -> Program:
    """The same in batches."""
    identity = np.eye(body.size).ravel()[:, None]

    def build(tolerance: float) -> Run:
        motion = hy.taylor_adaptive_batch(
            _varied(body), np.ones((body.size, lanes)), tol=tolerance, **options
        )

        def run(starts: np.ndarray) -> np.ndarray:
            ends = np.empty((len(starts), body.size + len(identity)))
            for block in _blocks(motion, starts, lanes):
                motion.state[body.size :] = identity
                motion.propagate_until(until)
                ends[block] = motion.state[:, : len(starts[block])].T
            return ends

        return run

    return Program(
        f"heyoka, variational, batch of {lanes}{_said(options)}",
        build,
        ORDERS,
        _compact(scalar_tangent, body, until),
    )


def _varied(body: Body) -> Any:
    return hy.var_ode_sys(body.taylor, hy.var_args.vars, order=1)


# --- 30 digits -----------------------------------------------------------------------------


def thirty(body: Body, until: float) -> Program:
    """Numbers of 34 digits (the full compilation of the unbalanced ball takes minutes)."""
    wide = hy.real128

    def build(tolerance: float) -> Run:
        motion = hy.taylor_adaptive(
            body.taylor, [wide(1)] * body.size, tol=wide(tolerance), fp_type=wide, compact_mode=True
        )

        def run(starts: np.ndarray) -> np.ndarray:
            ends = []
            for start in starts:
                motion.time, motion.state[:] = wide(0), start.astype(wide)
                motion.propagate_until(wide(until))
                ends.append(motion.state.copy())
            return np.array(ends)

        return run

    return Program("heyoka, 34 digits", build, WIDE_ORDERS)


def _compact(make: Callable[..., Program], body: Body, until: float) -> Callable[[float], Run]:
    """Program with the same steps and a short compilation."""

    def build(tolerance: float) -> Run:
        return make(body, until, compact_mode=True).build(tolerance)

    return build


_WORDS = {"compact_mode": "compact", "fast_math": "fast", "high_accuracy": "accurate"}


def _said(options: dict[str, Any]) -> str:
    """Text of options."""
    return "".join(f", {_WORDS[key]}" for key, value in options.items() if value)


def variants(
    make: Callable[..., Program], body: Body, until: float, choices: Sequence[dict[str, Any]]
) -> list[Program]:
    """Programs for several choices of options."""
    return [make(body, until, **options) for options in choices]
