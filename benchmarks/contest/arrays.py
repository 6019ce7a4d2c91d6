"""JAX: the order-8 method by hand over whole arrays, and diffrax's Dopri8 mapped over starts."""

from __future__ import annotations

from typing import Any

import numpy as np

from .bodies import Body
from .compiled import step_counts
from .generated import defined, field_text, step_text
from .programs import Program, Run

__all__ = ["diffrax_adaptive", "jax_fixed"]


def _jax() -> Any:
    import jax

    jax.config.update("jax_enable_x64", True)
    return jax


def jax_fixed(body: Body, until: float) -> Program:
    """Equal steps in a compiled loop; a column of an array for each trajectory."""
    jax = _jax()
    names: dict[str, Any] = {"sqrt": jax.numpy.sqrt}
    names["field"] = defined(field_text(body), names)["field"]
    step = defined(step_text(body.size, errors=False), names)["step"]

    @jax.jit
    def march(columns: Any, steps: Any) -> Any:
        h = until / steps
        return jax.lax.fori_loop(0, steps, lambda _, x: step(h, *x), columns)

    def build(steps: float) -> Run:
        def run(starts: np.ndarray) -> np.ndarray:
            return np.array(march(tuple(starts.T), int(steps))).T

        return run

    return Program("JAX, equal steps", build, step_counts())


def diffrax_adaptive(body: Body, until: float) -> Program:
    """Dopri8 with diffrax's own control of steps."""
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
