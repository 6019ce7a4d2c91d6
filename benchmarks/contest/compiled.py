"""numba: the order-8 method as a compiled loop, with fixed steps and with error control."""

from __future__ import annotations

from typing import Any

import numpy as np

from .bodies import Body
from .generated import defined, field_text, step_text
from .programs import TOLERANCES, Program, Run

__all__ = ["numba_adaptive", "numba_fixed", "step_counts"]


def step_counts(fewest: int = 32) -> tuple[float, ...]:
    """Numbers of steps to choose from, each 6 % more than the one before."""
    return tuple(float(round(fewest * 1.06**k)) for k in range(70))


_FIXED = """
def march(starts, until, steps):
    ends = np.empty_like(starts)
    h = until / steps
    for n in range(len(starts)):
        {state} = starts[n]
        for _ in range(steps):
            {state} = step(h, {state})
        ends[n] = {state}
    return ends
"""

_ADAPTIVE = """
def march(starts, until, tolerance):
    ends = np.empty_like(starts)
    for n in range(len(starts)):
        {state} = starts[n]
        t, h = 0.0, 0.01
        while t < until:
            h = min(h, until - t)
            {next}, {third}, {fifth} = step(h, {state})
            three, five = 0.0, 0.0
            for x, y, a, b in (({rows})):
                scale = tolerance * (1.0 + max(abs(x), abs(y)))
                three += (a / scale) ** 2
                five += (b / scale) ** 2
            error = 0.0
            if five > 0.0:
                error = five / sqrt((five + 0.01 * three) * {size})
            if error < 1.0:
                t += h
                {state} = {next}
            h *= min(6.0, max(0.333, 0.9 * error ** -0.125)) if error > 0.0 else 6.0
        ends[n] = {state}
    return ends
"""


def numba_fixed(body: Body, until: float) -> Program:
    """Equal steps, their number being the setting."""
    march = _compiled(body, _FIXED, errors=False)

    def build(steps: float) -> Run:
        def run(starts: np.ndarray) -> np.ndarray:
            return np.asarray(march(starts, until, int(steps)))

        return run

    return Program("numba, equal steps", build, step_counts(), share=0.5)


def numba_adaptive(body: Body, until: float) -> Program:
    """Error control as in SciPy's DOP853."""
    march = _compiled(body, _ADAPTIVE, errors=True)

    def build(tolerance: float) -> Run:
        def run(starts: np.ndarray) -> np.ndarray:
            return np.asarray(march(starts, until, tolerance))

        return run

    return Program("numba, error control", build, TOLERANCES, share=0.5)


def _compiled(body: Body, text: str, errors: bool) -> Any:
    import numba

    jit = numba.njit(error_model="numpy", fastmath={"contract"})
    names: dict[str, Any] = {"np": np, "sqrt": np.sqrt}
    names["field"] = jit(defined(field_text(body), names)["field"])
    names["step"] = jit(defined(step_text(body.size, errors), names)["step"])
    each = range(body.size)
    words = {letter: ", ".join(f"{letter}{i}" for i in each) for letter in "xyab"}
    rows = "), (".join(f"x{i}, y{i}, a{i}, b{i}" for i in each)
    written = text.format(
        state=words["x"],
        next=words["y"],
        third=words["a"],
        fifth=words["b"],
        rows=rows,
        size=body.size,
    )
    return jit(defined(written, names)["march"])
