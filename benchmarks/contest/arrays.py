"""JAX: the order-8 method written for whole arrays, and Dopri8 of diffrax mapped over starts."""

from __future__ import annotations

from typing import Any

import numpy as np

from flowlanes.flow.kernel.tableaux import explicit

from .bodies import Body
from .compiled import step_counts
from .generated import defined, field_text
from .programs import Program, Run

__all__ = ["diffrax_adaptive", "jax_fixed"]


def _jax() -> Any:
    import jax

    jax.config.update("jax_enable_x64", True)
    return jax


def jax_fixed(body: Body, until: float, block: int = 64) -> Program:
    """Equal steps in a compiled loop; a block of trajectories is one array (size, block).

    With a variable for each component it would be ten times slower.
    """
    jax = _jax()
    field = defined(field_text(body), {"sqrt": jax.numpy.sqrt})["field"]
    rows, weights = _weights()

    def step(state: Any, h: Any) -> Any:
        rates: list[Any] = []
        for row in rows:
            place = state + h * _combined(row, rates) if rates else state
            rates.append(jax.numpy.stack(field(*place)))
        return state + h * _combined(weights, rates)

    @jax.jit
    def march(blocks: Any, steps: Any) -> Any:
        h = until / steps

        def one(state: Any) -> Any:
            return jax.lax.fori_loop(0, steps, lambda _, x: step(x, h), state)

        return jax.lax.map(one, blocks)

    def build(steps: float) -> Run:
        def run(starts: np.ndarray) -> np.ndarray:
            count = len(starts)
            padded = np.resize(starts, (-(-count // block) * block, body.size))
            blocks = padded.reshape(-1, block, body.size).transpose(0, 2, 1)
            ends = np.asarray(march(blocks, int(steps)))
            return ends.transpose(0, 2, 1).reshape(-1, body.size)[:count]

        return run

    return Program("JAX, equal steps", build, step_counts())


def _weights() -> tuple[list[list[float]], list[float]]:
    table = explicit()
    return [[float(w) for w in row] for row in table.a], [float(w) for w in table.b]


def _combined(weights: list[float], rates: list[Any]) -> Any:
    return sum(w * rate for w, rate in zip(weights, rates, strict=True) if w)


def diffrax_adaptive(body: Body, until: float) -> Program:
    """Dopri8 with the step control of diffrax."""
    import diffrax

    jax = _jax()
    field = defined(field_text(body), {"sqrt": jax.numpy.sqrt})["field"]
    term = diffrax.ODETerm(lambda _, x, __: jax.numpy.stack(field(*x)))

    def march(start: Any, tolerance: Any) -> Any:
        found = diffrax.diffeqsolve(
            term,
            diffrax.Dopri8(),
            0.0,
            until,
            None,
            start,
            stepsize_controller=diffrax.PIDController(rtol=tolerance, atol=tolerance),
            max_steps=None,
            saveat=diffrax.SaveAt(t1=True),
        )
        return found.ys[0]

    mapped = jax.jit(jax.vmap(march, in_axes=(0, None)))

    def build(tolerance: float) -> Run:
        def run(starts: np.ndarray) -> np.ndarray:
            return np.asarray(mapped(starts, tolerance))

        return run

    return Program("diffrax Dopri8", build, share=0.25)
